// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/analysis/lattice_search.h"

#include "integral/analysis/border_fit.h"
#include "integral/analysis/edge_response.h"
#include "integral/analysis/lattice_candidates.h"
#include "integral/analysis/lens_borders.h"

#include <algorithm>
#include <cmath>
#include <random>
#include <stdexcept>

namespace integral {
namespace {

constexpr double most_pixels_a_lens = 32; // of the reduced scan: more tell nothing more of borders
constexpr double least_pixels_a_lens = 4;
constexpr int spectrum_side = 2048;
constexpr int most_borders = 300000;

/// The distance (mm) of the farthest point from the middle.
double farthest_of(const std::vector<Vec2>& points)
{
    double farthest = 0;
    for (const Vec2 point : points)
        farthest = std::max(farthest, length(point));
    return farthest;
}

/// The points within `radius` (mm) of the middle; of more than `most` that many, evenly picked.
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

/// The map with its middle moved within a cell to where there is the most edge on the borders.
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

/// Whether a fit has stayed near the range of the search, with scales across and down that differ
/// by no more than a scanner's do.
bool is_in_range(const LatticeSearch& search, const ScanMap& about, const ScanMap& map)
{
    constexpr double margin = 0.01, most_difference = 0.03;
    const double x = map.scale.x / about.scale.x, y = map.scale.y / about.scale.y;
    return std::fabs(x - 1) < search.scale_range + margin &&
           std::fabs(y - 1) < search.scale_range + margin &&
           std::fabs(x / y - 1) < most_difference &&
           std::fabs(map.rotation - about.rotation) < search.turn_range + margin;
}

/// How far the edge on the borders under the best map is above the mean for random maps in the
/// range of the search, in standard deviations of those.
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

/// How far from the sheet's centre the film that the scan holds reaches (mm, along x and y), by any
/// of the candidates, and a lens more.
Vec2 half_of_film(const std::vector<LatticeCandidate>& candidates, const Plane& edges, double pitch)
{
    Vec2 half{0, 0};
    for (const LatticeCandidate& candidate : candidates)
        for (const double x : {0.0, double(edges.width)})
            for (const double y : {0.0, double(edges.height)}) {
                const Vec2 corner = film_from_scan(candidate.map, {x, y});
                half = {std::max(half.x, std::fabs(corner.x) + pitch),
                        std::max(half.y, std::fabs(corner.y) + pitch)};
            }
    return half;
}

/// Points on the borders of micro-images that lie in the scan, or at most `margin` pixels outside,
/// under the likeliest map. Throws std::invalid_argument if there are none.
std::vector<Vec2> borders_in_scan(const LatticeSearch& search,
                                  const std::vector<LatticeCandidate>& candidates,
                                  const Plane& edges, double margin, int threads)
{
    const SheetOptics optics(search.sheet, search.aperture);
    const double pitch = search.sheet.pitch;
    const std::vector<Vec2> everywhere = search.frame
                                             ? lens_borders_of_pixels(optics, search.mapping,
                                                                      *search.frame,
                                                                      2 * most_borders, threads)
                                             : lens_borders(optics, search.mapping,
                                                            half_of_film(candidates, edges, pitch),
                                                            pitch / 8, 2 * most_borders, threads);
    std::vector<Vec2> points;
    for (const Vec2 point : everywhere) {
        const Vec2 pixel = scan_from_film(candidates.front().map, point);
        if (pixel.x > -margin && pixel.y > -margin && pixel.x < edges.width + margin &&
            pixel.y < edges.height + margin)
            points.push_back(point);
    }
    if (points.empty())
        throw std::invalid_argument("the sheet's middle is too far outside of it");
    return points;
}

/// The scan's edges, blurred less and less for the stages of the fit.
struct BlurredEdges {
    Plane wide, middling, fine;
    Plane ridges; ///< for the last stage
};

/// `pixels`: of a lens. `to_the_pixel`: the borders are known to the pixel, so that the fit may
/// look closely. Borders from the optics alone lie beside the print's pixels, and with less blur
/// the fit would find those pixels instead.
BlurredEdges blurred_edges(const Plane& edges, double pixels, bool to_the_pixel, int threads)
{
    BlurredEdges all;
    const double fine_deviation = to_the_pixel ? std::max(0.6, 0.02 * pixels)
                                               : std::max(0.7, 0.025 * pixels);
    all.wide = blurred(edges, std::max(1.0, pixels / 7), threads);
    all.middling = blurred(edges, std::max(0.9, pixels / 12), threads);
    all.fine = blurred(edges, fine_deviation, threads);
    // The picture often shows more edge on one side of a border than on the other: a slope, which
    // moves the maximum. Subtracting the surroundings removes the slope and leaves the ridge.
    all.ridges = to_the_pixel ? difference(all.fine, blurred(edges, 1.6 * fine_deviation, threads))
                              : all.fine;
    return all;
}

/// Fits a candidate to the borders around the middle, then to those of larger and larger circles
/// (mm) up to `farthest`.
ScanMap fit_outwards(const BlurredEdges& edges, const std::vector<Vec2>& points,
                     const LensSheet& sheet, const ScanMap& candidate, double first_radius,
                     double farthest)
{
    constexpr double growth = 1.6;
    const std::vector<Vec2> central = those_within(points, first_radius, 30000);
    if (central.empty())
        throw std::invalid_argument("the sheet's middle is too far outside of it");
    ScanMap map = best_middle(edges.wide, central, sheet, candidate);
    map = fit_borders(edges.wide, central, sheet, map);
    for (double radius = growth * first_radius;; radius *= growth) {
        map = fit_borders(edges.middling, those_within(points, radius, 40000), sheet, map);
        if (radius > farthest)
            return map;
    }
}

/// Of the maps that are in range, the one with the most edge on the borders; nothing if none is.
std::optional<ScanMap> strongest_in_range(const Plane& edges, const std::vector<Vec2>& points,
                                          const std::vector<ScanMap>& maps,
                                          const LatticeSearch& search, const ScanMap& about)
{
    std::optional<ScanMap> best;
    double most = 0;
    for (const ScanMap& map : maps) {
        const double edge = edge_on_borders(edges, points, map);
        if ((!best || edge > most) && is_in_range(search, about, map)) {
            most = edge;
            best = map;
        }
    }
    return best;
}

/// The last stages of a fit.
struct CloseFit {
    ScanMap map;             ///< on the ridges
    ScanMap pulled;          ///< before: on the edges, which the picture's own pull aside
    double significance = 0; ///< of the fit on the edges
};

CloseFit fit_closely(const BlurredEdges& edges, const std::vector<Vec2>& points,
                     const LatticeSearch& search, const ScanMap& about, const ScanMap& rough)
{
    const ScanMap map = fit_borders(edges.fine, points, search.sheet, rough);
    const auto shown = [&](const ScanMap& here) {
        return where_borders_show(edges.fine, points, search.sheet, here);
    };
    CloseFit fit;
    fit.significance = significance_of(edges.fine, those_within(points, farthest_of(points), 20000),
                                       search, about, map);
    fit.map = fit.pulled = fit_borders(edges.fine, shown(map), search.sheet, map);
    for (int round = 0; round < 2; ++round)
        fit.map = fit_borders(edges.ridges, shown(fit.map), search.sheet, fit.map);
    if (!is_in_range(search, about, fit.map))
        fit.map = fit.pulled; // the ridges are too weak to hold it
    return fit;
}

/// What is said of a fit whose map is in range: places and errors in pixels of the whole scan.
FoundLattice found_lattice(const BlurredEdges& edges, const std::vector<Vec2>& points,
                           const LatticeSearch& search, const CloseFit& fit, int reduction)
{
    const std::vector<Vec2> shown = where_borders_show(edges.fine, points, search.sheet, fit.map);
    const FitErrors errors = errors_of_fit(edges.ridges, shown, search.sheet, fit.map);
    // By chance the pull may be nothing along one axis: the greater one counts for both.
    const MapChange pull = change_between(fit.pulled, fit.map);
    const double scale_pull = std::max(std::fabs(pull[0]), std::fabs(pull[1])),
                 middle_pull = std::max(std::fabs(pull[3]), std::fabs(pull[4]));
    const auto with_pull = [](double x, double y, double pulled_by) {
        return Vec2{std::hypot(x, pulled_by), std::hypot(y, pulled_by)};
    };
    const bool lenticular = search.sheet.arrangement == Arrangement::lenticular;
    FoundLattice result;
    result.map = in_larger_pixels(fit.map, 1.0 / reduction);
    result.errors_known = errors.known;
    result.scale_error = with_pull(errors.deviation[0], errors.deviation[1], scale_pull);
    result.rotation_error = std::hypot(errors.deviation[2], pull[2]);
    result.offset_error = reduction * (lenticular ? with_pull(errors.across, errors.across,
                                                              length(Vec2{pull[3], pull[4]}))
                                                  : with_pull(errors.deviation[3],
                                                              errors.deviation[4], middle_pull));
    result.contrast = edges.fine.mean > 0
                          ? edge_on_borders(edges.fine, shown, fit.map) / edges.fine.mean
                          : 0;
    result.significance = fit.significance;
    result.borders = errors.borders;
    return result;
}

/// By how much the scan is reduced. Throws std::invalid_argument if it is too coarse or too small.
int reduction_for(const Image& scan, const LatticeSearch& search)
{
    const double pixels = search.sheet.pitch *
                          std::min(search.about.scale.x, search.about.scale.y); // of a lens
    if (!(pixels >= least_pixels_a_lens))
        throw std::invalid_argument("a lens has " + std::to_string(pixels) +
                                    " of the scan's pixels; scan it finer, with 4 a lens or more");
    const int reduction = std::max(1, int(pixels / most_pixels_a_lens));
    if (!(std::min(scan.width, scan.height) / reduction >= 8 * (pixels / reduction)))
        throw std::invalid_argument(
            "it holds fewer than 8 lenses one way, too few to find their lattice");
    return reduction;
}

} // namespace

std::optional<FoundLattice> find_lattice(const Image& scan, const LatticeSearch& search,
                                         int threads, const Progress& progress)
{
    const auto follow = [&](int done) { return !progress || progress(done, 10); };
    const double pitch = search.sheet.pitch;
    const int reduction = reduction_for(scan, search);
    const double pixels = pitch * std::min(search.about.scale.x, search.about.scale.y) / reduction;

    // From here on in pixels of the reduced scan.
    const Plane edges = edge_response(scan, reduction, 1.5 * pixels, threads);
    const ScanMap about = in_larger_pixels(search.about, reduction);
    if (!follow(2))
        return std::nullopt;
    const Spectrum spectrum(edges, spectrum_side);
    const std::vector<LatticeCandidate> found = candidates_of(spectrum, search, about);
    if (!follow(4))
        return std::nullopt;
    std::vector<Vec2> points = borders_in_scan(search, found, edges, 4 * pixels, threads);
    const double farthest = farthest_of(points);
    if (!follow(5))
        return std::nullopt;

    const BlurredEdges planes = blurred_edges(edges, pixels, search.frame.has_value(), threads);
    const double first_radius = std::max(6 * pitch, 0.3 * spectrum.extent() /
                                                        std::max(about.scale.x, about.scale.y));
    std::vector<ScanMap> fitted;
    for (const LatticeCandidate& candidate : found) {
        fitted.push_back(
            fit_outwards(planes, points, search.sheet, candidate.map, first_radius, farthest));
        if (!follow(7))
            return std::nullopt;
    }
    const std::optional<ScanMap> best = strongest_in_range(planes.fine, points, fitted, search,
                                                           about);
    if (!best)
        return FoundLattice();

    points = those_within(points, farthest, most_borders);
    const CloseFit fit = fit_closely(planes, points, search, about, *best);
    if (!follow(9))
        return std::nullopt;
    if (!is_in_range(search, about, fit.map))
        return FoundLattice();
    const FoundLattice result = found_lattice(planes, points, search, fit, reduction);
    follow(10);
    return result;
}

} // namespace integral
