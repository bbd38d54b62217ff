// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/replay/parallel_views.h"

#include "integral/lightfield/image.h"
#include "integral/optics/lens_mapping.h"
#include "integral/replay/interpolate.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <stdexcept>

namespace integral {

namespace {

constexpr double whole = 1e-6; // of a pixel: so much off counts as a whole number

bool is_whole(double value) { return std::fabs(value - std::round(value)) < whole; }

/// Pixels to a lens along the film's rows and columns (lenticular: the second is 0).
Vec2 pixels_a_lens(const FrameMetadata& m)
{
    const Lattice lattice(m.sheet);
    const double p = m.sheet.pitch;
    if (m.sheet.arrangement == Arrangement::lenticular)
        return {p / std::fabs(lattice.across().x) / m.film.pixel_pitch.x, 0};
    return {p / m.film.pixel_pitch.x, lattice.row_spacing() / m.film.pixel_pitch.y};
}

/// One side of a film whose lenses are a whole number of pixels wide: every pixel has a lens and a place in it. A pixel on the
/// border of two lenses is the farther one's.
struct Side {
    int pixels; ///< a lens
    int border; ///< the first pixel that is not the first lens's
    int lens(int pixel) const { return pixel < border ? 0 : (pixel - border) / pixels + 1; }
    int place(int pixel) const { return pixel < border ? pixel - border + pixels : (pixel - border) % pixels; }
};

/// `first`: mm from the first lens's pole to the first pixel's centre, in the direction in which pixels are counted.
Side side_of(double first, double pixel_pitch, double pitch)
{
    return {int(std::lround(pitch / pixel_pitch)), int(std::ceil((0.5 * pitch - first) / pixel_pitch - whole))};
}

/// The geometry that both ways share.
class Lenses {
public:
    Lenses(const FrameMetadata& m, ViewGrid grid)
        : film(m.film), lattice(m.sheet), grid(grid), arrangement(m.sheet.arrangement), pitch(m.sheet.pitch),
          exact(views_are_exact(m, grid))
    {
        const bool lenticular = arrangement == Arrangement::lenticular;
        if (lenticular && !slit_is_horizontal(m.sheet))
            throw std::invalid_argument("the lenses lie across (slant beyond 45 degrees): there are no views from left to right");
        row = lattice.row_spacing();
        breadth = lenticular ? pitch / lattice.across().x : pitch;
        const LensIndex corner = lattice.nearest(point(0, 0));
        if (exact) {
            const Vec2 first = point(0, 0), pole = lattice.pole(corner);
            across = side_of(first.x - pole.x, film.pixel_pitch.x, pitch);
            window = {corner, across.lens(film.width - 1) + 1, film.height};
            if (!lenticular) {
                down = side_of(pole.y - first.y, film.pixel_pitch.y, pitch);
                window.rows = down.lens(film.height - 1) + 1;
            }
            return;
        }
        LensIndex least = corner, most = corner;
        const auto take = [&](int x, int y) {
            const LensIndex lens = lattice.nearest(point(x, y));
            least = {std::min(least.i, lens.i), std::min(least.j, lens.j)};
            most = {std::max(most.i, lens.i), std::max(most.j, lens.j)};
        };
        for (int x = 0; x < film.width; ++x)
            for (const int y : {0, film.height - 1})
                take(x, y);
        for (int y = 0; y < film.height; ++y)
            for (const int x : {0, film.width - 1})
                take(x, y);
        constexpr std::int64_t most_lenses = 1000000;
        if (most.i - least.i >= most_lenses || most.j - least.j >= most_lenses)
            throw std::invalid_argument("its film lies behind more than 1000000 lenses one way: they are much narrower than its pixels");
        const int lenses = int(most.i - least.i + 1);
        window = {{least.i, most.j}, arrangement == Arrangement::hexagonal ? 2 * lenses + 1 : lenses,
                  lenticular ? film.height : int(most.j - least.j + 1)};
    }

    Vec2 point(int x, int y) const { return film_from_pixel(film, {x + 0.5, y + 0.5}); }

    /// The lens of a view's pixel; and back, the first pixel of a lens (that a film pixel of row `film_row` lies behind).
    LensIndex lens_at(int column, int view_row) const
    {
        if (arrangement == Arrangement::lenticular)
            return {window.first.i + column, 0};
        const std::int64_t j = window.first.j - view_row;
        if (arrangement == Arrangement::square)
            return {window.first.i + column, j};
        const int shifted = column - int(j & 1);
        return {window.first.i + (shifted < 0 ? -1 : shifted / 2), j};
    }
    int column_of(LensIndex lens) const
    {
        const int i = int(lens.i - window.first.i);
        return arrangement == Arrangement::hexagonal ? 2 * i + int(lens.j & 1) : i;
    }
    int row_of(LensIndex lens, int film_row) const
    {
        return arrangement == Arrangement::lenticular ? film_row : int(window.first.j - lens.j);
    }

