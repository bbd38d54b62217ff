// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/views/frame_of_layers.h"

#include "integral/base/interrupt.h"
#include "integral/optics/lens_model.h"
#include "integral/optics/ray_gradient.h"
#include "integral/replay/interpolate.h"
#include "integral/sampling/sample_points.h"
#include "integral/views/covered_means.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace integral {
namespace {

constexpr int lines = 16;             ///< lines of sight of a film pixel
constexpr double pixels_per_beam = 4; ///< pixels of a layer's picture across a film pixel's beam

/// Where a line of sight of a pixel begins, relative to the pixel's centre and the lens's pole.
struct LineStart {
    Vec2 film, cell; ///< mm
    double slit = 0; ///< mm
};

/// The area that a film pixel's colours are seen over, mm.
Vec2 colour_area(const Film& film)
{
    const Vec2 size = subpixel_size(film.subpixels);
    return {size.x * film.pixel_pitch.x, size.y * film.pixel_pitch.y};
}

/// The height of a lenticular sheet's aperture across its slit.
double slit_height(const FrameMetadata& geometry)
{
    return geometry.sheet.arrangement == Arrangement::lenticular
               ? extent_across_slit(geometry.sheet,
                                    {geometry.aperture.width, geometry.aperture.height})
               : 0;
}

/// Points of a scrambled Sobol sequence, moved to the middles of their intervals and then towards
/// the pixel's centre and the lens's pole. The shrinking gives the samples the variance of the
/// whole beam. Each sample is a mean over a pixel of the layer's picture, interpolated between
/// these pixels: 1/12 = spread^2 (1 - 1/lines^2)/12 + (1/12 + 1/6)/pixels_per_beam^2.
std::vector<LineStart> line_starts(const FrameMetadata& geometry, const Lattice& lattice)
{
    const Vec2 area = colour_area(geometry.film);
    const double height = slit_height(geometry),
                 spread = std::sqrt((1 - 3 / (pixels_per_beam * pixels_per_beam)) /
                                    (1 - 1.0 / (lines * lines)));
    const PointSeeds seeds = point_seeds(1);
    std::vector<LineStart> starts;
    for (int k = 0; k < lines; ++k) {
        UnitPoint unit = scrambled_point(seeds, std::uint32_t(k));
        for (double& u : unit)
            u = (std::floor(u * lines) + 0.5) / lines;
        const LensPoint point = cell_point(lattice, {unit[0], unit[1]}, height);
        starts.push_back({spread * Vec2{(unit[2] - 0.5) * area.x, (unit[3] - 0.5) * area.y},
                          spread * point.offset, spread * point.slit});
    }
    return starts;
}

/// Widths of the boxes, along x and y, that have the variance of a lens's cell.
Vec2 cell_widths(const Lattice& lattice)
{
    const double p = lattice.pitch();
    switch (lattice.arrangement()) {
    case Arrangement::square: return {p, p};
    case Arrangement::hexagonal: return {p * std::sqrt(5.0 / 6), p * std::sqrt(5.0 / 6)};
    case Arrangement::lenticular: break;
    }
    return p * lattice.across();
}

/// Widths of the boxes, along x and y, that have the variance of the beam of a pixel in the middle
/// of the film at a layer of that parallax, mm on the sheet.
Vec2 beam_widths(const FrameMetadata& geometry, double parallax)
{
    const SheetOptics optics(geometry.sheet, geometry.aperture);
    const LensIndex lens = optics.lattice().nearest({0, 0});
    const Vec2 film_point = optics.lattice().pole(lens), area = colour_area(geometry.film);
    RayGradient g;
    if (const auto ray = optics.ray_through(film_point, lens))
        g = ray_gradient(optics, film_point, *ray);
    Vec2 squares;
    const auto add = [&](Vec2 width) {
        squares = squares + Vec2{width.x * width.x, width.y * width.y};
    };
    const auto add_moved = [&](const RayShift& shift, double by) {
        add(by * (shift.pole - parallax * shift.aperture));
    };
    add((1 - parallax) * cell_widths(optics.lattice()));
    add_moved(g.x, area.x);
    add_moved(g.y, area.y);
    add_moved(g.slit, slit_height(geometry));
    return {std::sqrt(squares.x), std::sqrt(squares.y)};
}

/// A picture of a layer as the drawing needs it: places on the sheet become pixels.
struct PlacedPicture {
    PlacedPicture(const LayerPicture& given, const LayerWindow& window)
        : picture(&given),
          scale{given.width() / window.size.x, -given.height() / window.size.y},
          first{0.5 * given.width() - scale.x * window.middle.x,
                0.5 * given.height() - scale.y * window.middle.y}
    {
    }
    FourFloats at(Vec2 place) const
    {
        return picture->at(first.x + scale.x * place.x, first.y + scale.y * place.y);
    }

