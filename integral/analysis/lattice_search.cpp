// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/analysis/lattice_search.h"

#include "integral/analysis/border_fit.h"
#include "integral/analysis/edge_response.h"
#include "integral/analysis/lattice_candidates.h"
#include "integral/analysis/lattice_phases.h"
#include "integral/analysis/lens_borders.h"
#include "integral/analysis/part_fits.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <stdexcept>

namespace integral {
namespace {

constexpr double most_pixels_a_lens = 32; // of the reduced scan; more add nothing
constexpr double least_pixels_a_lens = 4;
constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr int spectrum_side = 2048;
constexpr int most_borders = 300000;
constexpr double least_apart = 0.1;          // lenses; closer maps are the same lattice
constexpr std::size_t most_of_a_fit = 15000; // borders, before the last stages

/// Distance (mm) of the farthest point from `centre`.
double farthest_of(const std::vector<Vec2>& points, Vec2 centre)
{
    double farthest = 0;
    for (const Vec2 point : points)
        farthest = std::max(farthest, length(point - centre));
    return farthest;
}

/// The points within `radius` (mm) of `centre`; at most `most`, evenly picked.
std::vector<Vec2> those_within(const std::vector<Vec2>& points, Vec2 centre, double radius,
                               std::size_t most)
{
    std::vector<Vec2> inside;
    for (const Vec2 point : points)
        if (length(point - centre) <= radius)
            inside.push_back(point);
    if (inside.size() > most) {
        std::vector<Vec2> some;
        for (std::size_t k = 0; k < most; ++k)
            some.push_back(inside[k * inside.size() / most]);
        return some;
    }
    return inside;
}

MapChange change_between(const ScanMap& from, const ScanMap& to)
{
    return {std::log(to.scale.x / from.scale.x), std::log(to.scale.y / from.scale.y),
            to.rotation - from.rotation, to.middle.x - from.middle.x, to.middle.y - from.middle.y};
}

/// Whether a fit has stayed near the range of the search, and its scales across and down differ by
/// no more than a scanner's do.
bool is_in_range(const LatticeSearch& search, const ScanMap& about, const ScanMap& map)
{
    constexpr double margin = 0.01, most_difference = 0.03;
    const double x = map.scale.x / about.scale.x, y = map.scale.y / about.scale.y;
    return std::fabs(x - 1) < search.scale_range + margin &&
           std::fabs(y - 1) < search.scale_range + margin &&
           std::fabs(x / y - 1) < most_difference &&
           std::fabs(map.rotation - about.rotation) < search.turn_range + margin;
}

/// Edge strength on the borders under the best map, less its mean under random maps in the range of
/// the search, in standard deviations of the strengths under the random maps.
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

/// Half width and half height (mm) of the film around the sheet's centre that holds the scan under
/// every candidate, with a margin of one lens.
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

/// The scan's edges with decreasing blur, for the stages of the fit.
struct BlurredEdges {
    Plane middling, fine;
    Plane ridges; ///< for the last stage
};

/// `pixels`: a lens pitch in pixels. `to_the_pixel`: the borders are known to the pixel, so less
/// blur will do. Borders from the optics alone differ from the edges of the print's pixels; with
/// less blur, the fit would follow these edges of pixels instead.
BlurredEdges blurred_edges(const Plane& edges, double pixels, bool to_the_pixel, int threads)
{
    BlurredEdges all;
    const double fine_deviation = to_the_pixel ? std::max(0.6, 0.02 * pixels)
                                               : std::max(0.7, 0.025 * pixels);
    all.middling = blurred(edges, std::max(0.9, pixels / 12), threads);
    all.fine = blurred(edges, fine_deviation, threads);
    // The picture often has stronger edges on one side of a border than on the other. This slope
    // moves the maximum. Subtracting the neighbourhood's mean removes the slope and leaves the
    // ridge.
    all.ridges = difference(all.fine, blurred(edges, 1.6 * fine_deviation, threads));
    return all;
}

/// Fits a map to the borders in growing circles around `centre`: from `first_radius` (mm), within
/// which `map` must be right, to the radius `farthest`.
ScanMap fit_outwards(const BlurredEdges& edges, const std::vector<Vec2>& points,
                     const LensSheet& sheet, ScanMap map, Vec2 centre, double first_radius,
                     double farthest)
{
    constexpr double growth = 1.6;
    for (double radius = first_radius;; radius *= growth) {
        map = fit_borders(edges.middling, those_within(points, centre, radius, most_of_a_fit),
                          sheet, map);
        if (radius > farthest)
            return map;
    }
}

/// Adds the maps around a candidate with the strongest edges on the borders of the whole scan. Each
/// is fitted to its maximum, and left out if it is out of range.
void add_fits(const BlurredEdges& planes, const std::vector<Vec2>& points,
              const LatticeSearch& search, const ScanMap& about, const LatticeCandidate& candidate,
              int spectrum_extent, int threads, std::vector<ScoredMap>& fitted)
{
    constexpr int most_phases = 4;
    constexpr double least_share = 0.4; // of the strongest so far
    constexpr double bins = 1.2;        // of the spectrum, either way
    const Plane& fine = planes.fine;
    const Vec2 centre = film_from_scan(candidate.map, {0.5 * fine.width, 0.5 * fine.height});
    const double radius = 0.5 * spectrum_side / std::max(about.scale.x, about.scale.y),
                 farthest = farthest_of(points, centre);
    const double resolution = bins * search.sheet.pitch * std::min(about.scale.x, about.scale.y) /
                              spectrum_extent;
    const std::vector<Vec2> near = those_within(points, centre, radius, most_borders);
    const auto is_known = [&](const ScanMap& map) {
        return std::any_of(fitted.begin(), fitted.end(), [&](const ScoredMap& other) {
            return lenses_apart(search.sheet, other.map, map, fine.width, fine.height) <
                   least_apart;
        });
    };
    double most = 0;
    for (const ScoredMap& rough :
         strongest_phases(planes.middling, near, search.sheet, candidate.map,
                          {resolution, resolution}, most_phases, threads)) {
        most = std::max(most, rough.edge);
        if (rough.edge < least_share * most || is_known(rough.map))
            continue;
        ScanMap map = fit_outwards(planes, points, search.sheet, rough.map, centre, radius,
                                   farthest);
        map = fit_borders(fine, those_within(points, centre, infinity, most_of_a_fit), search.sheet,
                          map);
        if (is_in_range(search, about, map))
            fitted.push_back({map, edge_on_borders(fine, points, map)});
    }
}

/// The strongest other lattice among fits sorted by edge: the first that differs from fitted[0];
/// nothing if there is none.
std::optional<ScoredMap> best_rival(const std::vector<ScoredMap>& fitted,
                                    const LatticeSearch& search, const Plane& edges)
{
    for (const ScoredMap& other : fitted)
        if (lenses_apart(search.sheet, fitted.front().map, other.map, edges.width, edges.height) >
            least_apart)
            return other;
    return std::nullopt;
}

/// For a map whose scales differ by more than a scanner's do: its rival, the best map with one
/// scale for both axes. Nothing for any other map. Along one axis, a map with two scales may lie on
/// a pattern of the picture that repeats at another pitch than the lenses.
std::optional<ScoredMap> rival_of_one_scale(const BlurredEdges& planes,
                                            const std::vector<Vec2>& points,
                                            const LatticeSearch& search, const ScanMap& about,
                                            const ScanMap& map)
{
    constexpr double most_difference = 0.005;
    const Vec2 relative{map.scale.x / about.scale.x, map.scale.y / about.scale.y};
    if (search.sheet.arrangement == Arrangement::lenticular ||
        !(std::fabs(relative.x / relative.y - 1) > most_difference))
        return std::nullopt;
    const std::vector<Vec2> some = those_within(points, {0, 0}, infinity, most_of_a_fit);
    ScoredMap best;
    for (const double factor : {relative.x, relative.y}) {
        ScanMap one = map;
        one.scale = factor * about.scale;
        one = fit_borders_with_ratio(planes.middling, some, one);
        one = fit_borders_with_ratio(planes.fine, some, one);
        const double edge = edge_on_borders(planes.fine, points, one);
        if (edge > best.edge)
            best = {one, edge};
    }
    return best;
}

/// The last stages of a fit.
struct CloseFit {
    ScanMap map;             ///< fitted to the ridges
    ScanMap pulled;          ///< fitted to the edges before; displaced by the picture's edges
    double significance = 0; ///< of the fit to the edges
};

CloseFit fit_closely(const BlurredEdges& edges, const std::vector<Vec2>& points,
                     const LatticeSearch& search, const ScanMap& about, const ScanMap& rough)
{
    const ScanMap map = fit_borders(edges.fine, points, search.sheet, rough);
    const auto shown = [&](const ScanMap& here) {
        return where_borders_show(edges.fine, points, search.sheet, here);
    };
    CloseFit fit;
    fit.significance = significance_of(edges.fine, those_within(points, {0, 0}, infinity, 20000),
                                       search, about, map);
    fit.map = fit.pulled = fit_borders(edges.fine, shown(map), search.sheet, map);
    for (int round = 0; round < 2; ++round)
        fit.map = fit_borders(edges.ridges, shown(fit.map), search.sheet, fit.map);
    if (!is_in_range(search, about, fit.map))
        fit.map = fit.pulled; // the ridges are too weak for a fit
    return fit;
}

/// The result for a fit whose map is in range: places and errors in pixels of the whole scan.
FoundLattice found_lattice(const BlurredEdges& edges, const std::vector<Vec2>& points,
                           const LatticeSearch& search, const CloseFit& fit, int reduction)
{
    const std::vector<Vec2> shown = where_borders_show(edges.fine, points, search.sheet, fit.map);
    const FitErrors errors = errors_of_fit(edges.ridges, shown, search.sheet, fit.map);
    // Two other fits show how far the picture's own edges and the film's pixels pull the fit: the
    // fit to the edges before the neighbourhood was subtracted, and a fit with more blur. Half of
    // the second pull counts, as the fit to the ridges is free of most of it. By chance the pull
    // may be 0 along one axis, so the greater of the two axes' pulls counts for both.
    constexpr double left_of_blur = 0.5;
    const MapChange first = change_between(fit.pulled, fit.map),
                    second = change_between(
                        fit_borders(edges.middling, shown, search.sheet, fit.map), fit.map);
    MapChange pull;
    for (std::size_t k = 0; k < pull.size(); ++k)
        pull[k] = std::hypot(first[k], left_of_blur * second[k]);
    const double scale_pull = std::max(pull[0], pull[1]), middle_pull = std::max(pull[3], pull[4]);
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
    const LeftOutParts left_out = check_left_out_parts(edges.middling, shown, search.sheet,
                                                       fit.map);
    result.parts = left_out.parts;
    result.agreeing_parts = left_out.agreeing;
    return result;
}

/// Factor by which the scan is reduced. Throws std::invalid_argument if the scan is too coarse or
/// too small.
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