    /// The middle of a lens; of a lenticular one, where its axis crosses that row of the film.
    Vec2 middle(LensIndex lens, int film_row) const
    {
        const Vec2 pole = lattice.pole(lens);
        if (arrangement != Arrangement::lenticular)
            return pole;
        const Vec2 along = lattice.along();
        const double y = point(0, film_row).y;
        return {pole.x + (y - pole.y) / along.y * along.x, y};
    }
    /// A place in a lens, in parts of its width and height from its middle; and back.
    Vec2 film_point(Vec2 middle, Vec2 part) const
    {
        if (arrangement == Arrangement::lenticular)
            return {middle.x + part.x * breadth, middle.y};
        return middle + (part.x * breadth) * lattice.across() + (part.y * row) * lattice.along();
    }
    /// The place that view number k sees in every lens.
    Vec2 part_of_view(int k) const
    {
        return {0.5 - (k % grid.columns + 0.5) / grid.columns, 0.5 - (k / grid.columns + 0.5) / grid.rows};
    }
    Vec2 part_of(Vec2 middle, Vec2 film_point) const
    {
        const Vec2 off = film_point - middle;
        if (arrangement == Arrangement::lenticular)
            return {off.x / breadth, 0};
        return {dot(off, lattice.across()) / breadth, dot(off, lattice.along()) / row};
    }

    Film film;
    Lattice lattice;
    ViewGrid grid;
    Arrangement arrangement;
    double pitch, row, breadth;
    bool exact;
    Side across{}, down{};
    LensWindow window;
};

/// Exact views: which pixel of which view belongs to which pixel of the film.
class WholePixels {
public:
    explicit WholePixels(const Lenses& lenses) : lenses_(lenses)
    {
        for (int column = 0; column < lenses.grid.columns; ++column) {
            const int place = lenses.grid.columns - 1 - column;
            Run run{};
            run.film = (lenses.across.border + place) % lenses.across.pixels;
            run.view = lenses.across.lens(run.film);
            run.pixels = run.film < lenses.film.width ? (lenses.film.width - 1 - run.film) / lenses.across.pixels + 1 : 0;
            runs_.push_back(run);
        }
    }

    /// Calls move(view, its first pixel, the film's first pixel, how many, whether it is the lenses' last) for a row of the film, place after
    /// place in the lenses: pixels one after another in the view, a lens apart on the film.
    template <class Move> void each(int y, Move move) const
    {
        const bool lenticular = lenses_.arrangement == Arrangement::lenticular;
        const int row = lenticular ? y : lenses_.down.lens(y), up = lenticular ? 0 : lenses_.down.place(y);
        const std::size_t view_row = std::size_t(row) * lenses_.window.columns, film_row = std::size_t(y) * lenses_.film.width;
        for (int column = lenses_.grid.columns; column-- > 0;)
            move(up * lenses_.grid.columns + column, view_row + runs_[column].view, film_row + runs_[column].film, runs_[column].pixels, column == 0);
    }

