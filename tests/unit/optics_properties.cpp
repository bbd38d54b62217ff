// SPDX-License-Identifier: AGPL-3.0-or-later
// What holds of every lens mapping, over random sheets of optics.md section 7's ranges: accurate = exhaustive,
// closest is part of auto, symmetries, scaling, order, and that nothing is too hostile to be answered.
#include "integral/optics/camera.h"
#include "tests/unit/optics_sheets.h"

#include <boost/test/unit_test.hpp>

#include <array>
#include <limits>

using namespace integral;
using random_sheets::Generator;

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr std::array<LensMapping, 4> mappings = {LensMapping::closest, LensMapping::automatic, LensMapping::accurate,
                                                 LensMapping::exhaustive};

/// A sheet and its aperture.
struct System {
    LensSheet sheet;
    Aperture aperture;
    SheetOptics optics() const { return SheetOptics(sheet, aperture); }
    bool lenticular() const { return sheet.arrangement == Arrangement::lenticular; }
    /// How much the map of offsets to aperture points stretches at least.
    double stretch() const { return 1 + sheet.ior * aperture.distance / sheet.thickness; }
    double total_reflection() const { return sheet.thickness / std::sqrt((sheet.ior - 1) * (sheet.ior + 1)); }
};

std::ostream& operator<<(std::ostream& out, const System& s)
{
    return out << s.sheet << " aperture " << s.aperture.distance << ": " << s.aperture.width << " x " << s.aperture.height
               << (s.aperture.shape == ApertureShape::ellipse ? ", ellipse" : "");
}

/// Apertures from a twentieth of what fills a lens to twenty times that, now and then without limit one way or both.
System random_system(Generator& random)
{
    System s;
    s.sheet = random.sheet();
    if (random.one_in(2))
        s.sheet.thickness = s.sheet.pitch * random.log_between(0.3, 30);
    s.aperture.distance = random.one_in(2) ? random.distance() : s.sheet.thickness * random.log_between(0.5, 3000);
    const double filling = s.sheet.pitch * s.stretch();
    const auto extent = [&] {
        return filling * (random.one_in(2) ? random.between(0.9, 1.2) : random.log_between(0.05, 20));
    };
    s.aperture.width = extent();
    s.aperture.height = random.one_in(3) ? extent() : s.aperture.width;
    if (random.one_in(12))
        (random.one_in(2) ? s.aperture.width : s.aperture.height) = random.one_in(2) ? infinity : 1e12;
    s.aperture.shape = random.one_in(3) ? ApertureShape::ellipse : ApertureShape::rectangle;
    return s;
}

/// How far from a film point a lens can be that sends its light through the aperture.
double farthest_lens(const System& s, Vec2 film_point)
{
    const double circumradius = 0.5 * std::hypot(s.aperture.width, s.aperture.height);
    return std::min(s.total_reflection(), (circumradius + length(film_point)) / s.stretch());
}

Vec2 direction_at(double angle) { return {std::cos(angle), std::sin(angle)}; }

/// The film point whose light goes through `pole` to a point of the aperture's plane.
Vec2 film_point_through(const SheetOptics& optics, Vec2 pole, Vec2 aperture_point)
{
    const Vec2 way = aperture_point - pole;
    const double d = optics.aperture().distance, length_3 = std::sqrt(dot(way, way) + d * d);
    return pole - offset_from_direction(optics.medium(), {way.x / length_3, way.y / length_3, -d / length_3});
}

/// A system whose decisions hardly depend on rounding.
System plain_system(Generator& random)
{
    System s = random_system(random);
    s.sheet.thickness = s.sheet.pitch * random.log_between(0.5, 20);
    s.aperture.distance = s.sheet.thickness * random.log_between(2, 300);
    const double filling = s.sheet.pitch * s.stretch();
    s.aperture.width = filling * random.between(0.3, 3);
    s.aperture.height = filling * random.between(0.3, 3);
    return s;
}

