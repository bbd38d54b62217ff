// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/panel/panel_cards.h"

#include "integral/io/device_text.h"
#include "integral/optics/visual_pitch.h"
#include "integral/print/pitch_chart.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

namespace integral {
namespace {

Image filled(int width, int height, Colour colour)
{
    Image image = make_image<std::uint8_t>(width, height, 3, {});
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x)
            store_pixel(image, x, y, colour);
    return image;
}

constexpr Colour black{0, 0, 0, 1}, white{1, 1, 1, 1};

} // namespace

Colour view_number_colour(int view, int count)
{
    // Hues go once round the colour circle. None is dark, because numbers on it are black.
    constexpr double turn = 6.283185307179586;
    const auto channel = [&](int which) {
        return float(0.7 + 0.3 * std::cos(turn * (double(view) / count - which / 3.0)));
    };
    return {channel(0), channel(1), channel(2), 1};
}

std::vector<Image> view_number_card(int count, double aspect)
{
    constexpr int height = 300;
    const int width = std::clamp(int(std::lround(height * aspect)), 1, 100 * height);
    std::vector<Image> views;
    for (int view = 0; view < count; ++view) {
        Image picture = filled(width, height, view_number_colour(view, count));
        const std::string number = std::to_string(view);
        DeviceFont font{0.8 * std::min(width, height), true}; // size in pixels: a pixel is 1 mm
        font.size *= std::min(1.0, 0.8 * width / text_width(number, font));
        constexpr double half_a_figure = 0.36; // half the height of a digit, in em
        write_text(
            picture, {1, 1}, number,
            {0.5 * (width - text_width(number, font)), 0.5 * height + half_a_figure * font.size},
            font);
        views.push_back(std::move(picture));
    }
    return views;
}

std::vector<Image> crosstalk_card(int count, std::optional<int> lit)
{
    std::vector<Image> views;
    for (int view = 0; view < count; ++view)
        views.push_back(filled(2, 2, (lit ? view == *lit : view % 2 == 0) ? white : black));
    return views;
}

std::vector<Image> colour_card(int count, int lit)
{
    constexpr int band = 16;
    const Colour colours[] = {{1, 0, 0, 1}, {0, 1, 0, 1}, {0, 0, 1, 1}, white};
    std::vector<Image> views;
    for (int view = 0; view < count; ++view) {
        Image picture = filled(2, 4 * band, black);
        if (view == lit)
            for (int y = 0; y < picture.height; ++y)
                for (int x = 0; x < picture.width; ++x)
                    store_pixel(picture, x, y, colours[y / band]);
        views.push_back(std::move(picture));
    }
    return views;
}

Image pitch_card(const Panel& panel)
{
    PitchChart chart;
    chart.sheet = panel.sheet;
    chart.film = panel.film;
    chart.distances = {panel.aperture.distance};
    chart.panel = panel.name.empty() ? "unnamed panel" : panel.name;
    const double pitch = visual_pitch(panel.sheet.pitch, panel.sheet, panel.aperture.distance);
    const double length = std::min(panel.film.width * panel.film.pixel_pitch.x,
                                   panel.film.height * panel.film.pixel_pitch.y);
    constexpr double bands = 0.25;
    const double step = bands * pitch * pitch / length;
    // The largest odd number of bars that fits, so that the calibrated pitch is in the middle.
    constexpr int most_bars = 11, least_bars = 3;
    for (int bars = most_bars;; bars -= 2) {
        chart.scale = {pitch - step * (bars - 1) / 2, step, bars};
        try {
            return pitch_chart(chart);
        } catch (const std::invalid_argument&) {
            if (bars == least_bars)
                throw;
        }
    }
}

} // namespace integral
