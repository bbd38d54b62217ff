// SPDX-License-Identifier: AGPL-3.0-or-later
// The inner loop of interlacing through the optics of lenticular lenses. Along a row of the panel
// they show hardly more than one place from top to bottom, so that a few rows of the views, brought
// close together, serve all of it.
#ifndef INTEGRAL_OUTPUT_INTERLACE_RAYS_H
#define INTEGRAL_OUTPUT_INTERLACE_RAYS_H

#include <cstddef>
#include <cstdint>

namespace integral {

/// The 8-bit samples of a row of a panel.
struct RayRow {
    std::uint8_t* samples;
    int count;                           ///< of them
    const std::uint16_t *across, *x, *y; ///< of each, as in RayMapping
    std::uint32_t view_count;
    std::uint32_t width, height;         ///< of a view, pixels
    std::uint32_t first_line, last_line; ///< rows of a view that this row shows
    /// Row k of the views' pictures begins at lines + (k % lines_kept) line_step, as make_ray_line
    /// makes it of one view and, view_step bytes farther on, the next: the rows that this row of
    /// the panel shows are there. One more view_step and eight bytes may be read.
    const std::uint8_t* lines;
    std::size_t view_step, line_step;
};

constexpr std::uint32_t lines_kept = 4; ///< a power of two

/// Whether this machine has such a loop, and it can count such views' places.
bool has_ray_loop(std::uint32_t view_count, std::uint32_t width, std::uint32_t height,
                  std::size_t view_step);

/// The first samples of the row, and how many they are: a few may be left to be made one by one.
/// Only if has_ray_loop.
int interlace_ray_row(const RayRow& row, bool blend_views, bool blend_pixels);

/// to[2 i] = a[i], to[2 i + 1] = b[i]: a row of a picture with the one below it, where pixels are
/// blended; else a line is the row itself.
void make_ray_line(std::uint8_t* to, const std::uint8_t* a, const std::uint8_t* b,
                   std::size_t count);

} // namespace integral

#endif