/// Anywhere up to 1e6 lenses from the centre, as far as a search of all lenses stays small; or within 1e-8 of where a
/// decision falls: where two lenses are equally near, where the light meets the aperture's edge, and where two lenses'
/// aperture points are equally near to its centre.
Vec2 random_film_point(Generator& random, const System& s, const SheetOptics& optics)
{
    const double pitch = s.sheet.pitch, most = 30 * pitch;
    double farthest = 1e6 * pitch;
    if (s.total_reflection() > most)
        farthest = std::min(farthest, most * s.stretch());
    const double far = random.log_between(1e-3, std::max(1.0, farthest / pitch)) * pitch;
    const Vec2 anywhere = far * direction_at(random.between(0, 6.3));
    const double near_0 = random.one_in(4) ? 0 : (random.one_in(2) ? -1 : 1) * random.log_between(1e-11, 1e-8);
    if (random.one_in(2))
        return anywhere;
    const Lattice& lattice = optics.lattice();
    const LensIndex lens = lattice.nearest(anywhere), other{lens.i + 1, lens.j - (!s.lenticular() && random.one_in(2))};
    const Vec2 pole = lattice.pole(lens), way = lattice.pole(other) - pole;
    if (random.one_in(3))
        return pole + (0.5 + near_0) * way + (random.one_in(2) ? 0 : random.between(-0.6, 0.6)) * Vec2{-way.y, way.x};
    const double widest = 1e6 * pitch, x = std::min(s.aperture.width, widest), y = std::min(s.aperture.height, widest);
    if (random.one_in(2)) {
        Vec2 edge{0.5 * x * (1 + near_0), y * random.between(-0.5, 0.5)};
        if (!slit_is_horizontal(s.sheet) || (!s.lenticular() && random.one_in(2)))
            edge = {x * random.between(-0.5, 0.5), 0.5 * y * (1 + near_0)};
        if (s.lenticular())
            (slit_is_horizontal(s.sheet) ? edge.y : edge.x) = 0;
        return film_point_through(optics, pole, edge);
    }
    Vec2 low = film_point_through(optics, pole, {0, 0}), high = film_point_through(optics, pole + way, {0, 0});
    for (int step = 0; step < 60; ++step) {
        const Vec2 middle = 0.5 * (low + high);
        const auto a = optics.ray_through(middle, lens), b = optics.ray_through(middle, other);
        if (!a || !b)
            return middle;
        (length(a->aperture_point) < length(b->aperture_point) ? low : high) = middle;
    }
    return low + near_0 * way;
}

bool equal(Vec2 a, Vec2 b) { return a.x == b.x && a.y == b.y; }

/// The same lens, and bit for bit the same ray.
bool equal(const LensRay& a, const LensRay& b)
{
    return a.lens == b.lens && equal(a.pole, b.pole) && equal(a.aperture_point, b.aperture_point)
        && a.direction.x == b.direction.x && a.direction.y == b.direction.y && a.direction.z == b.direction.z;
}

bool equal(const MappedPoint& a, const MappedPoint& b)
{
    return a.ray.has_value() == b.ray.has_value() && (!a.ray || equal(*a.ray, *b.ray));
}

/// Whether two systems make the same of corresponding film points, but for rounding: `b`'s rays, taken back by
/// `undo`, are `a`'s.
template <class Undo> bool alike(const MappedPoint& a, const MappedPoint& b, const System& s, Undo undo)
{
    if (!a.ray || !b.ray)
        return a.ray.has_value() == b.ray.has_value();
    const Vec2 pole = a.ray->pole - undo(b.ray->pole), there = a.ray->aperture_point - undo(b.ray->aperture_point);
    return length(pole) <= 1e-6 * s.sheet.pitch
        && length(there) <= 1e-6 * (s.sheet.pitch * s.stretch() + length(a.ray->aperture_point));
}

/// A film point at a random place of the sheet, at most `lenses` from its centre.
Vec2 plain_film_point(Generator& random, const System& s, double lenses)
{
    return random.between(0, lenses) * s.sheet.pitch * direction_at(random.between(0, 6.3));
}

} // namespace

BOOST_AUTO_TEST_SUITE(optics_properties)