    const LayerPicture* picture;
    Vec2 scale, first;
};

/// Where a line of sight meets a layer.
struct LayerPoint {
    Vec2 place; ///< on the sheet, as the eye in the middle sees it
    double parallax = 0;
};

/// A layer as the drawing needs it.
struct PlacedLayer {
    explicit PlacedLayer(const DrawnLayer& given) : layer(&given)
    {
        for (const LayerPicture& picture : given.pictures)
            pictures.emplace_back(picture, given.window);
    }

    /// Solves p = s - q(p) a for the place p on the line of sight through a point s of the sheet
    /// and a point a of the aperture plane; q: the parallax. The parallax is 1, that of infinity,
    /// if the eye at a is behind the plane or does not look towards it.
    LayerPoint point(Vec2 sheet_point, Vec2 aperture_point) const
    {
        const PicturePlane& plane = layer->plane;
        const double facing = 1 + dot(plane.slope, aperture_point),
                     q = facing > 0 ? std::min(1.0, plane.at(sheet_point) / facing) : 1;
        return {sheet_point - q * aperture_point, q};
    }

    FourFloats at(const LayerPoint& point) const
    {
        if (point.parallax >= 1)
            return FourFloats{0, 0, 0, 0};
        if (pictures.size() == 1)
            return pictures[0].at(point.place);
        const auto [least, greatest] = layer->range;
        const std::size_t parts = layer->picture_of.size();
        const double part = double(parts) * (point.parallax - least) / (greatest - least);
        const std::size_t index = std::size_t(std::clamp(part, 0.0, double(parts - 1)));
        return pictures[std::size_t(layer->picture_of[index])].at(point.place);
    }

    const DrawnLayer* layer;
    std::vector<PlacedPicture> pictures;
};

} // namespace

std::optional<PicturePlane> picture_plane(double z, Vec2 gradient, Vec2 middle, double distance)
{
    // A plane z = z0 + g . P has the parallax (z0 + g . p)/(d + z0) at the place p = P d/(d + z).
    const double facing = 1 - dot(gradient, middle) / distance;
    if (!(facing > 1e-9))
        return std::nullopt;
    PicturePlane plane;
    plane.slope = (1 / ((distance + z) * facing)) * gradient;
    plane.parallax = layer_parallax(z, distance) - dot(plane.slope, middle);
    return plane;
}

ParallaxRange parallax_range(const PicturePlane& plane, const LayerWindow& window)
{
    const double middle = plane.at(window.middle),
                 half = 0.5 * (std::fabs(plane.slope.x) * window.size.x +
                               std::fabs(plane.slope.y) * window.size.y);
    return {middle - half, middle + half};
}

DrawnLayer drawn_layer(const Image& picture, const PicturePlane& plane, const LayerWindow& window,
                       const FrameMetadata& geometry, int threads)
{
    DrawnLayer layer{plane, window, parallax_range(plane, window), {}, {}};
    const int parts = plane.tilted() ? 64 : 1;
    std::vector<Vec2> beams;
    Vec2 finest{HUGE_VAL, HUGE_VAL};
    for (int k = 0; k < parts; ++k) {
        const double part = (k + 0.5) / parts;
        beams.push_back(beam_widths(
            geometry, layer.range.least + part * (layer.range.greatest - layer.range.least)));
        finest = {std::min(finest.x, beams.back().x), std::min(finest.y, beams.back().y)};
    }
    int coarsest = 0;
    for (const Vec2 beam : beams) {
        const double ratio = std::min(beam.x / finest.x, beam.y / finest.y);
        layer.picture_of.push_back(std::isfinite(ratio) ? int(std::log2(std::max(1.0, ratio))) : 0);
        coarsest = std::max(coarsest, layer.picture_of.back());
    }
    const auto fade = [](double step, double length, int pixels) {
        return std::min(1.0, step * pixels / length);
    };
    for (int k = 0; k <= coarsest; ++k) {
        const Vec2 step = (std::ldexp(1, k) / pixels_per_beam) * finest;
        Image small = covered_means(picture, pixels_of_step(picture.width, window.size.x, step.x),
                                    pixels_of_step(picture.height, window.size.y, step.y), threads);
        const Vec2 fades{fade(step.x, window.size.x, small.width),
                         fade(step.y, window.size.y, small.height)};
        layer.pictures.emplace_back(std::move(small), fades);
    }
    return layer;
}

