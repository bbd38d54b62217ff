// SPDX-License-Identifier: AGPL-3.0-or-later
// Tests lenses that lie across by symmetry: a frame that is turned by a quarter with its sheet
// shows the same as the upright one, turned; in views, replay, panels and depth.
#include "integral/base/constants.h"
#include "integral/depth/multibaseline.h"
#include "integral/depth/ray_trace.h"
#include "integral/panel/interlace.h"
#include "integral/replay/arrange.h"
#include "integral/replay/replay_series.h"
#include "integral/sampling/quilt_sampler.h"
#include "integral/views/parallel_views.h"
#include "integral/views/perspective_views.h"
#include "integral/views/view_files.h"

#include <boost/test/unit_test.hpp>

#include <random>

using namespace integral;

namespace {

// All turn anticlockwise, as the viewer sees it: what is on the right comes up.

Vec2 turned(Vec2 v) { return {-v.y, v.x}; }

Eye turned(const Eye& eye) { return {-eye.y, eye.x, eye.distance}; }

Image turned(const Image& image)
{
    Image to = blank_like(image, image.height, image.width);
    for (int y = 0; y < image.height; ++y)
        for (int x = 0; x < image.width; ++x)
            store_pixel(to, y, image.width - 1 - x, stored_pixel(image, x, y));
    return to;
}

std::vector<Image> turned(std::vector<Image> pictures)
{
    for (Image& picture : pictures)
        picture = turned(picture);
    return pictures;
}

FrameMetadata turned(FrameMetadata m)
{
    m.sheet.slant += m.sheet.slant > 0 ? -90 : 90; // the same lenses as by a quarter more
    m.sheet.offset = turned(m.sheet.offset);
    std::swap(m.film.width, m.film.height);
    std::swap(m.film.pixel_pitch.x, m.film.pixel_pitch.y);
    std::swap(m.aperture.width, m.aperture.height);
    return m;
}

Frame turned(const Frame& frame)
{
    Frame to{turned(frame.image), std::nullopt};
    set_metadata(to, turned(*frame.metadata));
    return to;
}

/// Waves, so that pixels differ smoothly, and noise.
Image pattern(int width, int height, double noise)
{
    std::mt19937 random(5);
    std::uniform_real_distribution<float> value(0, 1);
    Image image = make_image<std::uint16_t>(width, height, 3, Encoding());
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            const auto wave = [&](double a, double b) {
                return float((1 - noise) * (0.5 + 0.5 * std::sin(a * x + b * y))) +
                       float(noise) * value(random);
            };
            store_pixel(image, x, y, {wave(.31, .05), wave(-.17, .11), wave(.07, .23), 1});
        }
    return image;
}

/// An upright frame. Slant 0: whole pixels a lens.
Frame upright_frame(double slant, double noise = 0.3)
{
    FrameMetadata m;
    m.sheet = {Arrangement::lenticular, 1.2, 3, 1.55, slant, {0.07, -0.2}};
    m.film = {173, 90, {0.12, 0.11}};
    m.aperture = *filling_aperture(m.sheet, 300);
    Frame frame{pattern(m.film.width, m.film.height, noise), std::nullopt};
    set_metadata(frame, m);
    return frame;
}

/// The fraction of samples that differ by more than 1/255.
double differing(const Image& a, const Image& b)
{
    if (!same_form(a, b))
        return 1;
    double count = 0;
    for (int y = 0; y < a.height; ++y)
        for (int x = 0; x < a.width; ++x) {
            const Colour p = stored_pixel(a, x, y), q = stored_pixel(b, x, y);
            count += std::max({std::fabs(p.r - q.r), std::fabs(p.g - q.g), std::fabs(p.b - q.b)}) >
                     1 / 255.0f;
        }
    return count / (double(a.width) * a.height);
}

void are_equal(const std::vector<Image>& a, const std::vector<Image>& b, double most_differ)
{
    BOOST_REQUIRE(a.size() == b.size());
    for (std::size_t k = 0; k < a.size(); ++k)
        BOOST_TEST(differing(a[k], b[k]) <= most_differ,
                   "picture " << k << ": " << std::to_string(differing(a[k], b[k])));
}

constexpr double slants[] = {0, 14, -31};
constexpr double ties = 2e-3; // of pixels, on the borders of lenses

} // namespace

BOOST_AUTO_TEST_SUITE(replay_lying_lenses)

