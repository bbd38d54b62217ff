// SPDX-License-Identifier: AGPL-3.0-or-later
// The views that a frame's lenses show, for measuring depth.
#include "integral/depth/view_set.h"

#include "integral/base/interrupt.h"
#include "integral/optics/lens_mapping.h"
#include "integral/views/view_lenses.h"

#include <algorithm>
#include <climits>
#include <cmath>
#include <stdexcept>
#include <string>

namespace integral {
namespace {

using Light = std::optional<std::array<float, 3>>;

/// The light that leaves a frame's lenses, interpolated between the pixels behind them.
class LensLight {
public:
    LensLight(const Frame& frame, const SheetOptics& optics, int threads, const Progress& progress)
        : frame_(frame), film_(frame.metadata->film), optics_(optics)
    {
        const auto& render = frame.metadata->render;
        const LensMapping mapping = render ? render->mapping : LensMapping::automatic;
        lens_of_.resize(std::size_t(film_.width) * film_.height, Lens{none, none});
        const auto row = [&](int y) {
            for (int x = 0; x < film_.width; ++x)
                if (const auto ray = optics.map(film_from_pixel(film_, {x + 0.5, y + 0.5}), mapping)
                                         .ray)
                    lens_of_[index(x, y)] = {int(ray->lens.i), int(ray->lens.j)};
        };
        if (!for_each_row(film_.height, threads, row, progress))
            throw Interrupted();
    }

    /// The light that an eye on the aperture's plane receives from a point of the sheet.
    Light seen(Vec2 point, Vec2 eye) const
    {
        LensIndex lens;
        const Vec3 direction{eye.x - point.x, eye.y - point.y, -optics_.aperture().distance};
        const Vec2 at = pixel_from_film(film_, optics_.film_point_seen(point, direction, &lens));
        if (film_.subpixels == Subpixels::none)
            return interpolated({at.x - 0.5, at.y - 0.5}, lens);
        std::array<float, 3> light{};
        for (int c = 0; c < 3; ++c) {
            const Vec2 shift = subpixel_shift(film_.subpixels, at, c);
            const Light colour = interpolated({at.x - 0.5 - shift.x, at.y - 0.5 - shift.y}, lens);
            if (!colour)
                return std::nullopt;
            light[std::size_t(c)] = (*colour)[std::size_t(c)];
        }
        return light;
    }

private:
    struct Lens {
        int i, j;
    };
    static constexpr int none = INT_MIN;

    std::size_t index(int x, int y) const { return std::size_t(y) * film_.width + x; }

    /// Whether a film pixel lies inside the film and shows light through `lens`.
    bool belongs(int x, int y, LensIndex lens) const
    {
        if (x < 0 || y < 0 || x >= film_.width || y >= film_.height)
            return false;
        const Lens& owner = lens_of_[index(x, y)];
        return owner.i == lens.i && owner.j == lens.j;
    }

    /// Interpolates between the four film pixels around a place, without other lenses' pixels.
    Light interpolated(Vec2 at, LensIndex lens) const
    {
        const int left = int(std::floor(at.x)), top = int(std::floor(at.y));
        const double right_part = at.x - left, low_part = at.y - top;
        std::array<double, 3> sum{};
        double weights = 0;
        for (int j = 0; j < 2; ++j)
            for (int i = 0; i < 2; ++i) {
                const double weight = (i ? right_part : 1 - right_part) *
                                      (j ? low_part : 1 - low_part);
                if (!(weight > 0) || !belongs(left + i, top + j, lens))
                    continue;
                const Colour c = stored_pixel(frame_.image, left + i, top + j);
                weights += weight;
                sum[0] += weight * c.r;
                sum[1] += weight * c.g;
                sum[2] += weight * c.b;
            }
        if (weights < least_weight)
            return std::nullopt;
        return std::array<float, 3>{float(sum[0] / weights), float(sum[1] / weights),
                                    float(sum[2] / weights)};
    }