BOOST_AUTO_TEST_CASE(accurate_is_exhaustive_and_closest_is_part_of_automatic)
{
    Generator random(77);
    const int systems = random_sheets::count(10000, 1000000);
    long compared = 0, imaged = 0, searched = 0, rule = 0;
    for (int k = 0; k < systems; ++k) {
        const System s = random_system(random);
        const SheetOptics optics = s.optics();
        for (int i = 0; i < 6; ++i) {
            const Vec2 point = random_film_point(random, s, optics);
            BOOST_TEST_CONTEXT(s << " film point <" << point.x << ", " << point.y << ">")
            {
                const MappedPoint closest = optics.map(point, LensMapping::closest);
                const MappedPoint automatic = optics.map(point, LensMapping::automatic);
                const MappedPoint accurate = optics.map(point, LensMapping::accurate);
                // where all light is within rounding of total reflection, the reason for none is anybody's guess
                const bool grazing = length(point) > 1e4 * s.aperture.distance;
                if (farthest_lens(s, point) < 30 * s.sheet.pitch) {
                    const MappedPoint exhaustive = optics.map(point, LensMapping::exhaustive);
                    BOOST_TEST_REQUIRE(equal(accurate, exhaustive));
                    BOOST_TEST((grazing || accurate.empty == exhaustive.empty));
                    ++compared;
                }
                BOOST_TEST_REQUIRE(equal(automatic, closest.ray ? closest : accurate));
                if (farthest_lens(s, {0, 0}) < 60 * s.sheet.pitch) // farther, a search may give up
                    BOOST_TEST_REQUIRE(automatic.ray.has_value() == accurate.ray.has_value());
                BOOST_TEST(automatic.searched == !closest.ray);
                BOOST_TEST((grazing || accurate.empty == automatic.empty));
                BOOST_TEST((grazing || accurate.ray || closest.empty == accurate.empty));
                BOOST_TEST(accurate.searched);
                for (const MappedPoint& mapped : {closest, automatic, accurate})
                    BOOST_TEST((mapped.empty == Empty::none) == mapped.ray.has_value());
                rule += closest.ray.has_value();
                imaged += accurate.ray.has_value();
                searched += automatic.ray && !closest.ray;
            }
        }
    }
    // it has looked at points of every kind
    BOOST_TEST(compared > 4 * systems);
    BOOST_TEST(imaged > 2 * systems);
    BOOST_TEST(rule > systems);
    BOOST_TEST(searched > systems / 10);
}

BOOST_AUTO_TEST_CASE(exhaustive_is_the_rule_written_down)
{
    // of the lenses that pass, the one nearest to the centre; of those within 1e-9 pitches of that, the preferred
    Generator random(76);
    const int systems = random_sheets::count(2000, 100000);
    int imaged = 0, tied = 0;
    for (int k = 0; k < systems; ++k) {
        System s = plain_system(random);
        s.aperture.width = s.aperture.height = std::max(s.aperture.width, s.aperture.height);
        if (random.one_in(2)) { // the centre of the sheet between lenses: an axis of symmetry
            const Lattice lattice(s.sheet);
            const bool both = random.one_in(2) && !s.lenticular();
            s.sheet.offset = 0.5 * s.sheet.pitch * (lattice.across() + (both ? 1.0 : 0.0) * lattice.along());
        }
        const SheetOptics optics = s.optics();
        const Lattice& lattice = optics.lattice();
        const double near_0 = random.one_in(2) ? 0 : random.log_between(1e-13, 1e-9) * s.sheet.pitch;
        const Vec2 point = random.one_in(2) ? near_0 * direction_at(random.between(0, 6.3))
                                            : random_film_point(random, s, optics);
        if (farthest_lens(s, point) > 20 * s.sheet.pitch)
            continue;
        const double tie = lattice.tie_tolerance();
        std::vector<LensRay> passing;
        double least = infinity;
        lattice.for_each_within(point, farthest_lens(s, point) + 1e-3 * s.sheet.pitch, [&](LensIndex lens) {
            const auto ray = optics.ray_through(point, lens);
            Aperture slit = s.aperture;
            if (s.lenticular())
                (slit_is_horizontal(s.sheet) ? slit.height : slit.width) = infinity;
            if (!ray || !contains(slit, ray->aperture_point))
                return;
            passing.push_back(*ray);
            least = std::min(least, length(ray->aperture_point));
        });
        std::optional<LensRay> best;
        int candidates = 0;
        for (const LensRay& ray : passing)
            if (length(ray.aperture_point) <= least + tie) {
                ++candidates;
                if (!best || lattice.preferred(ray.lens, best->lens))
                    best = ray;
            }
        imaged += best.has_value();
        tied += candidates > 1;
        const MappedPoint mapped = optics.map(point, LensMapping::exhaustive);
        BOOST_TEST_CONTEXT(s << " film point <" << point.x << ", " << point.y << ">")
        {
            BOOST_TEST_REQUIRE(mapped.ray.has_value() == best.has_value());
            BOOST_TEST((!best || equal(*mapped.ray, *best)));
            BOOST_TEST(equal(optics.map(point, LensMapping::accurate), mapped));
        }
    }
    BOOST_TEST(imaged > systems / 2);
    BOOST_TEST(tied > systems / 20);
}