BOOST_AUTO_TEST_CASE(directions_go_upwards)
{
    LensSheet sheet;
    for (const double slant : {45.0, 45.001, -45.001, 89.99, 90.0, -90.0}) {
        sheet.slant = slant;
        const ViewGrid views = directions_of({4, 3}, sheet);
        BOOST_TEST(views.columns == (slant == 45 ? 12 : 1));
        BOOST_TEST(views.rows == (slant == 45 ? 1 : 12));
    }
    sheet.arrangement = Arrangement::square;
    BOOST_TEST(directions_of({4, 3}, sheet).rows == 3);
}

BOOST_AUTO_TEST_CASE(parallel_views_are_the_upright_ones_turned)
{
    for (const double slant : slants) {
        const Frame upright = upright_frame(slant), lying = turned(upright);
        const ViewGrid natural = natural_views(*lying.metadata);
        BOOST_TEST(natural.columns == 1);
        BOOST_TEST(natural.rows == natural_views(*upright.metadata).columns);
        BOOST_TEST(views_are_exact(*lying.metadata, natural) == (slant == 0));
        for (const int count : {natural.rows, 7}) {
            const auto views = *parallel_views(lying, {1, count}, 2);
            are_equal(views, turned(*parallel_views(upright, {count, 1}, 2)), 0);
            if (slant == 0 && count == natural.rows)
                BOOST_TEST((frame_from_parallel_views(views, *lying.metadata, natural)->samples ==
                            lying.image.samples));
        }
        View narrow, wide;
        narrow.width = wide.height = 52;
        narrow.height = wide.width = 100;
        are_equal(upright_views(lying, {1, 3}, narrow, 2, {}),
                  turned(upright_views(upright, {3, 1}, wide, 2, {})), ties);
        BOOST_TEST(std::fabs(*psnr_there_and_back(lying, {1, 7}) -
                             *psnr_there_and_back(upright, {7, 1})) < 1e-3);
    }
}

BOOST_AUTO_TEST_CASE(frames_come_back_from_views_whichever_way_lenses_are_numbered)
{
    // slants of 90 and -90 are the same lenses, numbered upwards and downwards
    for (const double pitch : {1.1, 0.93})
        for (const double slant : {90.0, -90.0, 70.0, -70.0}) {
            Frame frame = turned(upright_frame(0, 0));
            FrameMetadata m = *frame.metadata;
            m.sheet.pitch = pitch;
            m.sheet.slant = slant;
            m.film.pixel_pitch = {0.12, 0.11};
            set_metadata(frame, m);
            const ViewGrid grid{1, 30};
            const auto back = frame_from_parallel_views(*parallel_views(frame, grid), m, grid);
            BOOST_TEST(differing(*back, frame.image) < 1); // of one size
            BOOST_TEST(*psnr_there_and_back(frame, grid) > 28);
        }
    FrameMetadata m = *turned(upright_frame(0)).metadata;
    BOOST_REQUIRE(m.sheet.slant == 90);
    m.sheet.pitch = 11 * m.film.pixel_pitch.y;
    Frame up{pattern(m.film.width, m.film.height, 1), std::nullopt}, down = up;
    set_metadata(up, m);
    m.sheet.slant = -90;
    set_metadata(down, m);
    const ViewGrid grid = natural_views(m);
    BOOST_TEST(views_are_exact(m, grid));
    are_equal(*parallel_views(up, grid), *parallel_views(down, grid), 0);
}

BOOST_AUTO_TEST_CASE(square_lenses_turned_by_90_degrees_are_the_same_lenses)
{
    FrameMetadata m = *upright_frame(0).metadata;
    m.sheet.arrangement = Arrangement::square;
    m.film.pixel_pitch = {0.12, 0.12};
    Frame frame{pattern(m.film.width, m.film.height, 1), std::nullopt}, same = frame;
    set_metadata(frame, m);
    m.sheet.slant = 90;
    set_metadata(same, m);
    const ViewGrid grid = natural_views(m);
    BOOST_TEST(views_are_exact(m, grid));
    are_equal(*parallel_views(frame, grid), *parallel_views(same, grid), 0);
}

