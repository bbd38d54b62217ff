// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/print/gang.h"

#include "integral/base/number_text.h"
#include "integral/frame/names.h"
#include "integral/optics/aperture.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <stdexcept>

namespace integral {
namespace {

/// The middle of a frame at a place, mm from the picture's top left corner (y upwards).
Vec2 middle_of(const Film& film, int x, int y)
{
    return {(x + 0.5 * film.width) * film.pixel_pitch.x,
            -(y + 0.5 * film.height) * film.pixel_pitch.y};
}

/// The lens at index (0, 0) of a frame at a place, mm from the picture's top left corner.
Vec2 first_lens(const FrameMetadata& frame, int x, int y)
{
    return middle_of(frame.film, x, y) + frame.sheet.offset;
}

/// From the nearest lens (axis) of a lattice to a point.
Vec2 error_at(const Lattice& lattice, Vec2 point)
{
    const Vec2 error = point - lattice.pole(lattice.nearest(point));
    return lattice.arrangement() == Arrangement::lenticular
               ? dot(error, lattice.across()) * lattice.across()
               : error;
}

/// The place of a frame at or just beyond (x, y), to the right and down, where its lenses are
/// nearest to the lattice's; of equal ones the first.
PixelRectangle settled(const FrameMetadata& frame, const Lattice& lattice, int x, int y)
{
    const Vec2 pixel = frame.film.pixel_pitch, cell = cell_extent(frame.sheet),
               lens = first_lens(frame, x, y);
    // Every phase of the lenses occurs among these pixels to the right and down.
    const int width = int(std::ceil(cell.x / pixel.x)) + 1,
              height = int(std::ceil(cell.y / pixel.y)) + 1;
    double least = 2 * lattice.pitch();
    int best_right = 0, best_down = 0;
    const auto consider = [&](int right, int down) {
        if (right < 0 || down < 0 || right >= width || down >= height)
            return;
        const double error = length(
            error_at(lattice, lens + Vec2{right * pixel.x, -down * pixel.y}));
        const double gain = least - error;
        const bool first = down < best_down || (down == best_down && right < best_right);
        if (gain < -lattice.tie_tolerance() || (gain < lattice.tie_tolerance() && !first))
            return;
        least = error;
        best_right = right;
        best_down = down;
    };
    if (lattice.arrangement() == Arrangement::lenticular) {
        for (int k = 0; k < width * height; ++k) // one of the two is 1
            consider(k % width, k / width);
    } else {
        const Vec2 half{0.5 * width * pixel.x, -0.5 * height * pixel.y};
        lattice.for_each_within(lens + half, length(half), [&](LensIndex index) {
            const Vec2 away = lattice.pole(index) - lens;
            consider(int(std::lround(away.x / pixel.x)), int(std::lround(-away.y / pixel.y)));
        });
    }
    return {x + best_right, y + best_down, frame.film.width, frame.film.height};
}

/// Fills the room row by row.
class Rows {
public:
    Rows(const GangRequest& request, const Lattice& lattice, Vec2 pixel)
        : room_(request.room),
          lattice_(lattice),
          gap_x_(int(std::ceil(request.gap / pixel.x - 1e-6))),
          gap_y_(int(std::ceil(request.gap / pixel.y - 1e-6)))
    {
    }

    /// The place of the next frame; empty if there is no room for it.
    std::optional<PixelRectangle> add(const FrameMetadata& frame)
    {
        PixelRectangle place = settled(frame, lattice_, x_, y_);
        if (place.x + place.width > room_.width && x_ > 0) {
            place = settled(frame, lattice_, 0, bottom_ + gap_y_);
            if (fits(place)) {
                y_ = bottom_ + gap_y_;
                ++count_;
            }
        }
        if (!fits(place))
            return std::nullopt;
        x_ = place.x + place.width + gap_x_;
        bottom_ = std::max(bottom_, place.y + place.height);
        return place;
    }

    int count() const { return count_; }

private:
    bool fits(const PixelRectangle& place) const
    {
        return place.x + place.width <= room_.width && place.y + place.height <= room_.height;
    }