BOOST_AUTO_TEST_CASE(aperture_points_of_two_lenses_keep_apart)
{
    // What the searches rest on (the head of lens_mapping.cpp).
    Generator random(80);
    const int systems = random_sheets::count(20000, 1000000);
    int pairs = 0;
    for (int k = 0; k < systems; ++k) {
        const System s = random_system(random);
        const SheetOptics optics = s.optics();
        const double away = std::min(s.total_reflection(), 1e3 * s.sheet.pitch);
        const Vec2 point = plain_film_point(random, s, 1000);
        const auto lens = [&] {
            return optics.lattice().nearest(point + random.between(0, away) * direction_at(random.between(0, 6.3)));
        };
        const LensIndex one = lens();
        const LensIndex two = random.one_in(2) ? lens() : LensIndex{one.i + 1, one.j};
        const auto a = optics.ray_through(point, one), b = optics.ray_through(point, two);
        if (!a || !b || one == two)
            continue;
        ++pairs;
        const Vec2 way = optics.lattice().pole(two) - optics.lattice().pole(one);
        const Vec2 there = b->aperture_point - a->aperture_point;
        const double far = length(a->aperture_point) + length(b->aperture_point) + length(point);
        BOOST_TEST_CONTEXT(s << " film point <" << point.x << ", " << point.y << "> lenses " << one.i << ", " << one.j
                             << " and " << two.i << ", " << two.j)
        {
            if (s.lenticular()) {
                const double g = dot(optics.slit().normal, optics.slit().axis);
                BOOST_TEST(length(there) >= s.stretch() * length(way) * 2 / (1 + g) * (1 - 1e-9) - 1e-9 * far);
            } else
                BOOST_TEST(dot(way, there) >= length(way) * (s.stretch() * length(way) * (1 - 1e-9) - 1e-9 * far));
        }
    }
    BOOST_TEST(pairs > systems / 4);
}

