// SPDX-License-Identifier: AGPL-3.0-or-later
// Tests halftones for lenses: their lines, what eyes see, that light is kept, and levels.
#include "integral/print/frame_print.h"
#include "integral/print/lens_halftone.h"

#include <boost/test/unit_test.hpp>

#include <algorithm>
#include <cmath>
#include <random>
#include <set>

using namespace integral;

BOOST_AUTO_TEST_SUITE(print_lens_halftone)

namespace {

FrameMetadata frame_of(Arrangement arrangement, double slant, const Film& film)
{
    FrameMetadata m;
    m.sheet.arrangement = arrangement;
    m.sheet.slant = slant;
    m.film = film;
    m.aperture.distance = 400;
    return m;
}

Film film_of(int width, int height, double dpi_x, double dpi_y)
{
    return {width, height, {25.4 / dpi_x, 25.4 / dpi_y}};
}

/// Random linear light around a mean, the same in every run.
Image noise(const Film& film, double mean)
{
    std::mt19937 random(7);
    Image image = make_image<float>(film.width, film.height, 3, {Encoding::Kind::linear, 1});
    for (int y = 0; y < film.height; ++y)
        for (int x = 0; x < film.width; ++x) {
            const auto light = [&] {
                return float(mean * (0.5 + double(random()) / 4294967296.0));
            };
            store_pixel(image, x, y, {light(), light(), light(), 1});
        }
    return image;
}

/// The halftone of a whole frame, in one channel or three.
Image halftoned(const FrameMetadata& m, const HalftoneSettings& settings, const Image& image)
{
    LensHalftone halftone(m, settings);
    Image dots = make_image<std::uint8_t>(m.film.width, m.film.height, settings.grey ? 1 : 3,
                                          Encoding());
    for (int y = 0; y < m.film.height; y += LensHalftone::block_rows) {
        const Image block = halftone.apply(
            rows_of(image, y, std::min(LensHalftone::block_rows, m.film.height - y)));
        for (int row = 0; row < block.height; ++row)
            std::copy_n(row_bytes(block, row), block.width * block.channels,
                        row_bytes(dots, y + row));
    }
    return dots;
}

int sample(const Image& image, int x, int y, int channel = 0)
{
    return row_bytes(image, y)[x * image.channels + channel];
}

double luminance_of(Colour c) { return 0.2126 * c.r + 0.7152 * c.g + 0.0722 * c.b; }

/// Linear light of an sRGB sample, by the standard's formula.
double light_of(int code)
{
    const double v = code / 255.0;
    return v <= 0.04045 ? v / 12.92 : std::pow((v + 0.055) / 1.055, 2.4);
}

} // namespace

namespace {

constexpr double radians = 3.14159265358979323846 / 180;

/// Distance in pixels, along a row or a column, from a pixel to the axis through another pixel
/// (dx columns and dy rows away). Down the film, the axis goes to the right for slant > 0.
double off_axis(int dx, int dy, double slant, const Film& film)
{
    const double right = std::sin(slant * radians) / film.pixel_pitch.x,
                 down = std::cos(slant * radians) / film.pixel_pitch.y;
    return std::fabs(dx * down - dy * right) / std::max(std::fabs(right), std::fabs(down));
}

const double slants[] = {0, 9.46, -9.46, 30, -44, 46, 63.4, -72, 88, 90, -90};
const Vec2 resolutions[] = {{600, 600}, {300, 600}, {1200, 600}};

} // namespace

BOOST_AUTO_TEST_CASE(lines_follow_the_lenses)
{
    for (const double slant : slants)
        for (const Vec2 dpi : resolutions)
            BOOST_TEST_CONTEXT("slant " << slant << ", dpi " << dpi.x << " x " << dpi.y)
            {
                const Film film = film_of(61, 53, dpi.x, dpi.y);
                const LensLines lines(frame_of(Arrangement::lenticular, slant, film).sheet, film);
                std::set<std::pair<int, int>> after; // each pixel follows one pixel only
                for (int y = 0; y < film.height; ++y)
                    for (int x = 0; x < film.width; ++x) {
                        for (const int steps : {-40, -2, -1, 1, 2, 40}) {
                            const auto p = lines.further({x, y}, steps);
                            BOOST_TEST(off_axis(p.x - x, p.y - y, slant, film) <= 1 + 1e-6);
                            BOOST_TEST(lines.line_of(p) == lines.line_of({x, y}));
                            const auto back = lines.further(p, -steps);
                            BOOST_TEST((back.x == x && back.y == y));
                        }
                        const auto next = lines.further({x, y}, 1);
                        BOOST_TEST(next.y >= y);
                        BOOST_TEST(after.insert({next.x, next.y}).second);
                    }
            }
}