    static constexpr double least_weight = 0.3;
    const Frame& frame_;
    Film film_;
    const SheetOptics& optics_;
    std::vector<Lens> lens_of_; ///< the lens of each film pixel
};

/// Eyes on the aperture's plane, as far apart as the images there of neighbouring film pixels;
/// farther if these would be too many.
struct Eyes {
    Vec2 spacing; ///< mm
    int columns = 1, rows = 1;
    Vec2 at(int column, int row) const
    {
        return {(column - 0.5 * (columns - 1)) * spacing.x, (row - 0.5 * (rows - 1)) * spacing.y};
    }
};

/// Throws if the film is smaller than a single lens: the geometry then belongs to another picture.
void check_lenses_on_film(const FrameMetadata& metadata)
{
    const ViewGrid lens = natural_views(metadata);
    if (lens.columns > metadata.film.width || lens.rows > metadata.film.height)
        throw std::invalid_argument("a lens is as large as " + std::to_string(lens.columns) + "x" +
                                    std::to_string(lens.rows) +
                                    " pixels, more than the whole film; give --sheet the "
                                    "geometry of this picture");
}

Eyes eyes_of(const FrameMetadata& metadata)
{
    static constexpr int most_a_side = 255;
    check_lenses_on_film(metadata);
    const LensSheet& sheet = metadata.sheet;
    const double distance = metadata.aperture.distance;
    const Vec2 zone = viewing_zone(sheet, metadata.aperture);
    const auto pixels = [&](double width, double pitch) {
        return micro_image_width(sheet, distance, width) / pitch;
    };
    // One eye fewer than a lens has pixels, so that each eye lies between two pixels of every lens.
    const auto count = [](double pixels) {
        return std::min(most_a_side, int(std::floor(pixels + 1e-6)) - 1);
    };
    const auto spacing = [](double zone, double pixels, int eyes) {
        return zone / (eyes < most_a_side ? pixels : eyes + 1);
    };
    Eyes eyes;
    const bool lie_across = lenses_lie_across(sheet);
    if (!lie_across) {
        const double across = pixels(zone.x, metadata.film.pixel_pitch.x);
        eyes.columns = count(across);
        eyes.spacing.x = spacing(zone.x, across, eyes.columns);
    }
    if (lie_across || sheet.arrangement != Arrangement::lenticular) {
        const double down = pixels(zone.y, metadata.film.pixel_pitch.y);
        eyes.rows = count(down);
        eyes.spacing.y = spacing(zone.y, down, eyes.rows);
    }
    if (std::max(eyes.columns, eyes.rows) < 2)
        throw std::invalid_argument(
            "its lenses have too few pixels for depth: 3 of the film are the least");
    return eyes;
}

/// Draws views of a sheet's lenses; turned (see ViewSet) if the lenses lie across.
class SheetViews {
public:
    SheetViews(const Frame& frame, int threads, const Progress& progress)
        : lenses(*frame.metadata, natural_views(*frame.metadata)),
          optics(frame.metadata->sheet, frame.metadata->aperture),
          light(frame, optics, threads, progress),
          hexagonal(lenses.arrangement == Arrangement::hexagonal)
    {
        width = lenses.lie_across ? lenses.window.rows
                : hexagonal       ? lenses.window.columns / 2
                                  : lenses.window.columns;
        height = lenses.lie_across ? lenses.window.columns : lenses.window.rows;
    }

    PixelPlaces places() const
    {
        const Vec2 first = middle(0, 0);
        const bool lenticular = lenses.arrangement == Arrangement::lenticular;
        const Vec2 down = lenticular ? middle(0, 1) - first : -lenses.row * lenses.lattice.along();
        return {first, middle(1, 0) - first, down};
    }

    DepthView blank_view(Vec2 shift) const
    {
        DepthView view;
        view.shift = shift;
        for (auto& channel : view.channels)
            channel.resize(std::size_t(width) * height);
        view.lit.resize(std::size_t(width) * height);
        return view;
    }