BOOST_AUTO_TEST_CASE(mirrored_and_turned_sheets_image_mirrored_and_turned_points)
{
    Generator random(79);
    const int systems = random_sheets::count(3000, 300000);
    long imaged = 0;
    for (int k = 0; k < systems; ++k) {
        const System s = plain_system(random);
        const SheetOptics optics = s.optics();
        System mirrored = s, turned = s, quarter = s, sixth = s;
        mirrored.sheet.slant = -s.sheet.slant;
        mirrored.sheet.offset.x = -s.sheet.offset.x;
        turned.sheet.offset = -1 * s.sheet.offset;
        quarter.sheet.offset = {-s.sheet.offset.y, s.sheet.offset.x};
        std::swap(quarter.aperture.width, quarter.aperture.height);
        const Vec2 x = direction_at(std::acos(-1.0) / 3), y{-x.y, x.x};
        sixth.aperture.shape = ApertureShape::ellipse;
        sixth.aperture.height = sixth.aperture.width;
        const SheetOptics round = sixth.optics();
        sixth.sheet.offset = s.sheet.offset.x * x + s.sheet.offset.y * y;
        const SheetOptics mirrored_optics = mirrored.optics(), turned_optics = turned.optics();
        const SheetOptics quarter_optics = quarter.optics(), sixth_optics = sixth.optics();
        for (int i = 0; i < 10; ++i) {
            const Vec2 point = plain_film_point(random, s, 40);
            BOOST_TEST_CONTEXT(s << " film point <" << point.x << ", " << point.y << ">")
            for (const LensMapping mapping : mappings) {
                const MappedPoint here = optics.map(point, mapping);
                imaged += here.ray.has_value();
                BOOST_TEST(alike(here, mirrored_optics.map({-point.x, point.y}, mapping), s,
                                 [](Vec2 v) { return Vec2{-v.x, v.y}; }));
                BOOST_TEST(alike(here, turned_optics.map(-1 * point, mapping), s, [](Vec2 v) { return -1 * v; }));
                if (s.sheet.arrangement == Arrangement::square)
                    BOOST_TEST(alike(here, quarter_optics.map({-point.y, point.x}, mapping), s,
                                     [](Vec2 v) { return Vec2{v.y, -v.x}; }));
                if (s.sheet.arrangement == Arrangement::hexagonal)
                    BOOST_TEST(alike(round.map(point, mapping), sixth_optics.map(point.x * x + point.y * y, mapping), s,
                                     [&](Vec2 v) { return Vec2{dot(x, v), dot(y, v)}; }));
            }
        }
    }
    BOOST_TEST(imaged > systems * 10);
}

BOOST_AUTO_TEST_CASE(all_lengths_scale_together)
{
    Generator random(81);
    const int systems = random_sheets::count(3000, 300000);
    long imaged = 0;
    for (int k = 0; k < systems; ++k) {
        const bool by_two = random.one_in(2); // bit for bit
        const System s = by_two ? random_system(random) : plain_system(random);
        const double scale = by_two ? std::ldexp(1.0, int(random.between(-20, 20))) : random.log_between(1e-4, 1e4);
        System scaled = s;
        scaled.sheet.pitch *= scale;
        scaled.sheet.thickness *= scale;
        scaled.sheet.offset = scale * s.sheet.offset;
        scaled.aperture = {scale * s.aperture.distance, scale * s.aperture.width, scale * s.aperture.height,
                           s.aperture.shape};
        const SheetOptics optics = s.optics(), scaled_optics = scaled.optics();
        for (int i = 0; i < 6; ++i) {
            const Vec2 point = by_two ? random_film_point(random, s, optics) : plain_film_point(random, s, 40);
            BOOST_TEST_CONTEXT(s << " film point <" << point.x << ", " << point.y << "> scale " << scale)
            for (const LensMapping mapping : {LensMapping::closest, LensMapping::automatic, LensMapping::accurate}) {
                const MappedPoint here = optics.map(point, mapping);
                MappedPoint there = scaled_optics.map(scale * point, mapping);
                imaged += here.ray.has_value();
                if (by_two && there.ray) {
                    there.ray->pole = (1 / scale) * there.ray->pole;
                    there.ray->aperture_point = (1 / scale) * there.ray->aperture_point;
                }
                const auto back = [&](Vec2 v) { return (1 / scale) * v; };
                BOOST_TEST((by_two ? equal(here, there) : alike(here, there, s, back)));
                BOOST_TEST((here.empty == there.empty));
            }
        }
    }
    BOOST_TEST(imaged > systems * 3);
}

