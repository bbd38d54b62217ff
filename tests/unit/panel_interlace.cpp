// SPDX-License-Identifier: AGPL-3.0-or-later
// Compares interlaced images, subpixel by subpixel, with the definition in double precision.
#include "integral/panel/interlace.h"
#include "integral/panel/interlace_rows.h"
#include "integral/views/perspective_views.h"

#include <boost/test/unit_test.hpp>

#include <algorithm>
#include <cmath>
#include <random>

using namespace integral;

BOOST_AUTO_TEST_SUITE(panel_interlace)

namespace {

template <class Sample> Image noise(int width, int height, unsigned seed, Encoding encoding = {})
{
    Image image = make_image<Sample>(width, height, 3, encoding);
    std::mt19937 random(seed);
    for (Sample& sample : std::get<std::vector<Sample>>(image.samples))
        sample = Sample(random());
    return image;
}

LookingGlassCalibration calibration(int width, int height)
{
    LookingGlassCalibration c;
    c.pitch = 52.58;
    c.slope = -7.162;
    c.center = 0.564;
    c.dpi = 283;
    c.width = width;
    c.height = height;
    return c;
}

/// Displays of every kind: slanted to either side, flipped or not, inverted or not, and with each
/// pattern of cells.
std::vector<LookingGlassCalibration> displays()
{
    std::vector<LookingGlassCalibration> all;
    const int sizes[][2] = {{64, 40}, {61, 37}, {3, 7}, {1, 1}, {1536, 5}};
    for (const auto& [width, height] : sizes)
        for (int kind = 0; kind < 8; ++kind) {
            LookingGlassCalibration c = calibration(width, height);
            c.slope = kind & 1 ? 5.3 : -7.162;
            c.flip_subpixels = kind & 4;
            c.flip_x = kind == 3;
            c.flip_y = kind == 5;
            all.push_back(c);
            c.cells.order = Subpixels::cells;
            c.cells.pattern = CellPattern(kind % 5);
            c.cells.number = kind % 5 == 4 ? 4 : 2;
            for (int cell = 0; cell < c.cells.number; ++cell)
                c.cells.cell[cell] = {Vec2{-0.3, 0.1 * cell}, Vec2{0.05 * cell, -0.25},
                                      Vec2{0.31, 0.2}};
            all.push_back(c);
        }
    return all;
}

double between(double at, double& weight, int count)
{
    const double cut = std::clamp(at, 0.0, count - 1.0),
                 left = std::min(std::floor(cut), std::max(0.0, count - 2.0));
    weight = cut - left;
    return left;
}

/// The value that a subpixel of a panel shows, computed in double precision. value(view, x, y)
/// gives the views' values.
template <class Value>
double shown(double view, double x, double y, int count, int width, int height, Blend blend,
             Value value)
{
    double weights[3] = {0, 0, 0}, left[3];
    const double at[3] = {view * count, x * width, y * height};
    const int sides[3] = {count, width, height};
    for (int axis = 0; axis < 3; ++axis) {
        const bool linear = (axis == 0 ? blend.views : blend.pixels) == Neighbours::linear;
        left[axis] = linear ? between(at[axis] - 0.5, weights[axis], sides[axis])
                            : std::min(std::floor(at[axis]), sides[axis] - 1.0);
    }
    double sum = 0;
    for (int corner = 0; corner < 8; ++corner) {
        double weight = 1;
        int place[3];
        for (int axis = 0; axis < 3; ++axis) {
            const int next = corner >> axis & 1;
            weight *= next ? weights[axis] : 1 - weights[axis];
            place[axis] = int(left[axis]) + next;
        }
        if (weight > 0)
            sum += weight * value(place[0], place[1], place[2]);
    }
    return sum;
}

double away(double a, double b)
{
    const double d = std::fabs(a - b);
    return std::min(d, 1 - d);
}

constexpr Blend blends[] = {{Neighbours::nearest, Neighbours::nearest},
                            {Neighbours::nearest, Neighbours::linear},
                            {Neighbours::linear, Neighbours::nearest},
                            {Neighbours::linear, Neighbours::linear}};

} // namespace

BOOST_AUTO_TEST_CASE(phases_are_those_of_the_published_mapping)
{
    std::vector<LookingGlassCalibration> all = displays();
    all.push_back(calibration(7680, 4320));
    double worst = 0;
    for (const LookingGlassCalibration& c : all) {
        const PanelMapping mapping = mapping_of(c);
        for (int row = 0; row<c.height; row += c.height> 1000 ? 97 : 1)
            for (int column = 0; column < c.width; ++column)
                for (int channel = 0; channel < 3; ++channel) {
                    const std::uint32_t phase = mapping.across.row(row)[3 * column + channel];
                    worst = std::max(worst, away(phase / 4294967296.0,
                                                 view_of_subpixel(c, column, row, channel)));
                }
    }
    BOOST_TEST(worst <= 3 / 4294967296.0);
}

