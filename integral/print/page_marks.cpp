// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/print/page_marks.h"

#include <cmath>
#include <cstdlib>
#include <stdexcept>

namespace integral {
namespace {

constexpr double clear_of_picture = 1.5; // mm between the picture and its marks
constexpr double margin = 8;             // mm from the picture to the marks' far ends
constexpr double crop_mark = 5.5, shortest_crop_mark = 0.5, axis_mark = 2, long_axis_mark = 3.5,
                 registration_radius = 1.5; // mm
constexpr double apart = 1;    // mm between a registration mark and the middle axis's mark
constexpr int marked_lens = 5; // every fifth lens has a mark

/// The picture on the page, mm from the page's top left corner.
struct Box {
    double left, top, right, bottom;
};

Box box_of(const PixelRectangle& r, Vec2 pitch)
{
    return {r.x * pitch.x, r.y * pitch.y, (r.x + r.width) * pitch.x, (r.y + r.height) * pitch.y};
}

/// Whether a line from `left` to `right` at the height `cut` meets one of the pictures, or touches
/// it.
bool meets(const std::vector<Box>& pictures, double left, double right, double cut)
{
    constexpr double apart_from_picture = 0.2; // mm
    for (const Box& other : pictures)
        if (cut > other.top - apart_from_picture && cut < other.bottom + apart_from_picture &&
            right > other.left - apart_from_picture && left < other.right + apart_from_picture)
            return true;
    return false;
}

/// Adds the crop marks of picture number `own` at its edges to the left and right. Where another
/// picture is near, marks share the gap with that picture's; in a gap too narrow there are none.
/// `line` makes a line of two places across and one down.
template <class Line>
void add_crop_marks(std::vector<PageLine>& lines, const std::vector<Box>& pictures, std::size_t own,
                    std::initializer_list<double> cuts, Line line)
{
    const Box& picture = pictures[own];
    for (const double cut : cuts)
        for (const bool after : {false, true}) {
            double length = crop_mark;
            for (const Box& other : pictures) {
                const double gap = after ? other.left - picture.right : picture.left - other.right;
                const bool level = cut > other.top - clear_of_picture &&
                                   cut < other.bottom + clear_of_picture;
                if (level && gap >= 0)
                    length = std::min(length, 0.5 * gap - clear_of_picture);
            }
            if (length < shortest_crop_mark)
                continue;
            const double way = after ? 1 : -1,
                         from = (after ? picture.right : picture.left) + way * clear_of_picture;
            if (meets(pictures, std::min(from, from + way * length),
                      std::max(from, from + way * length), cut))
                continue;
            lines.push_back(line(from, from + way * length, cut));
        }
}

void add_crop_marks(std::vector<PageLine>& lines, const Page& page)
{
    std::vector<Box> upright, turned; // turned: down and across are exchanged
    for (const FrameOnPage& frame : page.frames) {
        const Box box = box_of(frame.picture, page.pixel_pitch);
        upright.push_back(box);
        turned.push_back({box.top, box.left, box.bottom, box.right});
    }
    for (std::size_t k = 0; k < page.frames.size(); ++k) {
        const Box cut = box_of(page.frames[k].trimmed, page.pixel_pitch);
        add_crop_marks(lines, turned, k, {cut.left, cut.right}, [](double a, double b, double x) {
            return PageLine{{x, a}, {x, b}};
        });
        add_crop_marks(lines, upright, k, {cut.top, cut.bottom}, [](double a, double b, double y) {
            return PageLine{{a, y}, {b, y}};
        });
    }
}

void add_registration_mark(std::vector<PageLine>& lines, Vec2 centre)
{
    constexpr int sides = 24;
    constexpr double turn = 6.28318530717958647692, arm = 1.6 * registration_radius;
    lines.push_back({{centre.x - arm, centre.y}, {centre.x + arm, centre.y}});
    lines.push_back({{centre.x, centre.y - arm}, {centre.x, centre.y + arm}});
    const auto at = [&](int k) {
        return Vec2{centre.x + registration_radius * std::cos(turn * k / sides),
                    centre.y + registration_radius * std::sin(turn * k / sides)};
    };
    for (int k = 0; k < sides; ++k)
        lines.push_back({at(k), at(k + 1)});
}

constexpr int most_marks = 10000; // on either side of the middle

/// Place of an edge of the picture. If `upright`: the upper (side 0) or lower edge, mm from the
/// page's top; else the left (side 0) or right edge, mm from the page's left edge.
double edge_of(const Box& picture, bool upright, int side)
{
    if (upright)
        return side ? picture.bottom : picture.top;
    return side ? picture.right : picture.left;
}

/// Adds marks along two opposite edges of the picture: the upper and the lower one if `upright`,
/// else the left and the right one. `axis` is a point on the middle lens's axis, `step` leads from
/// each marked axis to the next, `along` is the direction in which the axes run: all in mm of the
/// sheet (y upwards). `on_page` maps points of the sheet to the page.
template <class OnPage>
void add_axis_marks(std::vector<PageLine>& lines, const Box& picture, Vec2 axis, Vec2 step,
                    Vec2 along, bool upright, OnPage on_page)
{
    for (const int side : {0, 1}) {
        const double outwards = side ? 1 : -1,
                     edge = edge_of(picture, upright, side) + outwards * clear_of_picture;
        for (const int direction : {-1, 1})
            for (int k = direction < 0 ? -1 : 0;; k += direction) {
                if (std::abs(k) > most_marks)
                    throw std::invalid_argument("its lenses are too many for marks of their axes: "
                                                "they are much narrower than the picture");
                const Vec2 p = on_page(axis + double(k) * step),
                           q = on_page(axis + double(k) * step + along);
                const Vec2 way = q - p;
                // The axis's point at the height `level` of the page (if not upright: at that place
                // across).
                const auto at = [&](double level) {
                    return upright ? Vec2{p.x + way.x * (level - p.y) / way.y, level}
                                   : Vec2{level, p.y + way.y * (level - p.x) / way.x};
                };
                const Vec2 from = at(edge),
                           to = at(edge + outwards * (k == 0 ? long_axis_mark : axis_mark));
                const double place = upright ? from.x : from.y;
                if (place < (upright ? picture.left : picture.top) - 1e-9 ||
                    place > (upright ? picture.right : picture.bottom) + 1e-9) {
                    // The first marks of slanted axes may lie beyond either end of the edge. Once a
                    // mark lies beyond the end towards which the loop runs, so do all later marks.
                    const double next = upright
                                            ? on_page(axis + double(k + direction) * step).x - p.x
                                            : on_page(axis + double(k + direction) * step).y - p.y;
                    const bool leaving = next > 0
                                             ? place > (upright ? picture.right : picture.bottom)
                                             : place < (upright ? picture.left : picture.top);
                    if (leaving)
                        break;
                    continue;
                }
                lines.push_back({from, to});
            }
    }
}

/// Adds the marks of the lenses' axes along all edges that need them: two for lenticular sheets,
/// four for 2-D sheets.
void add_marks_of_axes(std::vector<PageLine>& lines, const Page& page, const FrameMetadata& m,
                       const Box& picture)
{
    const Lattice lattice(m.sheet);
    const Film& film = m.film;
    // Converts film mm to the frame's pixels, the page's pixels, and the printer's nominal mm.
    const auto on_page = [&](Vec2 point) {
        const Vec2 pixel = pixel_from_film(film, point);
        return Vec2{(pixel.x - page.part.x + page.x) * page.pixel_pitch.x,
                    (pixel.y - page.part.y + page.y) * page.pixel_pitch.y};
    };
    const Vec2 pole = lattice.pole(lattice.nearest({0, 0}));
    const double p = m.sheet.pitch;
    const bool upright = std::fabs(lattice.along().y) >= std::fabs(lattice.along().x);
    add_axis_marks(lines, picture, pole, (marked_lens * p) * lattice.across(), lattice.along(),
                   upright, on_page);
    if (m.sheet.arrangement == Arrangement::lenticular)
        return;
    // Neighbouring rows of hexagonal lenses are shifted, so that poles stand in columns only in
    // every second row.
    const double rows = m.sheet.arrangement == Arrangement::hexagonal ? 2 * marked_lens
                                                                      : marked_lens;
    add_axis_marks(lines, picture, pole, (rows * lattice.row_spacing()) * lattice.along(),
                   lattice.across(), !upright, on_page);
}

} // namespace

double marks_margin(const PageRequest& request)
{
    if (request.axis_marks && request.registration_marks)
        return margin + long_axis_mark;
    return request.crop_marks || request.registration_marks || request.axis_marks ? margin : 0;
}

std::vector<PageLine> page_marks(const Page& page, const FrameMetadata& m,
                                 const PageRequest& request)
{
    std::vector<PageLine> lines;
    const Vec2 pitch = page.pixel_pitch;
    const Box picture = box_of({page.x, page.y, page.part.width, page.part.height}, pitch);
    if (request.crop_marks)
        add_crop_marks(lines, page);
    if (request.registration_marks) {
        const double x = 0.5 * (picture.left + picture.right),
                     y = 0.5 * (picture.top + picture.bottom),
                     away = clear_of_picture + 1.6 * registration_radius +
                            (request.axis_marks ? long_axis_mark + apart : 0);
        for (const Vec2 centre : {Vec2{x, picture.top - away}, Vec2{x, picture.bottom + away},
                                  Vec2{picture.left - away, y}, Vec2{picture.right + away, y}})
            add_registration_mark(lines, centre);
    }
    if (request.axis_marks)
        add_marks_of_axes(lines, page, m, picture);
    return lines;
}

} // namespace integral
