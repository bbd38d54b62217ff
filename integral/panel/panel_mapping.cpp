// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/panel/panel_mapping.h"

#include "integral/frame/eye_place.h"

#include <algorithm>
#include <cmath>

namespace integral {
namespace {

constexpr double whole_range = 4294967296.0; // 2^32
constexpr int channels = 3;

/// The phase of a place, given as a part of the range, modulo 1.
std::uint32_t phase_of(double part)
{
    return std::uint32_t(std::uint64_t(std::llround((part - std::floor(part)) * whole_range)));
}

/// One side of a panel: the phases of its pixels' middles in the picture, and the number of pixels
/// before and after the picture. The picture's size is given as a part of the side.
struct PanelSide {
    std::vector<std::uint32_t> phases;
    int before = 0, after = 0;
};

PanelSide side_of(int count, bool flip, double size)
{
    PanelSide side;
    for (int pixel = 0; pixel < count; ++pixel) {
        const double part = part_of_picture((flip ? count - pixel - 0.5 : pixel + 0.5) / count,
                                            size);
        side.phases.push_back(phase_of(part));
        if (!(part >= 0 && part < 1))
            ++(2 * pixel < count ? side.before : side.after);
    }
    return side;
}

/// A table of 16-bit phases, one for each subpixel of a film.
PhaseTable table_for(const Film& film)
{
    PhaseTable table;
    table.rows = film.height;
    table.columns = film.width * channels;
    table.phase16.resize(std::size_t(table.rows) * table.columns);
    return table;
}

/// The upper 16 bits of the phase of a part of a range. Parts beyond the range's ends are clamped
/// to them; 65535, which marks unseen subpixels, becomes 65534.
std::uint16_t high_phase(double part)
{
    return std::uint16_t(std::clamp(std::floor(part * 65536), 0.0, 65534.0));
}

} // namespace

PhaseRow PhaseTable::row(int y) const
{
    const std::size_t at = std::size_t(y % rows) * columns;
    return {phase32.empty() ? nullptr : phase32.data() + at,
            phase16.empty() ? nullptr : phase16.data() + at, shift.empty() ? 0 : shift[y],
            columns == 1};
}

PanelMapping mapping_of(const LookingGlassCalibration& calibration, const FittedPicture& picture)
{
    // Each phase is computed in double precision by view_of_subpixel: no error adds up along a row.
    // Patterns of subpixel cells repeat after four rows at most.
    constexpr int kinds_of_rows = 4;
    PanelMapping mapping;
    mapping.width = calibration.width;
    mapping.height = calibration.height;
    const int columns = calibration.width * channels;
    mapping.across.rows = kinds_of_rows;
    mapping.across.columns = columns;
    for (int kind = 0; kind < kinds_of_rows; ++kind)
        for (int i = 0; i < columns; ++i)
            mapping.across.phase32.push_back(
                phase_of(view_of_subpixel(calibration, i / channels, kind, i % channels)));
    for (int row = 0; row < calibration.height; ++row)
        mapping.across.shift.push_back(
            phase_of(view_of_subpixel(calibration, 0, row, 0) -
                     view_of_subpixel(calibration, 0, row % kinds_of_rows, 0)));
    mapping.x.rows = 1;
    mapping.x.columns = columns;
    const PanelSide across = side_of(calibration.width, calibration.flip_x, picture.size.x);
    for (int i = 0; i < columns; ++i)
        mapping.x.phase32.push_back(across.phases[i / channels]);
    mapping.left = across.before;
    mapping.right = across.after;
    PanelSide down = side_of(calibration.height, calibration.flip_y, picture.size.y);
    mapping.y.rows = calibration.height;
    mapping.y.columns = 1;
    mapping.y.phase32 = std::move(down.phases);
    mapping.top = down.before;
    mapping.bottom = down.after;
    return mapping;
}

/// A mapping with room for every subpixel of the film, before any is mapped.
static PanelMapping empty_mapping(const Film& film, bool round_lenses)
{
    PanelMapping mapping;
    mapping.width = film.width;
    mapping.height = film.height;
    mapping.has_unseen = true;
    for (PhaseTable* table : {&mapping.across, &mapping.x, &mapping.y})
        *table = table_for(film);
    mapping.y_range.resize(std::size_t(film.height));
    if (round_lenses)
        mapping.up = table_for(film);
    return mapping;
}

std::optional<PanelMapping> mapping_of(const FrameMetadata& geometry, EyeGrid eyes, int threads,
                                       const Progress& progress, const FittedPicture& picture)
{
    const Film& film = geometry.film;
    const SheetOptics optics(geometry.sheet, geometry.aperture);
    const bool round_lenses = geometry.sheet.arrangement != Arrangement::lenticular,
               lie_across = lenses_lie_across(geometry.sheet);
    PanelMapping mapping = empty_mapping(film, round_lenses);
    const auto row = [&](int y) {
        const std::size_t begin = std::size_t(y) * film.width * channels,
                          end = begin + std::size_t(film.width) * channels;
        std::uint16_t least = 65535, greatest = 0;
        for (std::size_t i = begin; i < end; ++i) {
            const int x = int((i - begin) / channels), channel = int((i - begin) % channels);
            const auto seen = eye_place(
                optics, eyes,
                film_from_pixel(film, subpixel_centre(film.subpixels, x, y, channel)));
            mapping.across.phase16[i] = std::uint16_t(PanelMapping::unseen >> 16);
            if (!seen)
                continue;
            const Vec2 pixel = pixel_from_film(film, seen->place),
                       on_panel{pixel.x / film.width, pixel.y / film.height};
            if (picture.is_in_bar(on_panel))
                continue;
            const Vec2 at = picture.picture_place(on_panel);
            mapping.across.phase16[i] = high_phase(lie_across ? seen->eye.y : seen->eye.x);
            mapping.x.phase16[i] = high_phase(at.x);
            mapping.y.phase16[i] = high_phase(at.y);
            least = std::min(least, mapping.y.phase16[i]);
            greatest = std::max(greatest, mapping.y.phase16[i]);
            if (round_lenses)
                mapping.up.phase16[i] = high_phase(seen->eye.y);
        }
        mapping.y_range[std::size_t(y)] = {std::min(least, greatest), greatest};
    };
    if (!for_each_row(film.height, threads, row, progress))
        return std::nullopt;
    return mapping;
}

} // namespace integral