BOOST_AUTO_TEST_CASE(every_subpixel_shows_its_view)
{
    for (const LookingGlassCalibration& c : displays())
        for (const ViewGrid grid : {ViewGrid{5, 3}, ViewGrid{1, 1}})
            for (const Blend& blend : blends) {
                const int width = c.width / 3 + 1,
                          height = c.height / 2 + 1; // leaves unused pixels at the right and top
                const Image quilt = noise<std::uint8_t>(
                    grid.columns * width + (grid.columns > 1 ? 2 : 0),
                    grid.rows * height + (grid.rows > 1 ? 1 : 0), 3);
                const auto& samples = std::get<std::vector<std::uint8_t>>(quilt.samples);
                const ViewRaster views(quilt, grid);
                BOOST_TEST(views.width == width);
                Image panel = panel_image(views, c.width, c.height);
                interlace(panel, views, mapping_of(c), blend, 2);
                const auto& got = std::get<std::vector<std::uint8_t>>(panel.samples);
                double worst = 0;
                int wrong = 0;
                for (int row = 0; row < c.height; ++row)
                    for (int column = 0; column < c.width; ++column)
                        for (int channel = 0; channel < 3; ++channel) {
                            const double view = view_of_subpixel(c, column, row, channel);
                            const double edge = view * grid.count() -
                                                std::round(view * grid.count());
                            if (blend.views == Neighbours::nearest && std::fabs(edge) < 1e-6)
                                continue; // on the border between two views, either is right
                            const double x = (c.flip_x ? c.width - column - 0.5 : column + 0.5) /
                                             c.width;
                            const double y = (c.flip_y ? c.height - row - 0.5 : row + 0.5) /
                                             c.height;
                            const double want = shown(
                                view, x, y, grid.count(), width, height, blend,
                                [&](int v, int i, int j) {
                                    const int left = v % grid.columns * width,
                                              top = quilt.height - (v / grid.columns + 1) * height;
                                    return double(
                                        samples[(std::size_t(top + j) * quilt.width + left + i) *
                                                    3 +
                                                channel]);
                                });
                            const double error = std::fabs(
                                want - got[(std::size_t(row) * c.width + column) * 3 + channel]);
                            worst = std::max(worst, error);
                            wrong += error > 2.6;
                        }
                BOOST_TEST(worst <= (&blend == &blends[0] ? 0.0 : 2.6)); // 1/256 weights, rounding
                BOOST_TEST(wrong == 0);
            }
}

namespace {

template <class Sample> const std::vector<Sample>& samples_of(const Image& image)
{
    return std::get<std::vector<Sample>>(image.samples);
}

std::uint64_t between(std::uint64_t a, std::uint64_t b, Step step)
{
    return a * (256 - weight_of(step)) + b * weight_of(step);
}

/// The image of views in one row, 8 bits a sample, computed with integers. The interlacer must give
/// exactly this, whichever of its loops it uses.
std::vector<std::uint8_t> image_in_whole_numbers(const ViewRaster& views,
                                                 const PanelMapping& mapping, Blend blend)
{
    const bool of_views = blend.views == Neighbours::linear,
               of_pixels = blend.pixels == Neighbours::linear;
    std::vector<std::uint8_t> image;
    for (int row = 0; row < mapping.height; ++row)
        for (int i = 0; i < 3 * mapping.width; ++i) {
            const std::uint32_t phase = mapping.across.row(row)[i];
            if (mapping.has_unseen && phase == PanelMapping::unseen) {
                image.push_back(0);
                continue;
            }
            const Step across = step_among(std::uint32_t(views.grid.count()), phase, of_views),
                       x = step_among(std::uint32_t(views.width), mapping.x.row(row)[i], of_pixels),
                       y = step_among(std::uint32_t(views.height), mapping.y.row(row)[i],
                                      of_pixels);
            const auto column = [&](const std::uint8_t* at) {
                const std::uint64_t sum = between(at[0], at[weight_of(y) ? views.row_step : 0], y);
                return mapping.y.columns == 1 ? (sum + 128) / 256 * 256 : sum;
            };
            const auto view = [&](std::uint32_t k) {
                const std::uint8_t* at = views.first<std::uint8_t>(int(k)) +
                                         index_of(y) * views.row_step + index_of(x) * 3 + i % 3;
                return between(column(at), column(at + (weight_of(x) ? 3 : 0)), x);
            };
            const std::uint32_t k = index_of(across);
            image.push_back(std::uint8_t(
                (between(view(k), view(k + (weight_of(across) ? 1 : 0)), across) + (1 << 23)) >>
                24));
        }
    return image;
}

/// Samples of noise, the least and the greatest among them.
template <class Sample> std::vector<Sample> noise_row(int count, unsigned seed)
{
    std::vector<Sample> row = samples_of<Sample>(noise<Sample>((count + 2) / 3, 1, seed));
    row.resize(std::size_t(count));
    row[0] = seed % 2 ? 0 : Sample(-1);
    row[row.size() - 1] = 0;
    row[row.size() / 2] = Sample(-1);
    return row;
}

template <class Sample> void check_blended_rows(int count)
{
    const auto row = noise_row<Sample>(count, 1), below = noise_row<Sample>(count, 2);
    for (const std::uint32_t weight : {0u, 1u, 128u, 255u}) {
        std::vector<Sample> blended(row.size()), want;
        blend_rows(blended.data(), row.data(), below.data(), row.size(), Step(7 << 8 | weight));
        for (std::size_t i = 0; i < row.size(); ++i)
            want.push_back(Sample((between(row[i], below[i], weight) + 128) / 256));
        BOOST_TEST(blended == want, boost::test_tools::per_element());
    }
}

} // namespace