struct FrameOfLayers::State {
    State(std::vector<DrawnLayer> given, const FrameMetadata& metadata, bool is_transparent)
        : geometry(metadata),
          optics(metadata.sheet, metadata.aperture),
          starts(line_starts(metadata, optics.lattice())),
          drawn(std::move(given)),
          transparent(is_transparent)
    {
        for (auto layer = drawn.rbegin(); layer != drawn.rend(); ++layer)
            layers.emplace_back(*layer);
        for (const DrawnLayer& layer : drawn)
            any_tilted = any_tilted || layer.plane.tilted();
        std::stable_sort(layers.begin(), layers.end(),
                         [](const PlacedLayer& a, const PlacedLayer& b) {
                             return a.layer->plane.parallax < b.layer->plane.parallax;
                         });
    }

    /// Calls visit(light, parallax) for the layers along the line of sight through two points, from
    /// the front to the back, until it returns false.
    template <class Visit>
    void visit_layers(Vec2 sheet_point, Vec2 aperture_point, Visit visit) const
    {
        if (!any_tilted) {
            for (const PlacedLayer& layer : layers) {
                const LayerPoint point = layer.point(sheet_point, aperture_point);
                if (!visit(layer.at(point), point.parallax))
                    return;
            }
            return;
        }
        thread_local std::vector<std::pair<LayerPoint, const PlacedLayer*>> hits;
        hits.clear();
        for (const PlacedLayer& layer : layers) { // by insertion: their order changes little
            hits.emplace_back(layer.point(sheet_point, aperture_point), &layer);
            for (std::size_t k = hits.size() - 1;
                 k > 0 && hits[k].first.parallax < hits[k - 1].first.parallax; --k)
                std::swap(hits[k], hits[k - 1]);
        }
        for (const auto& [point, layer] : hits)
            if (!visit(layer->at(point), point.parallax))
                return;
    }

    /// The mean light along the lines of sight of a film point's pixel. Parts of the pixel that
    /// belong to a neighbouring lens do not count, unless the neighbour's light misses the
    /// aperture.
    Colour light(Vec2 film_point, const MappedPoint& mapped) const
    {
        const LensRay& ray = *mapped.ray;
        constexpr float opaque = 1.0f / 1024; // lines that pass less light than this end
        const RayGradient g = ray_gradient(optics, film_point, ray);
        std::array<bool, lines> counts;
        int counted = 0;
        for (int k = 0; k < lines; ++k) {
            counts[k] = mapped.searched ||
                        optics.lattice().nearest(film_point + starts[k].film) == ray.lens;
            counted += counts[k];
        }
        if (counted == 0) { // a tiny part belongs to the lens, and no line begins there
            counts.fill(true);
            counted = lines;
        }
        FourFloats sum{0, 0, 0, 0};
        for (int k = 0; k < lines; ++k) {
            if (!counts[k])
                continue;
            const LineStart& start = starts[k];
            const Vec2 sheet_point = ray.pole + start.cell + start.film.x * g.x.pole +
                                     start.film.y * g.y.pole + start.slit * g.slit.pole;
            const Vec2 aperture_point = ray.aperture_point + start.cell +
                                        start.film.x * g.x.aperture + start.film.y * g.y.aperture +
                                        start.slit * g.slit.aperture;
            float open = 1; // the share of light that the layers so far let through
            visit_layers(sheet_point, aperture_point, [&](FourFloats seen, double) {
                sum += open * seen;
                open *= 1 - seen[3];
                return open >= opaque;
            });
        }
        sum *= 1 / float(counted);
        return {sum[0], sum[1], sum[2], transparent ? sum[3] : 1};
    }