    int lens() const { return lenses_.across.pixels; }

private:
    struct Run { int film, view, pixels; }; // first pixels in their rows
    const Lenses& lenses_;
    std::vector<Run> runs_;
};

/// Moves `count` pixels of a fixed size between a row of a view, where they follow each other, and the film, where they are `step`
/// bytes apart. Pixels of three bytes are moved in larger pieces, whose rest comes over pixels that are written later.
struct PixelMover {
    void (*gather)(unsigned char* view, const unsigned char* film, std::size_t step, int count);
    /// alone: no pixel behind these is written later.
    void (*scatter)(unsigned char* film, std::size_t step, const unsigned char* view, int count, bool alone);
    std::size_t bytes;
};

template <int bytes> void gather(unsigned char* view, const unsigned char* film, std::size_t step, int count)
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

template <int bytes> void scatter(unsigned char* film, std::size_t step, const unsigned char* view, int count, bool alone)
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

/// for_each_row by blocks of rows: moving a row takes less than handing it out, and threads then seldom write side by side.
bool for_each_block(int rows, int threads, const std::function<void(int row)>& work, const Progress& progress)
{
    constexpr int block = 64;
    return for_each_row((rows + block - 1) / block, threads, [&](int k) {
        for (int row = k * block; row < std::min(rows, (k + 1) * block); ++row)
            work(row);
    }, progress);
}

unsigned char* bytes_of(Image& image)
{
    return std::visit([](auto& samples) { return reinterpret_cast<unsigned char*>(samples.data()); }, image.samples);
}
const unsigned char* bytes_of(const Image& image) { return bytes_of(const_cast<Image&>(image)); }

} // namespace

ViewGrid natural_views(const FrameMetadata& m)
{
    const Vec2 pixels = pixels_a_lens(m);
    const auto count = [](double v) { return int(std::lround(std::clamp(v, 1.0, 1e9))); };
    return {count(pixels.x), count(pixels.y)};
}

bool views_are_exact(const FrameMetadata& m, ViewGrid grid)
{
    const Vec2 pixels = pixels_a_lens(m);
    const bool lenticular = m.sheet.arrangement == Arrangement::lenticular; // has no pixels a lens down
    const bool some = pixels.x > 0.5 && (lenticular || pixels.y > 0.5);     // nought is whole, too
    return some && m.sheet.arrangement != Arrangement::hexagonal && m.sheet.slant == 0 && m.film.subpixels == Subpixels::none && is_whole(pixels.x) && is_whole(pixels.y)
        && grid.columns == natural_views(m).columns && grid.rows == natural_views(m).rows;
}

LensWindow lens_window(const FrameMetadata& metadata) { return Lenses(metadata, natural_views(metadata)).window; }

std::optional<std::vector<Image>> parallel_views(const Frame& frame, ViewGrid grid, int threads, const Progress& progress)
{
    const Lenses lenses(*frame.metadata, grid);
    const Film& film = lenses.film;
    std::vector<Image> views(grid.count());
    for (Image& view : views)
        view = blank_like(frame.image, lenses.window.columns, lenses.window.rows);

    if (lenses.exact) {
        const WholePixels pixels(lenses);
        const PixelMover move = mover_for(frame.image);
        std::vector<unsigned char*> to;
        for (Image& view : views)
            to.push_back(bytes_of(view));
        const unsigned char* from = bytes_of(frame.image);
        const auto row = [&](int y) {
            pixels.each(y, [&](int view, std::size_t of_view, std::size_t of_film, int count, bool) {
                move.gather(to[view] + of_view * move.bytes, from + of_film * move.bytes, move.bytes * pixels.lens(), count);
            });
        };
        if (!for_each_block(film.height, threads, row, progress))
            return std::nullopt;
        return views;
    }

    const LinearReader light(frame.image);
    const auto work = [&](int row) {
        for (int column = 0; column < lenses.window.columns; ++column) {
            const Vec2 middle = lenses.middle(lenses.lens_at(column, row), row);
            for (int k = 0; k < grid.count(); ++k) {
                const Vec2 at = pixel_from_film(film, lenses.film_point(middle, lenses.part_of_view(k)));
                if (!(at.x >= 0 && at.y >= 0 && at.x < film.width && at.y < film.height))
                    continue;
                store_linear(views[k], column, row, each_channel(film.subpixels, [&](int channel) { return of_subpixels(light, film, at, channel); }));
            }
        }
    };
    if (!for_each_row(lenses.window.rows, threads, work, progress))
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
        const auto direction = direction_from_offset(medium, Vec2{0, 0} - lenses.film_point({0, 0}, lenses.part_of_view(k)));
        if (direction)
            eyes.push_back(Eye{-far * direction->x / direction->z, -far * direction->y / direction->z, far});
        else
            eyes.push_back(std::nullopt);
    }
    return eyes;
}

std::optional<Image> frame_from_views(const std::vector<Image>& views, const FrameMetadata& metadata, ViewGrid grid, int threads,
                                      const Progress& progress)
{
    const Lenses lenses(metadata, grid);
    const Film& film = lenses.film;
    if (int(views.size()) != grid.count())
        throw std::invalid_argument("there are " + std::to_string(views.size()) + " views, not " + std::to_string(grid.count()));
    for (const Image& view : views)
        if (view.width != lenses.window.columns || view.height != lenses.window.rows || !same_form(view, views[0]))
            throw std::invalid_argument("views of " + std::to_string(view.width) + "x" + std::to_string(view.height)
                                        + " pixels; this sheet and film have views of " + std::to_string(lenses.window.columns) + "x"
                                        + std::to_string(lenses.window.rows) + ", all of one form");
    Image image = blank_like(views[0], film.width, film.height);
    if (lenses.exact) {
        const WholePixels pixels(lenses);
        const PixelMover move = mover_for(image);
        unsigned char* to = bytes_of(image);
        std::vector<const unsigned char*> from;
        for (const Image& view : views)
            from.push_back(bytes_of(view));
        const auto row = [&](int y) {
            pixels.each(y, [&](int view, std::size_t of_view, std::size_t of_film, int count, bool last) {
                move.scatter(to + of_film * move.bytes, move.bytes * pixels.lens(), from[view] + of_view * move.bytes, count, last);
            });
        };
        if (!for_each_block(film.height, threads, row, progress))
            return std::nullopt;
        return image;
    }
    std::vector<LinearReader> light;
    for (const Image& view : views)
        light.emplace_back(view);
    const auto work = [&](int y) {
        for (int x = 0; x < film.width; ++x) {
            store_linear(image, x, y, each_channel(film.subpixels, [&](int channel) {
                const Vec2 point = film_from_pixel(film, subpixel_centre(film.subpixels, x, y, channel));
                const LensIndex lens = lenses.lattice.nearest(point);
                const Vec2 part = lenses.part_of(lenses.middle(lens, y), point);
                const int column = std::clamp(lenses.column_of(lens), 0, lenses.window.columns - 1), row = lenses.row_of(lens, y);
                return between((0.5 - part.x) * grid.columns - 0.5, (0.5 - part.y) * grid.rows - 0.5, grid.columns, grid.rows,
                               [&](int i, int j) { return light[j * grid.columns + i](column, row); });
            }));
        }
    };
    if (!for_each_row(film.height, threads, work, progress))
        return std::nullopt;
    return image;
}

} // namespace integral
