// SPDX-License-Identifier: AGPL-3.0-or-later
// Tests how the noise that reconstruction leaves is lowered: on frames whose light and noise are
// known.
#include "integral/lightfield/noise_filter.h"
#include "integral/lightfield/pass_rows.h"
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
    FirstSamples colours;
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

    /// What is added to the red component of each pixel.
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

/// The mean squared errors of pixels that have all neighbours and for which which(x, y) holds,
/// after and before, divided by each other.
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
            int number = 0;
            frame.colours.for_each_second_difference(x, y, [&](int, FourFloats) { ++number; });
            if (number == 3 && which(x, y)) {
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

BOOST_AUTO_TEST_SUITE(lightfield_noise_filter)

// Where all is noise, the pixel and the means along three axes count alike: the variance 1 becomes
// (1 + 3/2)/4^2. The noise that is told is four times as much, since the filter takes a quarter of
// it for the pixel's own.
BOOST_AUTO_TEST_CASE(even_light_loses_its_noise)
{
    BOOST_TEST(left(sheet(Arrangement::square), flat, 4) == 2.5 / 16,
               boost::test_tools::tolerance(0.25));
    BOOST_TEST(left(sheet(Arrangement::hexagonal), flat, 4) == 2.5 / 16,
               boost::test_tools::tolerance(0.25));
    // Behind lenticular sheets, along the lines most.
    const double told = left(sheet(Arrangement::lenticular), flat, 1.25f);
    BOOST_TEST(told < 0.45);
    BOOST_TEST(told > 0.25);
}

// Less noise than there is lets the filter do less, never more.
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

// Light that grows evenly across the frame, or from lens to lens, is as good as even light. (The
// border of a lens is an edge in a frame, but no pixel beside it is asked.)
BOOST_AUTO_TEST_CASE(slopes_stay)
{
    for (const Arrangement arrangement :
         {Arrangement::square, Arrangement::hexagonal, Arrangement::lenticular}) {
        const Finished frame(sheet(arrangement),
                             [](int x, int y) { return 0.3 + 0.002 * x + 0.001 * y; });
        for (const float change : frame.changes(expected))
            BOOST_TEST_REQUIRE(std::fabs(change) < 2 / colour_levels);
    }
    const auto slope = [](int x, int y) { return 0.3 + 0.002 * x + 0.001 * y; };
    const CameraParameters p = sheet(Arrangement::square);
    BOOST_TEST(left(p, slope, 4) < 1.05 * left(p, flat, 4));
}

// Edges, lines and single pixels that are far above the noise stay as they are.
BOOST_AUTO_TEST_CASE(edges_stay)
{
    const CameraParameters p = sheet(Arrangement::square);
    const Grey edge = [](int x, int) { return x < 67 ? 0.2 : 0.8; },
               line = [](int x, int) { return x == 67 ? 0.8 : 0.2; },
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
    // Noise along an edge is lowered all the same, since its pixels are alike.
    const auto beside = [](int x, int) { return x == 66 || x == 67; };
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
                    float low = 0, high = 0;
                    frame.colours.for_each_second_difference(x, y, [&](int, FourFloats difference) {
                        low = std::min(low, difference[0]);
                        high = std::max(high, difference[0]);
                    });
                    const float change = changes[y * width + x];
                    BOOST_TEST_REQUIRE((change >= low - 1e-6f && change <= high + 1e-6f));
                }
        }
    }
}

// Behind lines that run across the frame, x and y change their places.
BOOST_AUTO_TEST_CASE(lines_may_run_either_way)
{
    const std::vector<double> noise = noise_values();
    const auto sums = [&](double slant, bool along_x) {
        const Finished frame(sheet(Arrangement::lenticular, slant), [&](int x, int y) {
            return 0.5 + noise[along_x ? y : x]; // the same in each column, or in each row
        });
        double sum = 0;
        for (const float change : frame.changes(expected))
            sum += std::fabs(change);
        return sum / (width * height);
    };
    const double upright = sums(0, true), level = sums(88, false);
    BOOST_TEST(upright > 2 * sums(0, false));
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

// A block of the frame gives what the whole frame gives.
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

// Reconstructed frames of scenes in closed form, all of whose light has sharp edges, come nearer to
// what is right. (Single scenes behind square lenses may come out worse, by up to 5%.)
BOOST_AUTO_TEST_CASE(reconstructed_frames_gain)
{
    using sampled_frame::Sampled;
    const struct {
        Arrangement arrangement;
        double most;
    } sheets[] = {
        {Arrangement::square, 1}, {Arrangement::hexagonal, 1}, {Arrangement::lenticular, 0.85}};
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