BOOST_AUTO_TEST_CASE(all_loops_give_the_same_bits)
{
    for (const LookingGlassCalibration& c : displays())
        for (const Blend& blend : blends)
            for (const int count : {1, 2, 45}) {
                const Image quilt = noise<std::uint8_t>(count * 37, 23, unsigned(count));
                const ViewRaster views(quilt, {count, 1});
                const PanelMapping mapping = mapping_of(c);
                Image panel = panel_image(views, c.width, c.height);
                interlace(panel, views, mapping, blend, 2);
                BOOST_TEST((samples_of<std::uint8_t>(panel) ==
                            image_in_whole_numbers(views, mapping, blend)));
            }
    for (const int count : {1, 31, 101}) {
        const Image a = noise<std::uint8_t>(count, 1, 1), b = noise<std::uint8_t>(count, 1, 2);
        std::vector<std::uint8_t> pairs(6 * std::size_t(count)), want;
        pair_rows(pairs.data(), samples_of<std::uint8_t>(a).data(),
                  samples_of<std::uint8_t>(b).data(), 3 * std::size_t(count));
        for (int i = 0; i < 3 * count; ++i) {
            want.push_back(samples_of<std::uint8_t>(a)[i]);
            want.push_back(samples_of<std::uint8_t>(b)[i]);
        }
        BOOST_TEST(pairs == want, boost::test_tools::per_element());
        check_blended_rows<std::uint8_t>(3 * count);
        check_blended_rows<std::uint16_t>(3 * count);
    }
}

/// Lenses of every kind: vertical, slanted and horizontal, filled and partly dark.
std::vector<FrameMetadata> lens_panels()
{
    std::vector<FrameMetadata> all;
    for (const Arrangement arrangement : {Arrangement::lenticular, Arrangement::square})
        for (const double slant : {0.0, 9.46, -38.4, 90.0})
            for (const int width : {1, 8, 91})
                for (const bool wide : {false, true}) {
                    FrameMetadata m;
                    m.sheet = {arrangement, 1.03, 3.08, 1.6, slant, {0.11, -0.07}};
                    m.film = {width, 35, {0.207, 0.203}, Subpixels::rgb};
                    m.aperture = *filling_aperture(m.sheet, 400);
                    if (!wide)
                        m.aperture = {400, 90, 90, ApertureShape::rectangle};
                    all.push_back(m);
                }
    return all;
}

