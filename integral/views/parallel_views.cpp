// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/views/parallel_views.h"

#include "integral/frame/image.h"
#include "integral/views/view_lenses.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <stdexcept>

namespace integral {

namespace {

/// Copies `count` pixels of a fixed size between a row of a view, where the pixels are adjacent,
/// and the film, where they are `step` bytes apart. A pixel of three bytes may be copied as four or
/// more: the surplus bytes fall on pixels that are written later.
struct PixelMover {
    void (*gather)(unsigned char* view, const unsigned char* film, std::size_t step, int count);
    /// `alone`: no later write covers surplus bytes, so none may be written.
    void (*scatter)(unsigned char* film, std::size_t step, const unsigned char* view, int count,
                    bool alone);
    std::size_t bytes;
};

template <int bytes>
void gather(unsigned char* view, const unsigned char* film, std::size_t step, int count)
{
    int k = 0;
#if defined(__BYTE_ORDER__) && __BYTE_ORDER__ == __ORDER_LITTLE_ENDIAN__
    if (bytes == 3 && step > 3)
        for (; k + 2 < count; k += 2, view += 6, film += 2 * step) { // two pixels as one number
            std::uint32_t first, second;
            std::memcpy(&first, film, 4);
            std::memcpy(&second, film + step, 4);
            const std::uint64_t both = (first & 0xffffff) | std::uint64_t(second) << 24;
            std::memcpy(view, &both, 8);
        }
#endif
    for (; k < count; ++k, view += bytes, film += step)
        std::memcpy(view, film, bytes);
}

template <int bytes>
void scatter(unsigned char* film, std::size_t step, const unsigned char* view, int count,
             bool alone)
{
    int k = 0;
    if (bytes == 3 && !alone)
        for (; k + 1 < count; ++k, film += step, view += 3)
            std::memcpy(film, view, 4);
    for (; k < count; ++k, film += step, view += bytes)
        std::memcpy(film, view, bytes);
}

template <int bytes> PixelMover mover() { return {gather<bytes>, scatter<bytes>, bytes}; }

PixelMover mover_for(const Image& image)
{
    switch (image.channels * (sample_bits(image) / 8)) {
    case 3: return mover<3>();
    case 4: return mover<4>();
    case 6: return mover<6>();
    case 8: return mover<8>();
    case 12: return mover<12>();
    default: return mover<16>();
    }
}

/// Maps pixels of exact views (views_are_exact) to pixels of the film.
class WholePixels {
public:
    explicit WholePixels(const Lenses& lenses) : lenses_(lenses)
    {
        for (int column = 0; column < lenses.grid.columns; ++column) {
            const int place = lenses.grid.columns - 1 - column;
            Run run{};
            run.film = (lenses.across.border + place) % lenses.across.pixels;
            run.view = lenses.across.lens(run.film);
            run.pixels = run.film < lenses.film.width
                             ? (lenses.film.width - 1 - run.film) / lenses.across.pixels + 1
                             : 0;
            runs_.push_back(run);
        }
    }

    /// For each place in the lenses along row y of the film, calls move(view, first pixel in the
    /// view, first pixel on the film, count, whether this is the last place). The pixels follow
    /// each other in the view and are a lens apart on the film.
    template <class Move> void each(int y, Move move) const
    {
        const int row = lenses_.down.lens(y), up = lenses_.down.place(y);
        const std::size_t view_row = std::size_t(row) * lenses_.window.columns,
                          film_row = std::size_t(y) * lenses_.film.width;
        for (int column = lenses_.grid.columns; column-- > 0;)
            move(up * lenses_.grid.columns + column, view_row + runs_[column].view,
                 film_row + runs_[column].film, runs_[column].pixels, column == 0);
    }

    /// Copies a row of a view from the film to `to`, which must be black, as a view may have pixels
    /// without film. `film` is the frame's first row.
    void gather_row(int view, int row, const PixelMover& move, const unsigned char* film,
                    unsigned char* to) const
    {
        const int up = view / lenses_.grid.columns;
        const int y = lenses_.down.border + (row - 1) * lenses_.down.pixels + up;
        if (y < 0 || y >= lenses_.film.height)
            return;
        const Run& run = runs_[std::size_t(view % lenses_.grid.columns)];
        const std::size_t first = std::size_t(y) * lenses_.film.width + run.film;
        move.gather(to + run.view * move.bytes, film + first * move.bytes, move.bytes * lens(),
                    run.pixels);
    }

    int lens() const { return lenses_.across.pixels; }

private:
    struct Run {
        int film, view, pixels;
    }; // the first pixel in the film's row and in the view's row; the number
    const Lenses& lenses_;
    std::vector<Run> runs_;
};

/// for_each_row by blocks of rows: copying a row takes less time than giving it to a thread, and
/// threads then seldom write to neighbouring bytes.
bool for_each_block(int rows, int threads, const std::function<void(int row)>& work,
                    const Progress& progress)
{
    constexpr int block = 64;
    return for_each_row((rows + block - 1) / block, threads,
                        [&](int k) {
                            for (int row = k * block; row < std::min(rows, (k + 1) * block); ++row)
                                work(row);
                        },
                        progress);
}

} // namespace

struct ParallelViews::State {
    State(const Frame& frame, ViewGrid grid)
        : image(frame.image), lenses(*frame.metadata, grid), move(mover_for(frame.image))
    {
        if (lenses.exact)
            pixels.emplace(lenses);
        else
            light.emplace(frame.image);
    }