BOOST_AUTO_TEST_CASE(eyes_and_paths_are_the_upright_ones_turned)
{
    const Frame upright = upright_frame(0), lying = turned(upright);
    ReplayRequest request;
    request.view.width = 90;
    request.view.height = 40;
    for (const EyePath path : {EyePath::turntable, EyePath::sweep, EyePath::sway, EyePath::dolly})
        for (const std::optional<double> span : {std::optional<double>(), {50.0}}) {
            request.movement = {path, span, 5};
            request.view.eye = {20, -7, 300};
            const auto sideways = eyes_of(request, *upright.metadata);
            request.view.eye = turned(request.view.eye);
            const auto upwards = eyes_of(request, *lying.metadata);
            BOOST_REQUIRE(sideways.size() == upwards.size());
            for (std::size_t k = 0; k < upwards.size(); ++k) {
                const Eye requested = turned(sideways[k]);
                BOOST_TEST(std::fabs(requested.x - upwards[k].x) < 1e-9);
                BOOST_TEST(std::fabs(requested.y - upwards[k].y) < 1e-9);
                BOOST_TEST(std::fabs(requested.distance - upwards[k].distance) < 1e-9);
            }
        }
    const Eye middle{0, 0, 300};
    const auto row = contact_sheet_eyes(*lying.metadata, middle, 3, 1),
               column = contact_sheet_eyes(*lying.metadata, middle, 1, 3);
    BOOST_TEST(row[0].y < -1); // from below upwards; a column shows the view from above on top
    for (int k = 0; k < 3; ++k)
        BOOST_TEST(row[std::size_t(k)].y == column[std::size_t(2 - k)].y);
}

BOOST_AUTO_TEST_CASE(frames_of_perspective_views_are_the_upright_ones_turned)
{
    std::vector<Image> views;
    for (int k = 0; k < 5; ++k)
        views.push_back(pattern(60, 40, 0.2 * k));
    for (const double slant : slants) {
        const FrameMetadata m = *upright_frame(slant).metadata, lying = turned(m);
        const auto eyes = [](const FrameMetadata& g) {
            return EyeGrid{viewing_zone(g, g.aperture.distance), g.aperture.distance};
        };
        const auto requested = frame_from_eye_views(views, m, {5, 1}, eyes(m), 2),
                   found = frame_from_eye_views(turned(views), lying, {1, 5}, eyes(lying), 2);
        BOOST_TEST(differing(*found, turned(*requested)) < ties);
    }
}

BOOST_AUTO_TEST_CASE(quilts_rays_are_the_upright_ones_turned)
{
    const FrameMetadata m = *upright_frame(0).metadata, lying = turned(m);
    const auto camera = [](const FrameMetadata& g) {
        return IntegralCamera{
            SheetOptics(g.sheet, g.aperture), g.film, {}, LensMapping::automatic, {}, 1, 1, false};
    };
    // 4 x 1 tiles of 50 x 30 pixels; the lying ones' of 30 x 50, from below upwards
    const QuiltSampler sideways(camera(m), {4, 1}, 200, 30),
        upwards(camera(lying), {4, 1}, 120, 50);
    for (int view = 0; view < 4; ++view) {
        const auto a = sideways.ray({50.0 * view + 12.5, 7.5}),
                   b = upwards.ray({30.0 * view + 7.5, 37.5});
        BOOST_REQUIRE((a && b));
        const Vec2 eye = turned(a->aperture_point) - b->aperture_point;
        BOOST_TEST(length(eye) < 1e-9);
        BOOST_TEST(length(turned(Vec2{a->point.x, a->point.y}) - Vec2{b->point.x, b->point.y}) <
                   1e-9);
    }
}

BOOST_AUTO_TEST_CASE(panels_are_the_upright_ones_turned)
{
    std::vector<Image> views;
    for (int k = 0; k < 5; ++k)
        views.push_back(pattern(60, 40, 0.2 * k));
    for (const double slant : slants) {
        const FrameMetadata m = *upright_frame(slant).metadata;
        const auto panel = [](const FrameMetadata& g, const std::vector<Image>& pictures) {
            const double distance = g.aperture.distance;
            const auto mapping = mapping_of(g, {viewing_zone(g, distance), distance}, 2);
            const ViewRaster list(pictures, {int(pictures.size()), 1});
            Image image = panel_image(list, g.film.width, g.film.height);
            interlace(image, list, *mapping, {}, 2);
            return image;
        };
        BOOST_TEST(differing(panel(turned(m), turned(views)), turned(panel(m, views))) < ties);
    }
}

