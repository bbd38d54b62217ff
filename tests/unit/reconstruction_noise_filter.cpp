// SPDX-License-Identifier: AGPL-3.0-or-later
// Tests the filter of the noise that reconstruction leaves, on frames of known light and noise.
#include "integral/reconstruction/noise_filter.h"
#include "integral/reconstruction/pass_rows.h"
#include "tests/unit/sampled_frame.h"

#include <random>

using namespace pixel_origins;

namespace {

constexpr int width = 150, height = 120;
constexpr float sigma = 0.01f; // of the noise of each of three components
constexpr PictureBlock all{0, 0, width - 1, height - 1};

CameraParameters sheet(Arrangement arrangement, double slant = 0)
{
    CameraParameters p = parameters_of(arrangement);
    p.film.pixel_pitch = {25.4 / 300, 25.4 / 300}; // 15 pixels a lens
    p.sheet.slant = slant;
    p.sheet.offset = 0.25 * p.film.pixel_pitch; // no pixel's middle is on a border
    return p;
}

using Grey = std::function<double(int x, int y)>;

/// A finished frame of grey values, in the encoding of comparison, behind lenses that image all of
/// it.
struct Finished {
    IntegralCamera camera;
    LightFieldImage colours;
    NoiseFilter filter;

    Finished(const CameraParameters& p, const Grey& grey)
        : camera(camera_of(p, width, height)), colours(camera), filter(camera, colours)
    {
        for (int y = 0; y < height; ++y)
            for (int x = 0; x < width; ++x)
                if (const auto ray = camera.optics
                                         .map(film_from_pixel(camera.film, {x + 0.5, y + 0.5}),
                                              camera.mapping)
                                         .ray) {
                    colours.set(x, y, {}, ray->lens, 0);
                    recolour(x, y, grey(x, y));
                }
    }

    void recolour(int x, int y, double grey) { colours.recolour(x, y, {grey, grey, grey, 0}); }

    /// The change of each pixel's red component.
    std::vector<float> changes(const NoiseFilter::Noise& noise,
                               const PictureBlock& block = all) const
    {
        std::vector<FourFloats> found;
        filter.filter(block, noise, *NoiseFilter::make_scratch(), found);
        std::vector<float> red;
        for (const FourFloats& change : found)
            red.push_back(change[0]);
        return red;
    }
};

/// Values of independent noise, the same for every frame.
std::vector<double> noise_values()
{
    std::mt19937 random(1);
    std::normal_distribution<double> normal(0, sigma);
    std::vector<double> values;
    for (int k = 0; k < width * height; ++k)
        values.push_back(normal(random));
    return values;
}

/// The variance that noise of `sigma` has in three components.
float expected(int, int) { return 3 * sigma * sigma; }

/// Calls visit(colour) for each pixel with which (x, y) may be mixed: pixels behind the same lens,
/// up to four away in its row and column, and pixels of the same direction behind the next lenses.
template <class Visit> void for_each_mixed(const LightFieldImage& frame, int x, int y, Visit visit)
{
    const auto lens = frame.lens(x, y);
    if (!lens)
        return;
    for (int way = -NoiseFilter::reach_along; way <= NoiseFilter::reach_along; ++way) {
        if (way != 0 && frame.lens(x + way, y) == lens)
            visit(frame.colour(x + way, y));
        if (way != 0 && frame.lens(x, y + way) == lens)
            visit(frame.colour(x, y + way));
    }
    for (const auto& colour : frame.colours_behind_next_lenses(x, y))
        if (colour)
            visit(*colour);
}

bool has_all_neighbours(const LightFieldImage& frame, int x, int y)
{
    int number = 0;
    for_each_mixed(frame, x, y, [&](FourFloats) { ++number; });
    return number == 4 * NoiseFilter::reach_along + 2;
}

/// Mean squared error after filtering divided by the one before, over pixels that have all
/// neighbours and for which which(x, y) holds. `told`: the variance stated to the filter, divided
/// by the true one.
double left(
    const CameraParameters& p, const Grey& light, float told,
    const std::function<bool(int x, int y)>& which = [](int, int) { return true; })
{
    const std::vector<double> noise = noise_values();
    const Finished frame(p, [&](int x, int y) { return light(x, y) + noise[y * width + x]; });
    const auto changes = frame.changes([&](int, int) { return told * expected(0, 0); });
    double before = 0, after = 0;
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            if (has_all_neighbours(frame.colours, x, y) && which(x, y)) {
                const double error = noise[y * width + x];
                before += error * error;
                after += (error + changes[y * width + x]) * (error + changes[y * width + x]);
            }
        }
    BOOST_TEST_REQUIRE(before > 0);
    return after / before;
}