    const Image& image;
    Lenses lenses;
    PixelMover move;
    std::optional<WholePixels> pixels; ///< of exact views (views_are_exact)
    std::optional<LinearReader> light; ///< of other views
};

ParallelViews::ParallelViews(const Frame& frame, ViewGrid grid)
    : state_(std::make_unique<State>(frame, grid))
{
}
ParallelViews::~ParallelViews() = default;

int ParallelViews::width() const { return state_->lenses.window.columns; }
int ParallelViews::height() const { return state_->lenses.window.rows; }

void ParallelViews::draw(int view, int row, Image& image, int x, int y) const
{
    const State& s = *state_;
    unsigned char* to = row_bytes(image, y) + s.move.bytes * x;
    std::memset(to, 0, s.move.bytes * width());
    if (s.pixels) {
        s.pixels->gather_row(view, row, s.move, row_bytes(s.image, 0), to);
        return;
    }
    for (int column = 0; column < width(); ++column)
        if (const auto color = view_pixel(s.lenses, *s.light, view, column, row))
            store_linear(image, x + column, y, *color);
}

std::optional<std::vector<Image>> parallel_views(const Frame& frame, ViewGrid grid, int threads,
                                                 const Progress& progress)
{
    const ParallelViews maker(frame, grid);
    std::vector<Image> views(grid.count());
    for (Image& view : views)
        view = blank_like(frame.image, maker.width(), maker.height());
    const auto row = [&](int y) {
        for (int k = 0; k < grid.count(); ++k)
            maker.draw(k, y, views[k], 0, y);
    };
    // Behind square and hexagonal lenses a row of all views takes many film rows: enough work.
    const bool done = grid.rows > 1 ? for_each_row(maker.height(), threads, row, progress)
                                    : for_each_block(maker.height(), threads, row, progress);
    if (!done)
        return std::nullopt;
    return views;
}

std::vector<std::optional<Eye>> far_eyes(const FrameMetadata& metadata, ViewGrid grid)
{
    constexpr double far = 1e9; // mm
    const Lenses lenses(metadata, grid);
    const Medium medium(metadata.sheet.thickness, metadata.sheet.ior);
    std::vector<std::optional<Eye>> eyes;
    for (int k = 0; k < grid.count(); ++k) {
        const auto direction = direction_from_offset(
            medium, Vec2{0, 0} - lenses.film_point({0, 0}, lenses.part_of_view(k)));
        if (direction)
            eyes.push_back(
                Eye{-far * direction->x / direction->z, -far * direction->y / direction->z, far});
        else
            eyes.push_back(std::nullopt);
    }
    return eyes;
}

namespace {

/// The first view. Throws std::invalid_argument unless there are grid.count() views, of one form
/// and of the window's size.
const Image& first_of(const std::vector<Image>& views, const Lenses& lenses)
{
    const int count = lenses.grid.count();
    if (int(views.size()) != count)
        throw std::invalid_argument("there are " + std::to_string(views.size()) + " views, not " +
                                    std::to_string(count));
    const LensWindow& window = lenses.window;
    for (const Image& view : views)
        if (view.width != window.columns || view.height != window.rows ||
            !same_form(view, views[0]))
            throw std::invalid_argument(
                "views of " + std::to_string(view.width) + "x" + std::to_string(view.height) +
                " pixels; this sheet and film have views of " + std::to_string(window.columns) +
                "x" + std::to_string(window.rows) + ", all of one form");
    return views[0];
}

} // namespace

struct FrameOfViews::State {
    State(const std::vector<Image>& views, const FrameMetadata& metadata, ViewGrid grid)
        : views(views), lenses(metadata, grid), move(mover_for(first_of(views, lenses)))
    {
        if (lenses.exact)
            pixels.emplace(lenses);
        else
            for (const Image& view : views)
                light.emplace_back(view);
    }

    /// Copies the pixels of exact views.
    void scatter_row(int row, unsigned char* to) const
    {
        const std::size_t begin = std::size_t(row) * lenses.film.width;
        pixels->each(
            row, [&](int view, std::size_t of_view, std::size_t of_film, int count, bool last) {
                move.scatter(to + (of_film - begin) * move.bytes, move.bytes * pixels->lens(),
                             row_bytes(views[std::size_t(view)], 0) + of_view * move.bytes, count,
                             last);
            });
    }

    /// Interpolates between views that are not exact.
    void interpolate_row(int row, Image& image, int y) const
    {
        const auto at = [&](int view, int column, int view_row) {
            return light[std::size_t(view)](column, view_row);
        };
        for (int x = 0; x < lenses.film.width; ++x)
            store_linear(image, x, y, film_pixel(lenses, x, row, at));
    }

    const std::vector<Image>& views;
    Lenses lenses;
    PixelMover move;
    std::optional<WholePixels> pixels; ///< of exact views
    std::vector<LinearReader> light;   ///< of others
};

FrameOfViews::FrameOfViews(const std::vector<Image>& views, const FrameMetadata& metadata,
                           ViewGrid grid)
    : state_(std::make_unique<State>(views, metadata, grid))
{
}
FrameOfViews::~FrameOfViews() = default;

bool FrameOfViews::draw(int first, Image& band, int threads, const Progress& progress) const
{
    const State& s = *state_;
    if (s.pixels)
        return for_each_block(
            band.height, threads, [&](int y) { s.scatter_row(first + y, row_bytes(band, y)); },
            progress);
    return for_each_row(
        band.height, threads, [&](int y) { s.interpolate_row(first + y, band, y); }, progress);
}

std::optional<Image> frame_from_parallel_views(const std::vector<Image>& views,
                                               const FrameMetadata& metadata, ViewGrid grid,
                                               int threads, const Progress& progress)
{
    const FrameOfViews frame(views, metadata, grid);
    Image image = blank_like(views[0], metadata.film.width, metadata.film.height);
    if (!frame.draw(0, image, threads, progress))
        return std::nullopt;
    return image;
}

} // namespace integral