namespace {

/// Lying lenses turn the views within the set: pixel by pixel they equal the upright ones, at
/// turned places of the picture.
void have_equal_depth(const ViewSet& lying, const ViewSet& upright)
{
    BOOST_TEST(lying.turned);
    BOOST_TEST(!upright.turned);
    BOOST_REQUIRE(lying.width == upright.width);
    BOOST_REQUIRE(lying.height == upright.height);
    BOOST_REQUIRE(lying.others.size() == upright.others.size());
    for (const double x : {0, upright.width - 1})
        for (const double y : {0, upright.height - 1})
            BOOST_TEST(length(lying.places.at(x, y) - turned(upright.places.at(x, y))) < 1e-9);
    BOOST_TEST(lying.scale.has_value() == upright.scale.has_value());
    if (lying.scale)
        BOOST_TEST(lying.scale->ratio == upright.scale->ratio, boost::test_tools::tolerance(1e-9));
    for (const bool by_rays : {false, true}) {
        const auto measured = [&](const ViewSet& views) {
            return by_rays ? *ray_trace(views, {}, 2, {}) : *multibaseline(views, {}, 2, {});
        };
        const DepthMap a = measured(lying), b = measured(upright);
        int differ = 0, known = 0;
        for (std::size_t k = 0; k < a.disparity.size(); ++k) {
            if (std::isnan(a.disparity[k]) != std::isnan(b.disparity[k]))
                ++differ;
            if (std::isnan(a.disparity[k]) || std::isnan(b.disparity[k]))
                continue;
            ++known;
            differ += std::fabs(a.disparity[k] - b.disparity[k]) > 0.01;
        }
        BOOST_TEST(known > 0.7 * double(a.disparity.size()));
        BOOST_TEST(differ < 0.01 * known, differ << " of " << known);
    }
}

/// A frame of two slopes of waves, the upper one in front of the sheet, the lower one behind it.
Frame frame_of_slopes(double slant)
{
    Frame frame = upright_frame(slant);
    const FrameMetadata& m = *frame.metadata;
    const SheetOptics optics(m.sheet, m.aperture);
    for (int y = 0; y < m.film.height; ++y)
        for (int x = 0; x < m.film.width; ++x) {
            const auto ray = optics
                                 .map(film_from_pixel(m.film, {x + 0.5, y + 0.5}),
                                      LensMapping::automatic)
                                 .ray;
            if (!ray)
                continue;
            const double depth = y < m.film.height / 2 ? -25 : 30,
                         at = ray->pole.x + depth / ray->direction.z * ray->direction.x;
            const auto wave = [&](double length, double tilt) {
                return float(0.5 + 0.45 * std::sin(2 * pi * (at + tilt * ray->pole.y) / length));
            };
            store_pixel(frame.image, x, y, {wave(5, 0.3), wave(7, -0.2), wave(11, 0.1), 1});
        }
    return frame;
}

} // namespace

BOOST_AUTO_TEST_CASE(depth_of_frames_is_the_upright_ones_turned)
{
    for (const double slant : slants) {
        const Frame upright = frame_of_slopes(slant);
        have_equal_depth(view_set(turned(upright), 2, {}), view_set(upright, 2, {}));
    }
}

BOOST_AUTO_TEST_CASE(depth_of_a_column_of_views_is_that_of_a_row_turned)
{
    std::vector<Image> row;
    for (int k = 0; k < 7; ++k) {
        Image view = make_image<std::uint8_t>(80, 50, 3, Encoding());
        for (int y = 0; y < 50; ++y)
            for (int x = 0; x < 80; ++x) {
                const double at = x + (y < 25 ? 1.3 : -0.7) * (k - 3);
                const auto wave = [&](double a, double b) {
                    return float(0.5 + 0.45 * std::sin(a * at + b * y));
                };
                store_pixel(view, x, y, {wave(.9, .2), wave(.6, -.1), wave(.3, .3), 1});
            }
        row.push_back(view);
    }
    have_equal_depth(view_set(turned(row), {1, 7}, std::nullopt),
                     view_set(row, {7, 1}, std::nullopt));
    const ViewEyes of_row{{10, 10}, 400, 160}, of_column{{10, 10}, 400, 100};
    have_equal_depth(view_set(turned(row), {1, 7}, of_column), view_set(row, {7, 1}, of_row));
}

BOOST_AUTO_TEST_SUITE_END()