double flat(int, int) { return 0.5; }

} // namespace

BOOST_AUTO_TEST_SUITE(reconstruction_noise_filter)

// Where all is noise, the pixel, its 18 neighbours, and the means of the nearest two along three
// axes have equal weights: the variance 1 becomes (1 + 6 (3/2)^2 + 12)/22^2. The stated noise is
// four times the true one, because the filter takes a quarter of it for the pixel's own.
BOOST_AUTO_TEST_CASE(even_light_loses_its_noise)
{
    const auto about = boost::test_tools::tolerance(0.25);
    BOOST_TEST(left(sheet(Arrangement::square), flat, 4) == 26.5 / 484, about);
    BOOST_TEST(left(sheet(Arrangement::hexagonal), flat, 4) == 26.5 / 484, about);
    // Behind lenticular sheets, with 1.25 times the true noise stated, neighbours have the weight
    // (3/(2/0.3125 + 1))^2, the mean of two along the lines 1, and across them 1/(1.5/0.15 - 1).
    const double one = 0.164, along = one + 0.5, across = one + 0.056, all = 1 + 18 * one + 1.22;
    BOOST_TEST(left(sheet(Arrangement::lenticular), flat, 1.25f) ==
                   (1 + 2 * along * along + 4 * across * across + 12 * one * one) / (all * all),
               about);
}

// If the stated noise is too low, the filter does less, never more.
BOOST_AUTO_TEST_CASE(it_does_no_more_than_noise_explains)
{
    double before = 1;
    for (const float told : {0.0f, 0.1f, 0.5f, 1.0f, 4.0f}) {
        const double now = left(sheet(Arrangement::square), flat, told);
        BOOST_TEST(now <= before);
        before = now;
    }
    BOOST_TEST(left(sheet(Arrangement::square), flat, 0) == 1);
    BOOST_TEST(left(sheet(Arrangement::square), flat, 0.1f) > 0.8);
}

// Light that grows evenly across the frame, or from lens to lens, is filtered as well as even
// light. At the border of a lens, where neighbours are on one side only, it is blurred by less than
// its noise.
BOOST_AUTO_TEST_CASE(slopes_stay)
{
    const auto slope = [](int x, int y) { return 0.3 + 0.002 * x + 0.001 * y; };
    for (const Arrangement arrangement :
         {Arrangement::square, Arrangement::hexagonal, Arrangement::lenticular}) {
        const Finished frame(sheet(arrangement), slope);
        const auto changes = frame.changes(expected);
        int within = 0;
        for (int y = 0; y < height; ++y)
            for (int x = 0; x < width; ++x) {
                const float change = std::fabs(changes[y * width + x]);
                BOOST_TEST_REQUIRE(change < 0.4 * sigma);
                if (!has_all_neighbours(frame.colours, x, y))
                    continue;
                ++within;
                BOOST_TEST_REQUIRE(change < 2 / colour_levels);
            }
        BOOST_TEST(within > 0.1 * width * height);
    }
    const CameraParameters p = sheet(Arrangement::square);
    BOOST_TEST(left(p, slope, 4) < 1.2 * left(p, flat, 4));
}