    PixelSize room_;
    const Lattice& lattice_;
    int gap_x_, gap_y_;
    int x_ = 0, y_ = 0, bottom_ = 0, count_ = 1;
};

/// Moves the common sheet to the middle of the frames' errors; returns the largest that remains.
double centre_errors(Gang& gang, const std::vector<FrameMetadata>& frames, LensSheet& sheet)
{
    const Lattice lattice(sheet);
    std::vector<Vec2> errors;
    Vec2 low, high;
    for (std::size_t k = 0; k < gang.places.size(); ++k) {
        const PixelRectangle& place = gang.places[k];
        const Vec2 e = error_at(lattice, first_lens(frames[k % frames.size()], place.x, place.y));
        low = {std::min(low.x, e.x), std::min(low.y, e.y)};
        high = {std::max(high.x, e.x), std::max(high.y, e.y)};
        errors.push_back(e);
    }
    const Vec2 shift = 0.5 * (low + high);
    double largest = 0;
    for (const Vec2 e : errors)
        largest = std::max(largest, length(e - shift));
    sheet.offset = sheet.offset + shift;
    return largest;
}

std::string both(const std::string& what, double a, double b, const std::string& unit)
{
    return what + ": " + with_digits(a, 6) + " and " + with_digits(b, 6) + unit;
}

} // namespace

std::string sheet_difference(const FrameMetadata& a, const FrameMetadata& b)
{
    const LensSheet &s = a.sheet, &t = b.sheet;
    const Vec2 p = a.film.pixel_pitch, q = b.film.pixel_pitch;
    const auto differ = [](double x, double y) { return std::fabs(x - y) > 1e-9 * std::fabs(y); };
    if (a.projection || b.projection)
        return "a frame for a projection lens has no common sheet with others";
    if (s.arrangement != t.arrangement)
        return std::string("arrangement: ") + name_of(s.arrangement) + " and " +
               name_of(t.arrangement);
    const struct {
        const char* what;
        double a, b;
        const char* unit;
    } figures[] = {{"pitch", s.pitch, t.pitch, " mm"},
                   {"thickness", s.thickness, t.thickness, " mm"},
                   {"ior", s.ior, t.ior, ""},
                   {"slant", s.slant, t.slant, " degrees"},
                   {"pixel pitch across", p.x, q.x, " mm"},
                   {"pixel pitch down", p.y, q.y, " mm"}};
    for (const auto& [what, a_figure, b_figure, unit] : figures)
        if (differ(a_figure, b_figure))
            return both(what, a_figure, b_figure, unit);
    return "";
}

Gang gang(const std::vector<FrameMetadata>& frames, const GangRequest& request)
{
    Gang gang;
    gang.metadata = frames.at(0);
    LensSheet sheet = gang.metadata.sheet;
    sheet.offset = first_lens(frames[0], 0, 0);
    const Lattice lattice(sheet);
    const Vec2 pixel = gang.metadata.film.pixel_pitch;
    Rows rows(request, lattice, pixel);
    Film& film = gang.metadata.film;
    film.width = film.height = 0;
    while (request.fill || gang.places.size() < frames.size()) {
        const auto place = rows.add(frames[gang.places.size() % frames.size()]);
        if (!place)
            break;
        film.width = std::max(film.width, place->x + place->width);
        film.height = std::max(film.height, place->y + place->height);
        gang.places.push_back(*place);
    }
    if (gang.places.size() < frames.size())
        throw std::invalid_argument("the paper has room for " + std::to_string(gang.places.size()) +
                                    " of " + counted(int(frames.size()), "frame") +
                                    "; take larger or turned paper, a smaller --gap or no marks");
    gang.rows = rows.count();
    gang.largest_error = centre_errors(gang, frames, sheet);
    gang.metadata.sheet.offset = sheet.offset - middle_of(film, 0, 0);
    gang.metadata.placement.reset();
    return gang;
}

} // namespace integral