BOOST_AUTO_TEST_CASE(all_loops_of_the_optics_give_the_same_bits)
{
    // Used in turn, so that each count of views meets each; 400 rows: more than the fast loop
    // keeps.
    const std::vector<int> heights = {1, 23, 400, 23};
    std::size_t case_number = 0;
    int fast_rows = 0, seen = 0, dark = 0;
    for (const FrameMetadata& m : lens_panels()) {
        const auto mapping = mapping_of(m, {{m.aperture.width, m.aperture.height}, 400}, 2);
        BOOST_REQUIRE(mapping);
        const bool round = m.sheet.arrangement != Arrangement::lenticular;
        for (int y = 0; y < m.film.height; ++y) {
            const std::uint16_t* const ys = mapping->y.row(y).phase16;
            std::vector<std::uint16_t> of_seen;
            for (int i = 0; i < 3 * m.film.width; ++i)
                if (mapping->across.row(y)[i] != PanelMapping::unseen)
                    of_seen.push_back(ys[i]);
            const auto [least, greatest] = mapping->y_range[std::size_t(y)];
            if (!of_seen.empty()) {
                BOOST_TEST(least == *std::min_element(of_seen.begin(), of_seen.end()));
                BOOST_TEST(greatest == *std::max_element(of_seen.begin(), of_seen.end()));
            }
            fast_rows += greatest - least < 65535 / 23;
            seen += int(of_seen.size());
            dark += 3 * m.film.width - int(of_seen.size());
        }
        for (const Blend& blend : blends)
            for (const int count : {1, 2, 45}) {
                const int height = heights[case_number++ % heights.size()];
                const Image quilt = noise<std::uint8_t>(count * 37, height, unsigned(count));
                const ViewRaster views(quilt, {count, 1});
                Image panel = panel_image(views, m.film.width, m.film.height);
                interlace(panel, views, *mapping, blend, 2);
                if (!round && samples_of<std::uint8_t>(panel) !=
                                  image_in_whole_numbers(views, *mapping, blend))
                    BOOST_TEST_ERROR(m.film.width << " wide, slant " << m.sheet.slant << ", "
                                                  << count << " views of 37x" << height
                                                  << ": they differ");
            }
    }
    BOOST_TEST(fast_rows > 500);
    BOOST_TEST(seen > 50000);
    BOOST_TEST(dark > 500);
}

BOOST_AUTO_TEST_CASE(weights_between_views)
{
    BOOST_TEST(index_of(linear_step(0, 4)) == 0u);
    BOOST_TEST(weight_of(linear_step(0, 4)) == 0u);
    BOOST_TEST(weight_of(linear_step(0x20000000, 4)) == 0u); // the middle of the first of four
    BOOST_TEST(weight_of(linear_step(0x40000000, 4)) == 128u);
    BOOST_TEST(index_of(linear_step(0x60000000, 4)) == 1u);
    BOOST_TEST(index_of(linear_step(0xffffffff, 4)) == 3u);
    BOOST_TEST(weight_of(linear_step(0xffffffff, 4)) == 0u);
    BOOST_TEST(index_of(nearest_step(0xffffffff, 7)) == 6u);
    for (std::uint64_t phase = 0; phase < 0x100000000; phase += 0x10001)
        for (const std::uint32_t count : {1u, 3u, 48u}) {
            const Step step = linear_step(std::uint32_t(phase), count);
            const double want = std::clamp(phase / 4294967296.0 * count - 0.5, 0.0, count - 1.0);
            if (std::fabs(index_of(step) + weight_of(step) / 256.0 - want) > 0.502 / 256 ||
                index_of(step) >= count || (index_of(step) == count - 1 && weight_of(step)))
                BOOST_TEST_ERROR("phase " << phase << " of " << count << ": " << index_of(step)
                                          << " + " << weight_of(step) << "/256, wanted " << want);
        }
}

BOOST_AUTO_TEST_CASE(sixteen_bits)
{
    const LookingGlassCalibration c = calibration(64, 40);
    Image wide = noise<std::uint8_t>(60, 30, 4);
    const Image narrow = wide;
    std::vector<std::uint16_t> samples;
    for (const std::uint8_t sample : std::get<std::vector<std::uint8_t>>(narrow.samples))
        samples.push_back(std::uint16_t(257 * sample));
    wide.samples = samples;
    for (const Blend& blend : blends) {
        const ViewRaster of_wide(wide, {6, 1}), of_narrow(narrow, {6, 1});
        Image a = panel_image(of_wide, c.width, c.height),
              b = panel_image(of_narrow, c.width, c.height);
        interlace(a, of_wide, mapping_of(c), blend);
        interlace(b, of_narrow, mapping_of(c), blend);
        double worst = 0;
        for (std::size_t i = 0; i < std::get<0>(b.samples).size(); ++i)
            worst = std::max(
                worst, std::fabs(std::get<1>(a.samples)[i] / 257.0 - std::get<0>(b.samples)[i]));
        BOOST_TEST(worst <= (&blend == &blends[0] ? 0.0 : 1.1));
    }
}