BOOST_AUTO_TEST_CASE(light_does_not_leave_its_view)
{
    for (const double slant : slants)
        for (const Vec2 dpi : resolutions)
            BOOST_TEST_CONTEXT("slant " << slant << ", dpi " << dpi.x << " x " << dpi.y)
            {
                // Light on three pixels to each side of one axis.
                const Film film = film_of(61, 150, dpi.x, dpi.y);
                Image image = noise(film, 0.4);
                double light = 0;
                for (int y = 0; y < film.height; ++y)
                    for (int x = 0; x < film.width; ++x) {
                        if (off_axis(x - 30, y - 75, slant, film) > 3)
                            store_pixel(image, x, y, {0, 0, 0, 1});
                        light += luminance_of(stored_pixel(image, x, y));
                    }
                const Image dots = halftoned(frame_of(Arrangement::lenticular, slant, film), {},
                                             image);
                double dot_light = 0;
                bool inside = true;
                for (int y = 0; y < film.height; ++y)
                    for (int x = 0; x < film.width; ++x)
                        if (sample(dots, x, y) > 0) {
                            inside = inside && off_axis(x - 30, y - 75, slant, film) <= 4 + 1e-6;
                            dot_light += 1;
                        }
                BOOST_TEST(inside);
                BOOST_TEST(std::fabs(dot_light - light) <= 9); // a dot for each line
            }
}

BOOST_AUTO_TEST_CASE(each_view_keeps_its_light)
{
    const Film film = film_of(90, 400, 600, 600);
    for (const double mean : {0.004, 0.1, 0.5, 0.6})
        for (const int levels : {2, 3, 16}) {
            const Image image = noise(film, mean);
            const Image dots = halftoned(frame_of(Arrangement::lenticular, 0, film),
                                         {levels, false}, image);
            double whole = 0, of_dots = 0;
            for (int channel = 0; channel < 3; ++channel)
                for (int x = 0; x < film.width; ++x) {
                    double frame = 0, halftone = 0, greatest = 0;
                    for (int y = 0; y < film.height; ++y) {
                        const Colour c = stored_pixel(image, x, y);
                        frame += channel == 0 ? c.r : channel == 1 ? c.g : c.b;
                        halftone += light_of(sample(dots, x, y, channel));
                        if ((y + 1) % LensHalftone::block_rows == 0 || y + 1 == film.height)
                            greatest = std::max(greatest, std::fabs(frame - halftone));
                    }
                    // A dot's sample is rounded to 8 bits.
                    const double rounding = levels == 2 ? 1e-6 : 400 * 0.005;
                    BOOST_TEST(greatest <= 1.0 / (levels - 1) + rounding);
                    whole += frame;
                    of_dots += halftone;
                }
            BOOST_TEST(std::fabs(of_dots / whole - 1) < 0.02);
        }
}

BOOST_AUTO_TEST_CASE(grey_is_the_luminance)
{
    const Film film = film_of(60, 200, 600, 600);
    Image image = make_image<float>(film.width, film.height, 3, {Encoding::Kind::linear, 1});
    for (int y = 0; y < film.height; ++y)
        for (int x = 0; x < film.width; ++x)
            store_pixel(image, x, y, {0.9f, 0.2f, 0.5f, 1});
    const Image dots = halftoned(frame_of(Arrangement::lenticular, 0, film), {2, true}, image);
    double sum = 0;
    for (int y = 0; y < film.height; ++y)
        for (int x = 0; x < film.width; ++x)
            sum += sample(dots, x, y) / 255.0;
    BOOST_TEST(std::fabs(sum / (60 * 200) - (0.2126 * 0.9 + 0.7152 * 0.2 + 0.0722 * 0.5)) < 0.002);
}

BOOST_AUTO_TEST_CASE(grey_for_a_printer_of_colours)
{
    Image grey = make_image<std::uint8_t>(3, 2, 1, Encoding());
    for (int k = 0; k < 6; ++k)
        row_bytes(grey, k / 3)[k % 3] = k % 2 ? 255 : 0;
    const Image page = over_white(grey, 8);
    BOOST_TEST(page.channels == 3);
    for (int k = 0; k < 6; ++k)
        for (int channel = 0; channel < 3; ++channel)
            BOOST_TEST(sample(page, k % 3, k / 3, channel) == (k % 2 ? 255 : 0));
}

BOOST_AUTO_TEST_CASE(dots_have_the_levels_asked_for)
{
    const Film film = film_of(64, 64, 600, 600);
    for (const Arrangement arrangement :
         {Arrangement::lenticular, Arrangement::square, Arrangement::hexagonal})
        for (const int levels : {2, 4, 16}) {
            const Image dots = halftoned(frame_of(arrangement, 0, film), {levels, true},
                                         noise(film, 0.6));
            std::set<int> codes;
            for (int y = 0; y < film.height; ++y)
                for (int x = 0; x < film.width; ++x)
                    codes.insert(sample(dots, x, y));
            for (const int code : codes) {
                const double level = light_of(code) * (levels - 1);
                BOOST_TEST(std::fabs(level - std::round(level)) < 0.005 * (levels - 1));
            }
            BOOST_TEST(int(codes.size()) <= levels);
            BOOST_TEST(codes.size() >= 2u);
        }
    for (const int levels : {-1, 0, 1, 17})
        BOOST_CHECK_THROW(LensHalftone(frame_of(Arrangement::lenticular, 0, film), {levels, true}),
                          std::invalid_argument);
}