BOOST_AUTO_TEST_CASE(scene_and_units_scale_together)
{
    Generator random(82);
    const int cameras = random_sheets::count(1000, 100000);
    long lines = 0;
    for (int k = 0; k < cameras; ++k) {
        CameraParameters parameters;
        parameters.sheet.arrangement = Arrangement(random.between(0, 3));
        parameters.sheet.slant = random.between(-80, 80);
        parameters.film.units_per_mm = random.log_between(1e-4, 1e4);
        if (random.one_in(2))
            parameters.depth_range = Vec2{random.between(0, 100), random.between(1, 100)};
        const double unit = *parameters.film.units_per_mm;
        const auto vector = [&](double size) {
            return size * unit * Vec3{random.between(-1, 1), random.between(-1, 1), random.between(-1, 1)};
        };
        const ViewFrame view{vector(1e3), vector(300), vector(100), vector(100), random.between(0.5, 2)};
        const bool by_two = random.one_in(2); // bit for bit
        const double scale = by_two ? std::ldexp(1.0, int(random.between(-6, 6))) : random.log_between(1e-2, 1e2);
        const auto camera_scaled = [&](double by) -> std::optional<IntegralCamera> {
            CameraParameters p = parameters;
            p.film.units_per_mm = by * unit;
            try {
                return make_camera(p, {by * view.location, by * view.direction, by * view.right, by * view.up,
                                       view.sheet_distance_ratio}, 600, 400);
            } catch (const std::invalid_argument&) { // three vectors nearly in one plane
                return std::nullopt;
            }
        };
        const auto here = camera_scaled(1), there = camera_scaled(scale);
        BOOST_TEST_REQUIRE(here.has_value() == there.has_value());
        if (!here)
            continue;
        for (int i = 0; i < 20; ++i) {
            const Vec2 pixel{random.between(0, 600), random.between(0, 400)};
            const auto a = here->optics.map(film_from_pixel(here->film, pixel), here->mapping);
            const auto b = there->optics.map(film_from_pixel(there->film, pixel), there->mapping);
            BOOST_TEST_REQUIRE(a.ray.has_value() == b.ray.has_value());
            if (!a.ray)
                continue;
            ++lines;
            const SightLine line = sight_line(*here, pole_beam(*a.ray)), scaled = sight_line(*there, pole_beam(*b.ray));
            const double far = scale * (length(line.origin) + length(view.location));
            const double off = length(scaled.origin - scale * line.origin) / far;
            const double turned = length(scaled.direction - line.direction);
            const double longer = std::fabs(scaled.length - scale * line.length) / (scale * unit);
            BOOST_TEST(off <= (by_two ? 0 : 1e-11));
            BOOST_TEST(turned <= (by_two ? 0 : 1e-11));
            BOOST_TEST(longer <= (by_two ? 0 : 1e-9 * line.length / unit));
        }
    }
    BOOST_TEST(lines > cameras * 5);
}

BOOST_AUTO_TEST_CASE(aperture_points_move_against_the_film_point)
{
    // A goes one way along a line when the film point goes the other way: through one lens, as far as its light leaves.
    Generator random(83);
    const int systems = random_sheets::count(2000, 200000);
    for (int k = 0; k < systems; ++k) {
        System s = random_system(random);
        if (s.lenticular())
            s.sheet.slant = 0; // beyond that, not where refraction is strong
        const SheetOptics optics = s.optics();
        const LensIndex lens = optics.lattice().nearest(plain_film_point(random, s, 100));
        const Vec2 pole = optics.lattice().pole(lens);
        const Vec2 way = s.lenticular() ? Vec2{1, 0} : direction_at(random.between(0, 6.3));
        const double beside = random.between(-0.5, 0.5) * s.sheet.pitch;
        const double reach = std::min(2 * s.sheet.pitch, s.total_reflection());
        double before = infinity;
        for (int i = -50; i <= 50; ++i) {
            const auto ray = optics.ray_through(pole + (i * reach / 50) * way + beside * Vec2{-way.y, way.x}, lens);
            if (!ray)
                continue;
            const double now = dot(way, ray->aperture_point);
            BOOST_TEST_REQUIRE(now < before, s);
            before = now;
        }
    }
}