BOOST_AUTO_TEST_CASE(a_quilt_and_its_views_are_the_same)
{
    const LookingGlassCalibration c = calibration(50, 40);
    const Image quilt = noise<std::uint8_t>(80, 60, 5);
    std::vector<Image> views;
    for (int row = 0; row < 3; ++row)
        for (int column = 0; column < 4; ++column)
            views.push_back(part_of(quilt, column * 20, 60 - (row + 1) * 20, 20, 20));
    Image a = panel_image(ViewRaster(quilt, {4, 3}), 50, 40), b = a;
    interlace(a, ViewRaster(quilt, {4, 3}), mapping_of(c));
    interlace(b, ViewRaster(views, {4, 3}), mapping_of(c));
    BOOST_TEST((a.samples == b.samples));
    BOOST_CHECK_THROW(ViewRaster(quilt, {81, 1}), std::invalid_argument);
    BOOST_CHECK_THROW(ViewRaster(views, {5, 3}), std::invalid_argument);
    BOOST_CHECK_THROW(ViewRaster(make_image<float>(8, 8, 3, {}), {1, 1}), std::invalid_argument);
    BOOST_CHECK_THROW(interlace(a, ViewRaster(quilt, {4, 3}), mapping_of(calibration(51, 40))),
                      std::invalid_argument);
}

BOOST_AUTO_TEST_CASE(through_the_optics_as_in_floating_point)
{
    const Encoding linear{Encoding::Kind::linear, 1};
    for (const Arrangement arrangement :
         {Arrangement::lenticular, Arrangement::square, Arrangement::hexagonal})
        for (const double slant : {0.0, 9.46, -18.4})
            for (const Subpixels& subpixels :
                 {Subpixels(), Subpixels(Subpixels::rgb), Subpixels(Subpixels::vbgr)}) {
                FrameMetadata m;
                m.sheet = {arrangement, 1.03, 3.08, 1.6, slant, {0.11, -0.07}};
                m.film = {91, 67, {0.207, 0.203}, subpixels};
                m.aperture = *filling_aperture(m.sheet, 400);
                m.encoding = linear;
                const bool round = arrangement != Arrangement::lenticular;
                const ViewGrid grid{5, round ? 4 : 1};
                const EyeGrid eyes{{m.aperture.width, m.aperture.height}, 400};
                std::vector<Image> views; // smooth: 16-bit positions are too coarse for noise
                for (int k = 0; k < grid.count(); ++k) {
                    Image view = make_image<std::uint16_t>(33, 21, 3, linear);
                    for (int y = 0; y < view.height; ++y)
                        for (int x = 0; x < view.width; ++x)
                            store_pixel(view, x, y,
                                        {float(0.5 + 0.4 * std::sin(0.7 * x + k)),
                                         float(0.5 + 0.4 * std::cos(0.5 * y - k)), float(k) / 20,
                                         1});
                    views.push_back(view);
                }
                const auto want = frame_from_eye_views(views, m, grid, eyes, 1);
                const auto mapping = mapping_of(m, eyes, 2);
                BOOST_REQUIRE(want);
                BOOST_REQUIRE(mapping);
                const ViewRaster pictures(views, grid);
                Image got = panel_image(pictures, 91, 67);
                interlace(got, pictures, *mapping, {}, 2);
                double worst = 0;
                for (std::size_t i = 0; i < std::get<1>(got.samples).size(); ++i)
                    worst = std::max(worst, std::fabs(double(std::get<1>(got.samples)[i]) -
                                                      std::get<1>(want->samples)[i]) /
                                                65535);
                BOOST_TEST(worst < 0.004); // weights of 1/256 on four axes, differences up to 0.8
            }
}

BOOST_AUTO_TEST_CASE(what_no_eye_sees_is_black)
{
    FrameMetadata m;
    m.sheet = {Arrangement::lenticular, 1, 3, 1.5, 0, {}};
    m.film = {120, 3, {0.1, 0.1}};
    m.aperture = {400, 20, 0, ApertureShape::rectangle}; // underfill
    const auto mapping = mapping_of(m, {{20, 0}, 400});
    Image white = make_image<std::uint8_t>(4, 4, 3, {});
    std::get<0>(white.samples).assign(48, 255);
    Image got = panel_image(ViewRaster(white, {1, 1}), 120, 3);
    interlace(got, ViewRaster(white, {1, 1}), *mapping);
    const SheetOptics optics(m.sheet, m.aperture);
    int lit = 0;
    for (int x = 0; x < 120; ++x) {
        const bool seen = optics
                              .map(film_from_pixel(m.film, {x + 0.5, 1.5}), LensMapping::automatic)
                              .ray.has_value();
        BOOST_TEST(std::get<0>(got.samples)[(120 + x) * 3] == (seen ? 255 : 0));
        lit += seen;
    }
    BOOST_TEST(lit > 0);
    BOOST_TEST(lit < 60);
}

BOOST_AUTO_TEST_SUITE_END()