BOOST_AUTO_TEST_CASE(a_restart_begins_at_the_top)
{
    const Film film = film_of(50, 70, 600, 600);
    const Image image = noise(film, 0.5), block = rows_of(image, 0, LensHalftone::block_rows),
                end = rows_of(image, LensHalftone::block_rows, 70 - LensHalftone::block_rows);
    for (const Arrangement arrangement : {Arrangement::lenticular, Arrangement::square})
        for (const double slant : {0.0, 20.0, 80.0}) {
            LensHalftone halftone(frame_of(arrangement, slant, film), {2, false});
            const Image first = halftone.apply(block), last = halftone.apply(end);
            halftone.restart();
            BOOST_TEST((halftone.apply(block).samples == first.samples));
            BOOST_TEST((halftone.apply(end).samples == last.samples));
        }
}

BOOST_AUTO_TEST_CASE(an_eye_averages_over_neighbours)
{
    // 600 dpi, 400 mm, 3.08 mm of 1.6, worked out by hand: across the lenses a standard deviation
    // of 0.016508 mm, along them of 0.10947 mm and, for three tenths, 0.29600 mm.
    const Film film = film_of(40, 40, 600, 600);
    const SeenError upright(frame_of(Arrangement::lenticular, 0, film)),
        lying(frame_of(Arrangement::lenticular, 90, film));
    BOOST_TEST(upright.coupling(0, 0) == 1);
    for (const int sign : {-1, 1}) {
        BOOST_TEST(std::fabs(upright.coupling(sign, 0) - 0.1932) < 2e-4);
        BOOST_TEST(std::fabs(upright.coupling(0, sign) - 0.9706) < 2e-4);
        BOOST_TEST(std::fabs(upright.coupling(1, sign) - 0.1932 * 0.9706) < 2e-4);
        BOOST_TEST(std::fabs(lying.coupling(0, sign) - 0.1932) < 2e-4);
        BOOST_TEST(std::fabs(lying.coupling(sign, 0) - 0.9706) < 2e-4);
    }
}

BOOST_AUTO_TEST_CASE(sums_of_errors_by_definition)
{
    for (const double slant : {0.0, 25.0, -70.0}) {
        const Film film = film_of(23, 50, 600, 600);
        SeenError seen(frame_of(Arrangement::lenticular, slant, film));
        std::mt19937 random(3);
        std::vector<float> errors;
        for (int k = 0; k < film.width * film.height; ++k)
            errors.push_back(float(double(random()) / 4294967296.0 - 0.5));
        const auto rows_from = [&](int first, int count) {
            return std::vector<float>(errors.begin() + first * film.width,
                                      errors.begin() + (first + count) * film.width);
        };
        seen.begin(rows_from(0, 20), 20);
        seen.change(7, 11, 0.25f);
        errors[11 * film.width + 7] += 0.25f;
        seen.end();
        seen.begin(rows_from(20, 30), 30);
        seen.change(22, 0, -0.5f);
        errors[20 * film.width + 22] -= 0.5f;
        double worst = 0;
        for (int y = 20; y < 50; ++y)
            for (int x = 0; x < film.width; ++x) {
                double sum = 0;
                for (int v = 0; v < 50; ++v)
                    for (int u = 0; u < film.width; ++u)
                        sum += double(seen.coupling(u - x, v - y)) * errors[v * film.width + u];
                worst = std::max(worst, std::fabs(sum - seen.at(x, y - 20)));
            }
        BOOST_TEST(worst < 1e-4);
    }
}

BOOST_AUTO_TEST_CASE(behind_square_lenses_errors_go_to_all_sides_and_light_is_kept)
{
    const Film film = film_of(120, 120, 600, 600);
    const FrameMetadata m = frame_of(Arrangement::square, 0, film);
    for (const double mean : {0.02, 0.3, 0.6}) {
        const Image image = noise(film, mean);
        const Image dots = halftoned(m, {2, true}, image);
        double frame = 0, halftone = 0;
        for (int y = 0; y < film.height; ++y)
            for (int x = 0; x < film.width; ++x) {
                frame += luminance_of(stored_pixel(image, x, y));
                halftone += sample(dots, x, y) / 255.0;
            }
        // Only the last row's errors, of half a dot at most, go nowhere.
        BOOST_TEST(std::fabs(halftone - frame) <= 0.5 * film.width);
    }
    Image image = noise(film, 0.4);
    const Image before = halftoned(m, {}, image);
    store_pixel(image, 60, 60, {1, 1, 1, 1});
    const Image after = halftoned(m, {}, image);
    std::set<int> columns, rows;
    for (int y = 0; y < film.height; ++y)
        for (int x = 0; x < film.width; ++x)
            if (sample(before, x, y) != sample(after, x, y)) {
                columns.insert(x);
                rows.insert(y);
            }
    BOOST_TEST(columns.size() > 1u);
    BOOST_TEST(rows.size() > 1u);
}

BOOST_AUTO_TEST_SUITE_END()