BOOST_AUTO_TEST_CASE(lenses_stand_in_the_order_of_their_film_points)
{
    // Without a limit to the aperture, the lenses taken along a row of the film follow each other; each is displaced
    // outwards, the farther the more (optics.md section 4).
    Generator random(84);
    const int systems = random_sheets::count(500, 50000);
    for (int k = 0; k < systems; ++k) {
        System s = plain_system(random);
        s.sheet.slant = 0;
        s.sheet.offset = {0, 0};
        s.aperture = {std::max(s.aperture.distance, 100 * s.sheet.pitch), infinity, infinity}; // up to 27 degrees
        const SheetOptics optics = s.optics();
        std::int64_t last = 0;
        for (int i = 0; i <= 1000; ++i) {
            const Vec2 point{i * 0.05 * s.sheet.pitch, 0};
            const auto mapped = optics.map(point, LensMapping::accurate);
            if (!mapped.ray)
                continue; // beyond total reflection
            BOOST_TEST_REQUIRE(mapped.ray->lens.j == 0, s);
            BOOST_TEST_REQUIRE(mapped.ray->lens.i >= last, s);
            last = mapped.ray->lens.i;
            BOOST_TEST(optics.lattice().nearest(point).i >= last);
        }
        BOOST_TEST(last > 10, s);
        double displaced = 0;
        for (int i = 1; i < 50; ++i) {
            const Vec2 pole = optics.lattice().pole({i, 0});
            const double now = film_point_through(optics, pole, {0, 0}).x - pole.x;
            BOOST_TEST_REQUIRE(now > displaced, s);
            BOOST_TEST(optics.map(pole + Vec2{now, 0}, LensMapping::accurate).ray->lens.i == i);
            displaced = now;
        }
    }
}

BOOST_AUTO_TEST_CASE(hostile_values_are_answered)
{
    Generator random(85);
    const double nan = std::numeric_limits<double>::quiet_NaN();
    long points = 0, imaged = 0;
    for (int arrangement = 0; arrangement < 3; ++arrangement)
        for (double thickness : {0.02, 2.4, 1e4})
            for (double ior : {1.0, 1 + 1e-12, 1.001, 1.6, 4.0})
                for (double slant : {0.0, 18.4349, -89.99})
                    for (double distance : {1e-2, 300.0, 1e9})
                        for (double extent : {0.0, 1e-3, 1.0, 1e12, infinity}) {
                            System s{{Arrangement(arrangement), 1, thickness, ior, slant, {0.5, 0}}, {distance, extent, extent}};
                            if (extent == 1) // one of them fills, the other is without limit
                                s.aperture = {distance, s.stretch(), infinity};
                            s.aperture.shape = random.one_in(2) ? ApertureShape::ellipse : ApertureShape::rectangle;
                            const SheetOptics optics = s.optics();
                            for (double far : {0.0, 1e-300, 0.37, 100.0, 1e6, 1e12, 1e13, 1e300, infinity, nan}) {
                                const Vec2 point{far, random.one_in(2) ? 0.3 * far : random.between(-1, 1)};
                                const MappedPoint closest = optics.map(point, LensMapping::closest);
                                const MappedPoint automatic = optics.map(point, LensMapping::automatic);
                                const MappedPoint accurate = optics.map(point, LensMapping::accurate);
                                BOOST_TEST_REQUIRE(equal(automatic, closest.ray ? closest : accurate), s << " film point <" << point.x << ", " << point.y << ">");
                                for (const MappedPoint& mapped : {closest, automatic, accurate}) {
                                    ++points;
                                    BOOST_TEST((mapped.empty == Empty::none) == mapped.ray.has_value());
                                    if (!mapped.ray)
                                        continue;
                                    ++imaged;
                                    BOOST_TEST(far < 1e9);
                                    const LensRay& ray = *mapped.ray;
                                    for (double value : {ray.pole.x, ray.pole.y, ray.aperture_point.x, ray.aperture_point.y})
                                        BOOST_TEST(std::isfinite(value), s);
                                    BOOST_TEST(std::fabs(length(ray.direction) - 1) < 1e-9, s);
                                    BOOST_TEST(ray.direction.z < 0, s);
                                }
                            }
                        }
    BOOST_TEST(imaged > points / 10);
}

BOOST_AUTO_TEST_SUITE_END()