    void draw(DepthView& view, Vec2 eye, int row) const
    {
        std::size_t at = std::size_t(row) * width;
        for (int column = 0; column < width; ++column, ++at) {
            const Light seen = light.seen(middle(column, row), eye);
            view.lit[at] = seen ? 1 : 0;
            for (std::size_t c = 0; seen && c < 3; ++c)
                view.channels[c][at] = (*seen)[c];
        }
        if (hexagonal && is_shifted(row))
            move_half_a_pixel(view, row);
    }

    Lenses lenses;
    SheetOptics optics;
    LensLight light;
    bool hexagonal;
    int width = 0, height = 0;

private:
    bool is_shifted(int row) const { return (lenses.window.first.j - row) & 1; }

    /// The middle of the lens in a column and row.
    Vec2 middle(int column, int row) const
    {
        if (lenses.lie_across)
            return lenses.middle(lenses.lens_at(0, width - 1 - column), row, 0);
        const int first = hexagonal && is_shifted(row) ? 1 : 0;
        return lenses.middle(lenses.lens_at(hexagonal ? 2 * column + first : column, row), 0, row);
    }

    /// Resamples a row whose lenses stand half a lens to the right (every second row), by cubic
    /// interpolation, at the places of the other rows' lenses.
    void move_half_a_pixel(DepthView& view, int row) const
    {
        const auto at = [&](int column) {
            return std::size_t(row) * width + std::clamp(column, 0, width - 1);
        };
        for (auto* values : {&view.channels[0], &view.channels[1], &view.channels[2], &view.lit}) {
            std::vector<float> moved;
            const bool is_mask = values == &view.lit;
            for (int c = 0; c < width; ++c) {
                const float near = 0.5f * ((*values)[at(c - 1)] + (*values)[at(c)]),
                            far = 0.5f * ((*values)[at(c - 2)] + (*values)[at(c + 1)]);
                moved.push_back(is_mask ? (near == 1 && far == 1) : 1.125f * near - 0.125f * far);
            }
            std::copy(moved.begin(), moved.end(), values->begin() + std::ptrdiff_t(at(0)));
        }
    }
};

} // namespace

ViewSet view_set(const Frame& frame, int threads, const Progress& progress)
{
    const FrameMetadata& metadata = *frame.metadata;
    const Eyes eyes = eyes_of(metadata);
    const SheetViews sheet(frame, threads, piece_of(progress, 0, 2));
    ViewSet set;
    set.width = sheet.width;
    set.height = sheet.height;
    set.places = sheet.places();
    set.turned = sheet.lenses.lie_across;
    const double pixel = length(set.places.right),
                 spacing = set.turned ? eyes.spacing.y : eyes.spacing.x;
    set.scale = DepthScale{metadata.aperture.distance, spacing / pixel};
    // A disparity of 1 moves a point on the sheet by -eye / spacing, in pixel widths.
    const PixelPlaces steps{{0, 0}, set.places.right, set.places.down};
    std::vector<Vec2> from{{0, 0}};
    for (int row = 0; row < eyes.rows; ++row)
        for (int column = 0; column < eyes.columns; ++column)
            if (const Vec2 eye = eyes.at(column, row); length(eye) > 0)
                from.push_back(eye);
    const auto new_view = [&](Vec2 eye) {
        return sheet.blank_view(steps.pixel_at((-pixel / spacing) * eye));
    };
    set.middle = new_view({0, 0});
    for (std::size_t k = 1; k < from.size(); ++k)
        set.others.push_back(new_view(from[k]));
    const auto row = [&](int y) {
        for (std::size_t k = 0; k < from.size(); ++k)
            sheet.draw(k == 0 ? set.middle : set.others[k - 1], from[k], y);
    };
    if (!for_each_row(set.height, threads, row, piece_of(progress, 1, 2)))
        throw Interrupted();
    set.colours = set.middle.channels;
    return set;
}

} // namespace integral
