// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/analysis/lattice_search.h"

#include "integral/analysis/border_fit.h"
#include "integral/analysis/edge_response.h"
#include "integral/analysis/lens_borders.h"
#include "integral/analysis/spectrum.h"

#include <algorithm>
#include <cmath>
#include <random>
#include <stdexcept>

namespace integral {
namespace {

constexpr double most_pixels_a_lens = 32; // of the reduced scan: finer tells no more of borders
constexpr double least_pixels_a_lens = 4;
constexpr int spectrum_side = 2048;
constexpr int most_borders = 300000;
constexpr int candidates = 3;

/// The frequencies (cycles/mm) at which a sheet's micro-images repeat, on the axis.
std::vector<Vec2> frequencies_of(const LensSheet& sheet, double distance)
{
    const Lattice lattice(sheet);
    const double pitch = sheet.pitch * (1 + sheet.thickness / (sheet.ior * distance));
    const Vec2 u = (1 / pitch) * lattice.across(), v = (1 / pitch) * lattice.along();
    switch (sheet.arrangement) {
    case Arrangement::lenticular: return {u};
    case Arrangement::square: return {u, v};
    case Arrangement::hexagonal: break;
    }
    const double row = 1 / std::sqrt(3.0);
    return {u + row * v, u - row * v, (2 * row) * v};
}

Vec2 frequency_in_scan(Vec2 frequency, const ScanMap& map)
{
    const double c = std::cos(map.rotation), s = std::sin(map.rotation);
    return {(c * frequency.x - s * frequency.y) / map.scale.x,
            -(s * frequency.x + c * frequency.y) / map.scale.y};
}

struct Candidate {
    ScanMap map;
    double score = 0;
};

/// The likeliest turns and scales by the spectrum, best first.
std::vector<Candidate> by_spectrum(const Spectrum& spectrum, const LatticeSearch& search,
                                   const ScanMap& about)
{
    constexpr int harmonics = 3;
    const std::vector<Vec2> frequencies = frequencies_of(search.sheet, search.aperture.distance);
    // Steps that move the highest harmonic by half of what the window tells apart.
    const double pixels = search.sheet.pitch * std::min(about.scale.x, about.scale.y);
    const double step = 0.5 * pixels / (harmonics * spectrum.extent());
    const int scales = 2 * int(std::ceil(search.scale_range / step)) + 1,
              turns = 2 * int(std::ceil(search.turn_range / step)) + 1;
    std::vector<Candidate> grid;
    for (int j = 0; j < turns; ++j)
        for (int i = 0; i < scales; ++i) {
            Candidate c{about, 0};
            const double factor = 1 + search.scale_range *
                                          (scales > 1 ? 2.0 * i / (scales - 1) - 1 : 0);
            c.map.scale = factor * about.scale;
            c.map.rotation += search.turn_range * (turns > 1 ? 2.0 * j / (turns - 1) - 1 : 0);
            for (const Vec2 frequency : frequencies)
                for (int h = 1; h <= harmonics; ++h)
                    c.score += std::sqrt(
                        spectrum.power(frequency_in_scan(double(h) * frequency, c.map)));
            grid.push_back(c);
        }
    std::vector<Candidate> peaks;
    for (int j = 0; j < turns; ++j)
        for (int i = 0; i < scales; ++i) {
            bool highest = true;
            for (int dj = -2; dj <= 2; ++dj)
                for (int di = -2; di <= 2; ++di)
                    if (j + dj >= 0 && j + dj < turns && i + di >= 0 && i + di < scales)
                        highest = highest && grid[(j + dj) * scales + i + di].score <=
                                                 grid[j * scales + i].score;
            if (highest)
                peaks.push_back(grid[j * scales + i]);
        }
    std::sort(peaks.begin(), peaks.end(),
              [](const Candidate& a, const Candidate& b) { return a.score > b.score; });
    peaks.resize(std::min<std::size_t>(peaks.size(), candidates));
    return peaks;
}

std::vector<Vec2> those_within(const std::vector<Vec2>& points, double radius, std::size_t most)
{
    std::vector<Vec2> inside;
    for (const Vec2 point : points)
        if (length(point) <= radius)
            inside.push_back(point);
    if (inside.size() > most) {
        std::vector<Vec2> some;
        for (std::size_t k = 0; k < most; ++k)
            some.push_back(inside[k * inside.size() / most]);
        return some;
    }
    return inside;
}

/// The middle, of those within a cell of the map's, with the most edge on the borders.
ScanMap best_middle(const Plane& edges, const std::vector<Vec2>& points, const LensSheet& sheet,
                    const ScanMap& map)
{
    constexpr int steps = 12;
    const Lattice lattice(sheet);
    const bool lenticular = sheet.arrangement == Arrangement::lenticular;
    ScanMap best = map;
    double most = -1e30;
    for (int j = 0; j < (lenticular ? 1 : steps); ++j)
        for (int i = 0; i < steps; ++i) {
            const double u = (i + 0.5) / steps - 0.5, v = lenticular ? 0 : (j + 0.5) / steps - 0.5;
            ScanMap moved = map;
            moved.middle = scan_from_film(map, (u * lattice.pitch()) * lattice.across() +
                                                   (v * lattice.row_spacing()) * lattice.along());
            const double edge = edge_on_borders(edges, points, moved);
            if (edge > most) {
                most = edge;
                best = moved;
            }
        }
    return best;
}

MapChange change_between(const ScanMap& from, const ScanMap& to)
{
    return {std::log(to.scale.x / from.scale.x), std::log(to.scale.y / from.scale.y),
            to.rotation - from.rotation, to.middle.x - from.middle.x, to.middle.y - from.middle.y};
}

/// Whether a fit has stayed where it was sent to look. Little more than the range is left to it,
/// and scales across and down that differ by no more than a scanner's.
bool is_in_range(const LatticeSearch& search, const ScanMap& about, const ScanMap& map)
{
    constexpr double margin = 0.01, most_difference = 0.03;
    const double x = map.scale.x / about.scale.x, y = map.scale.y / about.scale.y;
    return std::fabs(x - 1) < search.scale_range + margin &&
           std::fabs(y - 1) < search.scale_range + margin &&
           std::fabs(x / y - 1) < most_difference &&
           std::fabs(map.rotation - about.rotation) < search.turn_range + margin;
}

/// How far the edge on the borders is above what it is for maps at random in the range of the
/// search, in their standard deviations.
double significance_of(const Plane& edges, const std::vector<Vec2>& points,
                       const LatticeSearch& search, const ScanMap& about, const ScanMap& best)
{
    constexpr int trials = 200;
    const Lattice lattice(search.sheet);
    std::mt19937 random(1);
    std::uniform_real_distribution<double> either(-1, 1);
    double sum = 0, squares = 0;
    for (int k = 0; k < trials; ++k) {
        ScanMap map = about;
        map.scale = (1 + search.scale_range * either(random)) * map.scale;
        map.rotation += search.turn_range * either(random);
        map.middle = scan_from_film(map,
                                    (0.5 * lattice.pitch()) * Vec2{either(random), either(random)});
        const double edge = edge_on_borders(edges, points, map);
        sum += edge;
        squares += edge * edge;
    }
    const double mean = sum / trials, variance = squares / trials - mean * mean;
    return variance > 0 ? (edge_on_borders(edges, points, best) - mean) / std::sqrt(variance) : 0;
}

} // namespace

std::optional<FoundLattice> find_lattice(const Image& scan, const LatticeSearch& search,
                                         int threads, const Progress& progress)
{
    const auto follow = [&](int done) { return !progress || progress(done, 10); };
    const double full_pixels = search.sheet.pitch *
                               std::min(search.about.scale.x, search.about.scale.y);
    if (!(full_pixels >= least_pixels_a_lens))
        throw std::invalid_argument("a lens has " + std::to_string(full_pixels) +
                                    " of the scan's pixels; scan it finer, with 4 a lens or more");
    const int reduction = std::max(1, int(full_pixels / most_pixels_a_lens));
    const double pixels = full_pixels / reduction;
    if (!(std::min(scan.width, scan.height) / reduction >= 8 * pixels))
        throw std::invalid_argument(
            "it holds fewer than 8 lenses one way, too few to find their lattice");

    const Plane edges = edge_response(scan, reduction, 1.5 * pixels, threads);
    const ScanMap about = in_larger_pixels(search.about, reduction);
    if (!follow(2))
        return std::nullopt;
    const Spectrum spectrum(edges, spectrum_side);
    const std::vector<Candidate> found = by_spectrum(spectrum, search, about);
    if (!follow(4))
        return std::nullopt;

    // The film that the scan holds, for any of them.
    Vec2 half{0, 0};
    for (const Candidate& candidate : found)
        for (const double x : {0.0, double(edges.width)})
            for (const double y : {0.0, double(edges.height)}) {
                const Vec2 corner = film_from_scan(candidate.map, {x, y});
                half = {std::max(half.x, std::fabs(corner.x) + search.sheet.pitch),
                        std::max(half.y, std::fabs(corner.y) + search.sheet.pitch)};
            }
    const SheetOptics optics(search.sheet, search.aperture);
    const std::vector<Vec2> everywhere = search.frame
                                             ? lens_borders_of_pixels(optics, search.mapping,
                                                                      *search.frame,
                                                                      2 * most_borders, threads)
                                             : lens_borders(optics, search.mapping, half,
                                                            search.sheet.pitch / 8,
                                                            2 * most_borders, threads);
    std::vector<Vec2> points;
    for (const Vec2 point : everywhere) { // that are in the scan, or nearly, for the likeliest map
        const Vec2 pixel = scan_from_film(found.front().map, point);
        const double margin = 4 * pixels;
        if (pixel.x > -margin && pixel.y > -margin && pixel.x < edges.width + margin &&
            pixel.y < edges.height + margin)
            points.push_back(point);
    }
    double farthest = 0;
    for (const Vec2 point : points)
        farthest = std::max(farthest, length(point));
    if (points.empty())
        throw std::invalid_argument("the sheet's middle is too far outside of it");
    if (!follow(5))
        return std::nullopt;

    // Where the borders are known to the pixel, the fit may look closely. Borders from the optics
    // alone lie beside the print's pixels: close by, the pixels would be found instead.
    const bool to_the_pixel = search.frame.has_value();
    const double fine_deviation = to_the_pixel ? std::max(0.6, 0.02 * pixels)
                                               : std::max(0.7, 0.025 * pixels);
    const Plane wide = blurred(edges, std::max(1.0, pixels / 7), threads),
                middling = blurred(edges, std::max(0.9, pixels / 12), threads);
    const Plane fine = blurred(edges, fine_deviation, threads);
    // Beside a border there is often more edge on one side, of what the picture shows there: a
    // slope, that moves a maximum. Less what is around it, only a ridge is left.
    const Plane ridges = to_the_pixel
                             ? difference(fine, blurred(edges, 1.6 * fine_deviation, threads))
                             : fine;
    const double first_radius = std::max(
        6 * search.sheet.pitch, 0.3 * spectrum.extent() / std::max(about.scale.x, about.scale.y));
    ScanMap best;
    double most = -1e30;
    for (const Candidate& candidate : found) {
        const std::vector<Vec2> central = those_within(points, first_radius, 30000);
        if (central.empty())
            throw std::invalid_argument("the sheet's middle is too far outside of it");
        ScanMap map = best_middle(wide, central, search.sheet, candidate.map);
        map = fit_borders(wide, central, search.sheet, map);
        for (double radius = 1.6 * first_radius;; radius *= 1.6) {
            map = fit_borders(middling, those_within(points, radius, 40000), search.sheet, map);
            if (radius > farthest)
                break;
        }
        const double edge = edge_on_borders(fine, points, map);
        if (edge > most && is_in_range(search, about, map)) {
            most = edge;
            best = map;
        }
        if (!follow(7))
            return std::nullopt;
    }
    FoundLattice result;
    if (most == -1e30)
        return result;
    points = those_within(points, farthest, most_borders);
    best = fit_borders(fine, points, search.sheet, best);
    const double significance = significance_of(fine, those_within(points, farthest, 20000), search,
                                                about, best);
    const ScanMap pulled = best = fit_borders(
        fine, where_borders_show(fine, points, search.sheet, best), search.sheet, best);
    for (int round = 0; round < 2; ++round)
        best = fit_borders(ridges, where_borders_show(fine, points, search.sheet, best),
                           search.sheet, best);
    if (!is_in_range(search, about, best))
        best = pulled; // nothing held the closer look
    if (!follow(9))
        return std::nullopt;
    const std::vector<Vec2> shown = where_borders_show(fine, points, search.sheet, best);
    const FitErrors errors = errors_of_fit(ridges, shown, search.sheet, best);
    // The pull may happen to be none one way: the greater counts for both.
    const MapChange pull = change_between(pulled, best);
    const double scale_pull = std::max(std::fabs(pull[0]), std::fabs(pull[1])),
                 middle_pull = std::max(std::fabs(pull[3]), std::fabs(pull[4]));
    const auto with_pull = [](double x, double y, double pulled_by) {
        return Vec2{std::hypot(x, pulled_by), std::hypot(y, pulled_by)};
    };
    if (!is_in_range(search, about, best))
        return result;
    result.map = in_larger_pixels(best, 1.0 / reduction);
    result.errors_known = errors.known;
    result.scale_error = with_pull(errors.deviation[0], errors.deviation[1], scale_pull);
    result.rotation_error = std::hypot(errors.deviation[2], pull[2]);
    const bool lenticular = search.sheet.arrangement == Arrangement::lenticular;
    result.offset_error = reduction * (lenticular ? with_pull(errors.across, errors.across,
                                                              length(Vec2{pull[3], pull[4]}))
                                                  : with_pull(errors.deviation[3],
                                                              errors.deviation[4], middle_pull));
    result.contrast = fine.mean > 0 ? edge_on_borders(fine, shown, best) / fine.mean : 0;
    result.significance = significance;
    result.borders = errors.borders;
    follow(10);
    return result;
}

} // namespace integral