    // From here on, all is in pixels of the reduced scan.
    const ScanMap about = in_larger_pixels(search.about, reduction);
    std::optional<Vec2> across;
    // Borders known to the pixel do not need this restriction, which would weaken their edges.
    if (search.sheet.arrangement == Arrangement::lenticular && !search.frame) {
        const MapChange direction = free_directions(search.sheet, about).back();
        across = Vec2{direction[3], direction[4]};
    }
    const Plane edges = edge_response(scan, reduction, 1.5 * pixels, threads, across);
    if (!follow(2))
        return std::nullopt;
    const Spectrum spectrum(edges, spectrum_side);
    const std::vector<LatticeCandidate> found = candidates_of(spectrum, search, about);
    if (!follow(4))
        return std::nullopt;
    std::vector<Vec2> points = borders_in_scan(search, found, edges, 4 * pixels, threads);
    if (!follow(5))
        return std::nullopt;

    const BlurredEdges planes = blurred_edges(edges, pixels, search.frame.has_value(), threads);
    std::vector<ScoredMap> fitted;
    for (const LatticeCandidate& candidate : found) {
        add_fits(planes, points, search, about, candidate, spectrum.extent(), threads, fitted);
        if (!follow(7))
            return std::nullopt;
    }
    if (fitted.empty())
        return FoundLattice();
    std::sort(fitted.begin(), fitted.end(),
              [](const ScoredMap& a, const ScoredMap& b) { return a.edge > b.edge; });
    points = those_within(points, {0, 0}, infinity, most_borders);
    const CloseFit fit = fit_closely(planes, points, search, about, fitted.front().map);
    if (!follow(9))
        return std::nullopt;
    if (!is_in_range(search, about, fit.map))
        return FoundLattice();
    FoundLattice result = found_lattice(planes, points, search, fit, reduction);
    std::optional<ScoredMap> rival = best_rival(fitted, search, edges);
    const auto other = rival_of_one_scale(planes, points, search, about, fitted.front().map);
    if (other && (!rival || other->edge > rival->edge))
        rival = other;
    if (rival) {
        result.rival_share = std::min(1.0, rival->edge / fitted.front().edge);
        result.rival = in_larger_pixels(rival->map, 1.0 / reduction);
    }
    follow(10);
    return result;
}

} // namespace integral