// Edges, lines and single pixels that are far above the noise stay as they are.
BOOST_AUTO_TEST_CASE(edges_stay)
{
    const CameraParameters p = sheet(Arrangement::square);
    const Grey edge = [](int x, int) { return x < 75 ? 0.2 : 0.8; },
               line = [](int x, int) { return x == 75 ? 0.8 : 0.2; },
               dots = [](int x, int y) { return x % 9 == 4 && y % 7 == 3 ? 0.8 : 0.2; };
    const auto most = [&](const Grey& grey) {
        double change = 0;
        for (const float c : Finished(p, grey).changes(expected))
            change = std::fmax(change, std::fabs(c));
        return change;
    };
    BOOST_TEST(most(edge) < 0.001);
    BOOST_TEST(most(line) < 0.001);
    BOOST_TEST(most(dots) < 0.005);
    // Noise along an edge is still lowered, since the pixels along it are equal.
    const auto beside = [](int x, int) { return x == 74 || x == 75; };
    BOOST_TEST(left(p, edge, 4, beside) < 0.6);
}

// A pixel without noise stays, whatever those around it do; so does an empty one.
BOOST_AUTO_TEST_CASE(pixels_to_be_left_alone_are)
{
    const std::vector<double> noise = noise_values();
    const Finished frame(sheet(Arrangement::square),
                         [&](int x, int y) { return 0.5 + noise[y * width + x]; });
    const auto changes = frame.changes(
        [](int x, int y) { return (x + y) % 2 ? expected(x, y) : 0.0f; });
    int changed = 0;
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x)
            if ((x + y) % 2)
                changed += changes[y * width + x] != 0;
            else
                BOOST_TEST_REQUIRE(changes[y * width + x] == 0);
    BOOST_TEST(changed > width * height / 3);
}

// The result lies between the darkest and the brightest of the pixel and its neighbours.
BOOST_AUTO_TEST_CASE(nothing_is_darker_or_brighter_than_all_around)
{
    std::mt19937 random(2);
    std::uniform_real_distribution<double> even(0, 1);
    for (const Arrangement arrangement :
         {Arrangement::square, Arrangement::hexagonal, Arrangement::lenticular}) {
        const Finished frame(sheet(arrangement), [&](int, int) { return even(random); });
        for (const float told : {0.01f, 1.0f, 100.0f}) {
            const auto changes = frame.changes([&](int, int) { return told; });
            for (int y = 0; y < height; ++y)
                for (int x = 0; x < width; ++x) {
                    const float own = frame.colours.colour(x, y)[0],
                                now = own + changes[y * width + x];
                    float low = own, high = own;
                    for_each_mixed(frame.colours, x, y, [&](FourFloats colour) {
                        low = std::min(low, colour[0]);
                        high = std::max(high, colour[0]);
                    });
                    BOOST_TEST_REQUIRE((now >= low - 1e-6f && now <= high + 1e-6f));
                }
        }
    }
}

// Behind lines that run across the frame, x and y are exchanged.
BOOST_AUTO_TEST_CASE(lines_may_run_either_way)
{
    const std::vector<double> noise = noise_values();
    const auto sums = [&](double slant, bool along_x) {
        const Finished frame(sheet(Arrangement::lenticular, slant), [&](int x, int y) {
            return 0.5 + noise[along_x ? y : x]; // the same in each column, or in each row
        });
        double sum = 0;
        const auto little = [](int x, int y) { return 0.3f * expected(x, y); };
        for (const float change : frame.changes(little))
            sum += std::fabs(change);
        return sum / (width * height);
    };
    const double upright = sums(0, true), level = sums(88, false);
    BOOST_TEST(upright > 1.3 * sums(0, false));
    BOOST_TEST(level > 2 * sums(88, true));
}

