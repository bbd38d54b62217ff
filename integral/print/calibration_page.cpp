// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/print/calibration_page.h"

#include "integral/base/constants.h"
#include "integral/base/number_text.h"
#include "integral/io/device_text.h"

#include <algorithm>
#include <cmath>

namespace integral {
namespace {

/// Draws discs around a middle, the outermost first, black and white in turn.
void draw_discs(const Film& film, Vec2 middle, std::initializer_list<double> radii, Image& image)
{
    constexpr int parts = 4; // of a pixel, each way
    const Vec2 centre = pixel_from_film(film, middle), pitch = film.pixel_pitch;
    const double most = *radii.begin();
    const int left = std::max(0, int(centre.x - most / pitch.x) - 1),
              right = std::min(film.width, int(centre.x + most / pitch.x) + 2),
              top = std::max(0, int(centre.y - most / pitch.y) - 1),
              bottom = std::min(film.height, int(centre.y + most / pitch.y) + 2);
    for (int y = top; y < bottom; ++y)
        for (int x = left; x < right; ++x) {
            int white = 0;
            for (int k = 0; k < parts * parts; ++k) {
                const Vec2 from = {(x + (k % parts + 0.5) / parts - centre.x) * pitch.x,
                                   (y + (k / parts + 0.5) / parts - centre.y) * pitch.y};
                const double away = length(from);
                white += std::count_if(radii.begin(), radii.end(),
                                       [&](double radius) { return away < radius; }) %
                             2 ==
                         0;
            }
            const float light = float(white) / (parts * parts);
            store_linear(image, x, y, {light, light, light, 1});
        }
}

void draw_square(const BlackSquare& square, Image& image)
{
    for (int y = std::max(0, square.top); y < std::min(image.height, square.bottom); ++y)
        for (int x = std::max(0, square.left); x < std::min(image.width, square.right); ++x)
            store_pixel(image, x, y, {0, 0, 0, 1});
}

/// Draws a sine of light by fine lines across the lenses whose width changes along them.
void draw_sine(const Film& film, const CalibrationBand& band, double line_period, Image& image)
{
    constexpr double depth = 0.45;
    const Vec2 along{-band.wave.y, band.wave.x}, pitch = film.pixel_pitch;
    const double a = std::fabs(along.x) * pitch.x / 2 / line_period,
                 b = std::fabs(along.y) * pitch.y / 2 / line_period;
    for (int y = band.top; y < band.top + band.height; ++y)
        for (int x = band.left; x < band.left + band.width; ++x) {
            const Vec2 place = film_from_pixel(film, {x + 0.5, y + 0.5});
            const double share = 0.5 +
                                 depth * std::cos(2 * pi * dot(band.wave, place) / band.period);
            const float light = float(line_coverage(dot(along, place) / line_period, a, b, share));
            store_linear(image, x, y, {light, light, light, 1});
        }
}

std::string reading_command(const FrameMetadata& geometry, double distance)
{
    const Film& film = geometry.film;
    return "integral rectify --calibration PHOTO.jpg -o sheet.json " +
           sheet_options(geometry.sheet) + " " + film_option(film) + " --size " +
           std::to_string(film.width) + "x" + std::to_string(film.height) + " --distance " +
           with_digits(distance, 9);
}

/// Writes the heading in as large letters as it has room for.
void write_heading(const CalibrationLayout& layout, Vec2 pixel_pitch,
                   const std::vector<std::string>& texts, Image& image)
{
    constexpr double smallest = 1, line_share = 1.35; // mm; of a line's height to its letters
    std::vector<std::string> lines;
    DeviceFont font{2.2, false};
    for (;; font.size -= 0.1) {
        lines.clear();
        for (const std::string& text : texts)
            for (const std::string& line : wrapped(text, layout.field_width, font))
                lines.push_back(line);
        if (font.size <= smallest ||
            (double(lines.size()) + 0.5) * line_share * font.size < calibration_heading)
            break;
    }
    double baseline = layout.field_top - calibration_heading;
    for (const std::string& line : lines)
        write_text(image, pixel_pitch, line,
                   {layout.field_left, baseline += line_share * font.size}, font);
}

} // namespace

ChartPage calibration_page(FrameMetadata geometry, double distance)
{
    geometry = chart_geometry(geometry, distance);
    const CalibrationPage page{geometry.sheet, geometry.film, distance};
    const CalibrationLayout layout = calibration_layout(page);
    const Film& film = geometry.film;
    Image image = make_image<std::uint8_t>(film.width, film.height, 3, {});
    auto& samples = std::get<std::vector<std::uint8_t>>(image.samples);
    std::fill(samples.begin(), samples.end(), std::uint8_t(255));
    for (const CalibrationTarget& target : layout.targets)
        draw_discs(film, target.middle, {target_disc, target_ring, target.dot}, image);
    for (const BlackSquare& square : layout.squares)
        draw_square(square, image);
    for (const CodeSquare& square : layout.code)
        if (square.dot)
            draw_discs(film, square.middle, {code_dot}, image);
    for (const CalibrationBand& band : layout.bands)
        if (band.kind == BandKind::coarse)
            draw_sine(film, band, tint_period(page), image);
        else
            draw_lines(film, band, image);

    const std::string reading = "Read it by: " + reading_command(geometry, distance);
    write_heading(layout, film.pixel_pitch,
                  {"Print unscaled. Lay the lens sheet on the bands, and leave the squares free. "
                   "Photograph all four rings from about " +
                       with_digits(distance, 3) + " mm, slightly from one side, in even light.",
                   reading},
                  image);
    ChartPage made{{std::move(image), std::nullopt}, reading};
    set_metadata(made.frame, geometry);
    return made;
}

} // namespace integral