    /// Calls visit(x, mapped point, film point) for the pixels of a row that a lens images.
    /// `channel`: as in subpixel_centre; negative: the pixel's centre.
    template <class Visit> void for_each_pixel(int y, int channel, Visit visit) const
    {
        const Film& film = geometry.film;
        RayRun<Vec2> points;
        RayRun<MappedPoint> mapped;
        for (int first = 0; first < film.width; first += run_length) {
            const int number = std::min(run_length, film.width - first);
            for (int k = 0; k < number; ++k)
                points[k] = film_from_pixel(
                    film, channel < 0 ? Vec2{first + k + 0.5, y + 0.5}
                                      : subpixel_centre(film.subpixels, first + k, y, channel));
            optics.map_run(number, points, LensMapping::automatic, mapped);
            for (int k = 0; k < number; ++k)
                if (mapped[k].ray)
                    visit(first + k, mapped[k], points[k]);
        }
    }

    /// The light of a row's pixels; black (transparent) where no lens images them.
    std::vector<Colour> row(int y) const
    {
        const Subpixels& subpixels = geometry.film.subpixels;
        std::array<std::vector<Colour>, 3> channels;
        for (int channel = 0; channel < 3; ++channel) {
            if (subpixels == Subpixels::none && channel != 1)
                continue; // each_channel needs one
            std::vector<Colour>& own = channels[std::size_t(channel)];
            own.assign(geometry.film.width, Colour{0, 0, 0, 0});
            for_each_pixel(y, channel, [&](int x, const MappedPoint& mapped, Vec2 point) {
                own[std::size_t(x)] = light(point, mapped);
            });
        }
        std::vector<Colour> all = channels[1];
        for (std::size_t x = 0; x < all.size(); ++x)
            all[x] = each_channel(subpixels,
                                  [&](int channel) { return channels[std::size_t(channel)][x]; });
        return all;
    }

    /// The distance of the nearest layer that is opaque by half or more; infinite if there is none.
    float depth(const LensRay& ray) const
    {
        float depth = std::numeric_limits<float>::infinity();
        visit_layers(ray.pole, ray.aperture_point, [&](FourFloats seen, double parallax) {
            if (seen[3] < 0.5f)
                return true;
            depth = float(layer_depth(parallax, geometry.aperture.distance));
            return false;
        });
        return depth;
    }

    FrameMetadata geometry;
    SheetOptics optics;
    std::vector<LineStart> starts;
    std::vector<DrawnLayer> drawn;
    std::vector<PlacedLayer> layers; ///< of `drawn`, from the front to the back
    bool transparent, any_tilted = false;
};

FrameOfLayers::FrameOfLayers(std::vector<DrawnLayer> layers, const FrameMetadata& geometry,
                             bool transparent)
    : state_(std::make_unique<State>(std::move(layers), geometry, transparent))
{
}
FrameOfLayers::~FrameOfLayers() = default;

bool FrameOfLayers::draw(int first, Image& band, int threads, const Progress& progress) const
{
    const auto row = [&](int y) {
        const std::vector<Colour> light = state_->row(first + y);
        for (int x = 0; x < band.width; ++x)
            store_linear(band, x, y, light[std::size_t(x)]);
    };
    return for_each_row(band.height, threads, row, progress);
}

DepthFrame FrameOfLayers::depths(int threads, const Progress& progress) const
{
    const State& s = *state_;
    const Film& film = s.geometry.film;
    const std::size_t pixels = std::size_t(film.width) * std::size_t(film.height);
    DepthFrame frame{std::vector<float>(pixels), std::vector<float>(pixels), s.geometry};
    const auto row = [&](int y) {
        const std::size_t first = std::size_t(y) * std::size_t(film.width);
        s.for_each_pixel(y, -1, [&](int x, const MappedPoint& mapped, Vec2) {
            frame.depth[first + std::size_t(x)] = s.depth(*mapped.ray);
            frame.imaged[first + std::size_t(x)] = 1;
        });
    };
    if (!for_each_row(film.height, threads, row, progress))
        throw Interrupted();
    return frame;
}

} // namespace integral