BOOST_AUTO_TEST_CASE(no_pixel_depends_on_further_rows)
{
    const std::vector<double> noise = noise_values();
    for (const CameraParameters& p :
         {sheet(Arrangement::square), sheet(Arrangement::hexagonal), sheet(Arrangement::lenticular),
          sheet(Arrangement::lenticular, 88)}) {
        Finished frame(p, [&](int x, int y) { return 0.5 + noise[y * width + x]; });
        const int reach = PassRows(frame.camera.optics.sheet(), frame.camera.film, 1, true)
                              .filtered_from();
        const int middle = height / 2;
        const PictureBlock row{0, middle, width - 1, middle};
        const auto before = frame.changes(expected, row);
        const auto darken = [&](int from, int to) {
            for (int y = from; y <= to; ++y)
                for (int x = 0; x < width; ++x)
                    frame.recolour(x, y, 0);
        };
        darken(0, middle - reach - 1);
        darken(middle + reach + 1, height - 1);
        BOOST_TEST((frame.changes(expected, row) == before), int(p.sheet.arrangement));
        darken(middle + reach, middle + reach);
        BOOST_TEST((frame.changes(expected, row) != before), int(p.sheet.arrangement));
    }
}

// A block of the frame is filtered as in the whole frame.
BOOST_AUTO_TEST_CASE(blocks_do_not_show)
{
    const std::vector<double> noise = noise_values();
    const Finished frame(sheet(Arrangement::square),
                         [&](int x, int y) { return 0.5 + noise[y * width + x]; });
    const auto whole = frame.changes(expected);
    const PictureBlock block{40, 30, 61, 48};
    const auto part = frame.changes(expected, block);
    std::size_t k = 0;
    for (int y = block.top; y <= block.bottom; ++y)
        for (int x = block.left; x <= block.right; ++x)
            BOOST_TEST_REQUIRE(part[k++] == whole[y * width + x]);
}

// The filter reduces the error of reconstructed frames. The scenes are in closed form, and all
// their light has sharp edges. (Single scenes behind square and hexagonal lenses hardly gain.)
BOOST_AUTO_TEST_CASE(reconstructed_frames_gain)
{
    using sampled_frame::Sampled;
    const struct {
        Arrangement arrangement;
        double most;
    } sheets[] = {{Arrangement::square, 0.97},
                  {Arrangement::hexagonal, 0.97},
                  {Arrangement::lenticular, 0.75}};
    for (const auto& one : sheets) {
        double before = 0, after = 0;
        for (const double depth : {-20.0, 3.0, 40.0}) {
            const sampled_frame::Scene scene = sampled_frame::chequers(depth, 4);
            Sampled frame(sampled_frame::sheet(one.arrangement), scene, 4);
            const auto pixels = frame.pixels();
            const auto for_each_pixel = [&](int margin, auto visit) {
                for (int y = margin; y < sampled_frame::height - margin; ++y)
                    for (int x = margin; x < sampled_frame::width - margin; ++x)
                        if (const auto& light = pixels[Sampled::at(x, y)])
                            visit(x, y, double(sampled_frame::encode((*light)[0])));
            };
            for_each_pixel(0, [&](int x, int y, double c) {
                frame.first.recolour(x, y, {c, c, c, 0});
            });
            std::vector<FourFloats> changes;
            NoiseFilter(frame.camera, frame.first)
                .filter(
                    Sampled::all,
                    [&](int x, int y) { return frame.reconstruction.noise_left(x, y); },
                    *NoiseFilter::make_scratch(), changes);
            for_each_pixel(8, [&](int x, int y, double c) {
                const double right = sampled_frame::encode(float(frame.truth(scene, x, y))),
                             filtered = c + changes[Sampled::at(x, y)][0];
                before += (c - right) * (c - right);
                after += (filtered - right) * (filtered - right);
            });
        }
        const double ratio = std::sqrt(after / before);
        BOOST_TEST(ratio < one.most, int(one.arrangement) << ": " << ratio);
        BOOST_TEST(ratio > 0.5, int(one.arrangement) << ": " << ratio);
    }
}

BOOST_AUTO_TEST_SUITE_END()
