// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/print/calibration_layout.h"

#include "integral/base/number_text.h"
#include "integral/optics/visual_pitch.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <zlib.h>

namespace integral {
namespace {

// Lengths in mm.
constexpr double margin = 4, corner = 14, gap = 2, about_square = 4.5;
constexpr double fringe = 9, fringe_height = 2 * fringe, wide_height = 4.5, group_gap = 0.5;
constexpr double group_height = fringe_height + wide_height + group_gap;
constexpr double least_length = 60; ///< of a band
constexpr int least_groups = 3, groups_per_leak = 5;
constexpr double least_pixels = 5; ///< of a beat line's period
constexpr std::array<double, 5> tints = {1, 0.75, 0.5, 0.25, 0};
constexpr std::size_t tint_sets = 2; ///< in a row, for sheets that cover one of them
constexpr double tint_pixels = 8;

/// The page's place in pixels and mm.
struct Raster {
    const Film& film;
    int column(double mm) const { return int(std::lround(mm / film.pixel_pitch.x)); }
    int row(double mm) const { return int(std::lround(mm / film.pixel_pitch.y)); }
    Vec2 point(double column, double row) const { return film_from_pixel(film, {column, row}); }
};

/// The strips between the targets: one along the page's width if `across`, else along its height.
void add_strip(const Raster& raster, bool across, double middle, double length,
               CalibrationLayout& layout)
{
    const double begin = margin + corner;
    const int count = std::max(2, int((length - 2 * begin) / about_square));
    const double side = (length - 2 * begin) / count;
    const auto along = [&](int k) {
        return across ? raster.column(begin + k * side) : raster.row(begin + k * side);
    };
    const auto away = [&](double mm) { return across ? raster.row(mm) : raster.column(mm); };
    const int low = away(middle - side), centre = away(middle), high = away(middle + side);
    for (int k = 0; k < count; ++k) {
        const int from = along(k), to = along(k + 1), a = k % 2 ? centre : low,
                  b = k % 2 ? high : centre;
        layout.squares.push_back(across ? BlackSquare{from, a, to, b}
                                        : BlackSquare{a, from, b, to});
        const auto middle_of = [&](int first, int second) {
            const double here = 0.5 * (from + to), there = 0.5 * (first + second);
            return across ? raster.point(here, there) : raster.point(there, here);
        };
        const bool is_low = k % 2 == 0;
        layout.code.push_back(
            {middle_of(is_low ? centre : low, is_low ? high : centre), middle_of(a, b), false});
        if (k > 0)
            layout.corners.push_back(across ? raster.point(from, centre)
                                            : raster.point(centre, from));
    }
}

/// Places a band at `begin` mm from the field's top (left) with `thick` mm; `from` and `length`:
/// along it, mm from the field's left (top).
void place_band(const CalibrationPage& page, const CalibrationLayout& layout, double begin,
                double thick, double from, double length, CalibrationBand& band)
{
    const double left = layout.field_left + (band.upright ? begin : from),
                 top = layout.field_top + (band.upright ? from : begin);
    set_rectangle(page.film, left, top, left + (band.upright ? thick : length),
                  top + (band.upright ? length : thick), band);
}

CalibrationBand lines(BandKind kind, int group, bool upright, double period, Vec2 wave,
                      double share)
{
    CalibrationBand band;
    band.kind = kind;
    band.group = group;
    band.period = period;
    band.wave = wave;
    band.upright = upright;
    band.halves = false;
    band.light_share = share;
    return band;
}

void add_group(const CalibrationPage& page, int group, double begin, double length,
               const ChartDirection& direction, CalibrationLayout& layout)
{
    const bool leak = group % groups_per_leak == groups_per_leak / 2;
    const Vec2 along{-direction.wave.y, direction.wave.x};
    const Vec2 wave = (1 / visual_pitch(page.sheet.pitch, page.sheet, page.distance)) *
                          direction.wave +
                      ((group % 2 ? -1 : 1) / fringe) * along; // cycles per mm
    CalibrationBand beat = lines(leak ? BandKind::leak : BandKind::beat, group, direction.upright,
                                 1 / integral::length(wave), (1 / integral::length(wave)) * wave,
                                 leak ? leak_line : 0.5);
    place_band(page, layout, begin, fringe_height, 0, length, beat);
    layout.bands.push_back(beat);
    const double last = begin + fringe_height;
    if (!leak) {
        CalibrationBand coarse = lines(BandKind::coarse, group, direction.upright,
                                       coarse_period(page.sheet), direction.wave, 0.5);
        place_band(page, layout, last, wide_height, 0, length, coarse);
        layout.bands.push_back(coarse);
        return;
    }
    const double patch = length / double(tint_sets * tints.size());
    for (std::size_t k = 0; k < tint_sets * tints.size(); ++k) {
        CalibrationBand tint = lines(BandKind::tint, group, direction.upright, tint_period(page),
                                     along, tints[k % tints.size()]);
        place_band(page, layout, last, wide_height, double(k) * patch, patch, tint);
        layout.bands.push_back(tint);
    }
}

/// Sets the dots: in a page's heading, numbers of more digits than these are read back with
/// another last one.
void set_code(const CalibrationPage& page, CalibrationLayout& layout)
{
    const LensSheet& sheet = page.sheet;
    const Film& film = page.film;
    std::string text;
    for (const double number :
         {sheet.pitch, sheet.thickness, sheet.ior, sheet.slant, page.distance, double(film.width),
          double(film.height), film.pixel_pitch.x, film.pixel_pitch.y})
        text += with_digits(number, 6) + " ";
    const auto sum = crc32(0, reinterpret_cast<const Bytef*>(text.data()), uInt(text.size()));
    for (std::size_t k = 0; k < layout.code.size(); ++k)
        layout.code[k].dot = sum >> k % 32 & 1;
}

void check(const CalibrationPage& page, const ChartDirection& direction)
{
    const double pitch = page.sheet.pitch;
    if (pitch > 4)
        throw std::invalid_argument("the calibration page is for pitches up to 4 mm; make a "
                                    "pitch chart (--chart)");
    if (pixel_along(direction.wave, page.film) * least_pixels > pitch)
        throw std::invalid_argument("lines " + with_decimals(pitch, 4) +
                                    " mm apart have less than 5 pixels; a finer printer is needed");
}

} // namespace

double tint_period(const CalibrationPage& page)
{
    const Vec2 wave = chart_directions(page.sheet)[0].wave;
    return tint_pixels * pixel_along({-wave.y, wave.x}, page.film);
}

double coarse_period(const LensSheet& sheet)
{
    constexpr double least = 6; // mm
    return (std::round(std::max(6.0, least / sheet.pitch)) + 0.5) * sheet.pitch;
}

CalibrationLayout calibration_layout(const CalibrationPage& page)
{
    if (page.sheet.arrangement != Arrangement::lenticular)
        throw std::invalid_argument(
            "the calibration page is for lenticular sheets; --chart measures others");
    const ChartDirection direction = chart_directions(page.sheet)[0];
    check(page, direction);
    CalibrationLayout layout;
    const Raster raster{page.film};
    const double width = page.film.width * page.film.pixel_pitch.x,
                 height = page.film.height * page.film.pixel_pitch.y, edge = margin + corner + gap;
    layout.field_left = edge;
    layout.field_top = edge + calibration_heading;
    layout.field_width = width - 2 * edge;
    layout.field_height = height - 2 * edge - calibration_heading;
    const double stack = direction.upright ? layout.field_width : layout.field_height,
                 length = direction.upright ? layout.field_height : layout.field_width;
    layout.groups = int(stack / group_height);
    if (layout.groups < least_groups || length < least_length) {
        const double more = std::max(least_groups * group_height - stack, least_length - length);
        throw std::invalid_argument("the page is too small for a calibration: " +
                                    with_decimals(more, 1) + " mm more are needed");
    }
    const double middle = margin + corner / 2;
    const std::array<Vec2, 4> places = {{{middle, middle},
                                         {width - middle, middle},
                                         {width - middle, height - middle},
                                         {middle, height - middle}}};
    for (int k = 0; k < 4; ++k)
        layout.targets[k] = {raster.point(raster.column(places[k].x), raster.row(places[k].y)),
                             k == 0 ? first_dot : other_dot};
    for (const double y : {middle, height - middle})
        add_strip(raster, true, y, width, layout);
    for (const double x : {middle, width - middle})
        add_strip(raster, false, x, height, layout);
    set_code(page, layout);
    const double spacing = stack / layout.groups;
    for (int group = 0; group < layout.groups; ++group)
        add_group(page, group, group * spacing, length, direction, layout);
    return layout;
}

} // namespace integral
