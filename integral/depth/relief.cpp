// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/depth/relief.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <stdexcept>

namespace integral {
namespace {

/// Greatest distance, in pixels, between neighbouring pixels of a map as the line's eye sees them.
/// If they are farther apart, an edge lies between them, with nothing known behind it.
constexpr double longest_stretch = 1.5;

/// Pixels that the nearest surface moves, against the farthest one, from one eye to the next: above
/// that, a picture may hide much of what the next one shows.
constexpr double far_apart = 6;

/// The pixel at a place, or the map's nearest pixel.
std::size_t pixel_around(const ReliefMap& map, Vec2 at)
{
    const auto nearest = [](double place, int size) {
        return int(std::clamp(place + 0.5, 0.0, size - 1.0));
    };
    const int x = nearest(at.x, map.width), y = nearest(at.y, map.height);
    return std::size_t(y) * map.width + std::size_t(x);
}

template <class Plane> bool is_inside(const Plane& plane, Vec2 at)
{
    constexpr double beyond = 1; // pixels by which the colours at a picture's edge extend outwards
    return at.x > -0.5 - beyond && at.y > -0.5 - beyond && at.x < plane.width - 0.5 + beyond &&
           at.y < plane.height - 0.5 + beyond;
}

/// Adds the light at a place, interpolated between the lit ones of the four pixels around it.
void add_between(const ReliefPicture& picture, Vec2 at, float weight, Colour& sum, float& weights)
{
    const double x = std::clamp(at.x, 0.0, picture.width - 1.0),
                 y = std::clamp(at.y, 0.0, picture.height - 1.0);
    const int left = std::min(int(x), std::max(0, picture.width - 2)),
              top = std::min(int(y), std::max(0, picture.height - 2));
    for (int k = 0; k < 4; ++k) {
        const int i = std::min(left + k % 2, picture.width - 1),
                  j = std::min(top + k / 2, picture.height - 1);
        const std::size_t pixel = std::size_t(j) * picture.width + std::size_t(i);
        float part = weight *
                     float((k % 2 ? x - left : 1 - (x - left)) * (k / 2 ? y - top : 1 - (y - top)));
        if (!picture.lit.empty())
            part *= picture.lit[pixel];
        sum.r += part * picture.light[0][pixel];
        sum.g += part * picture.light[1][pixel];
        sum.b += part * picture.light[2][pixel];
        weights += part;
    }
}

Colour divided(const Colour& sum, float weights)
{
    return weights > 0 ? Colour{sum.r / weights, sum.g / weights, sum.b / weights, 1}
                       : Colour{0, 0, 0, 1};
}

/// The light of a picture at a place in the image plane, mm.
Colour light_of(const ReliefPicture& picture, Vec2 place)
{
    Colour sum{0, 0, 0, 0};
    float weights = 0;
    add_between(picture, picture.places.pixel_at(place), 1, sum, weights);
    return divided(sum, weights);
}

/// The greatest difference between neighbours in sorted order; 1 if all are equal.
double greatest_step(std::vector<double> values)
{
    std::sort(values.begin(), values.end());
    double step = 0;
    for (std::size_t i = 1; i < values.size(); ++i)
        step = std::max(step, values[i] - values[i - 1]);
    return step > 0 ? step : 1;
}

} // namespace

/// Where a line meets a map.
struct Relief::Meeting {
    double parallax = 0;    ///< of the surface met
    bool known = false;     ///< the map shows it; if not, the line passes behind an edge or outside
    std::size_t beside = 0; ///< if not known: the pixel next to that edge, on the farther surface
};

Relief::Relief(std::vector<ReliefPicture> pictures, std::vector<ReliefMap> maps, double distance,
               Vec2 size)
    : pictures_(std::move(pictures)), maps_(std::move(maps)), distance_(distance), size_(size)
{
    update_extents();
}

/// Derives the parallax that maps have, the eyes' rectangle and the pictures' spacing.
void Relief::update_extents()
{
    least_ = HUGE_VALF;
    greatest_ = -HUGE_VALF;
    for (const ReliefMap& map : maps_)
        for (const float p : map.parallax)
            if (std::isfinite(p)) {
                least_ = std::min(least_, p);
                greatest_ = std::max(greatest_, p);
            }
    greatest_ += 1e-6f + 1e-5f * (greatest_ - least_); // so that the farthest surface can be met
    if (!(least_ <= greatest_))
        throw std::invalid_argument("the map contains no depth");
    std::vector<double> across, up;
    for (const ReliefPicture& picture : pictures_) {
        across.push_back(picture.eye.x);
        up.push_back(picture.eye.y);
    }
    spacing_ = {greatest_step(across), greatest_step(up)};
    first_eye_ = {*std::min_element(across.begin(), across.end()),
                  *std::min_element(up.begin(), up.end())};
    last_eye_ = {*std::max_element(across.begin(), across.end()),
                 *std::max_element(up.begin(), up.end())};
    const PixelPlaces& places = pictures_[0].places;
    pixel_ = std::max(length(places.right), length(places.down));
    const double step = std::max(last_eye_.x > first_eye_.x ? spacing_.x : 0,
                                 last_eye_.y > first_eye_.y ? spacing_.y : 0);
    sparse_ = (greatest_ - least_) * step > far_apart * pixel_;
}

void Relief::scale_to(Vec2 rectangle, Fit how)
{
    const bool fills = !fitted(size_.x / size_.y, rectangle.x / rectangle.y, how).differs();
    scale(enlargement(size_, rectangle, fills ? Fit::cover : how));
}

void Relief::move(ParallaxSpan to)
{
    const double span = to.far - to.near;
    // A point of parallax p, seen at X + p e from the eye e, must be seen at X + (near + span p) e'
    // from the new eye e', whatever p is.
    const auto moved = [&](auto& seen) {
        if (length(seen.eye) == 0)
            return;
        if (!(span > 0))
            throw std::invalid_argument("--depth-range: the first depth must be less than the "
                                        "second");
        seen.eye = (1 / span) * seen.eye;
        seen.places.first = seen.places.first + to.near * seen.eye;
    };
    for (ReliefPicture& picture : pictures_)
        moved(picture);
    for (ReliefMap& map : maps_) {
        moved(map);
        for (float& p : map.parallax)
            p = float(to.near + span * p);
    }
    update_extents();
}

ParallaxSpan Relief::span() const
{
    constexpr int share = 20;
    std::vector<float> all;
    for (const ReliefMap& map : maps_)
        std::copy_if(map.parallax.begin(), map.parallax.end(), std::back_inserter(all),
                     [](float p) { return std::isfinite(p); });
    const auto twentieth = all.size() / share;
    const auto ranked = [&](std::size_t rank) {
        const auto at = all.begin() + std::ptrdiff_t(rank);
        std::nth_element(all.begin(), at, all.end());
        return double(*at);
    };
    return {ranked(twentieth), ranked(all.size() - 1 - twentieth)};
}

void Relief::fit(ParallaxSpan to)
{
    const ParallaxSpan now = span();
    const double extent = now.far - now.near,
                 stretch = extent > 0 ? (to.far - to.near) / extent : 1;
    const double near = to.near - stretch * now.near;
    move({near, near + stretch});
}

void Relief::crop_to_common()
{
    for (const ReliefPicture& picture : pictures_) {
        const Vec2 first = picture.places.at(-0.5, -0.5),
                   last = picture.places.at(picture.width - 0.5, picture.height - 0.5);
        size_ = {std::min(size_.x, 2 * std::min(-first.x, last.x)),
                 std::min(size_.y, 2 * std::min(first.y, -last.y))};
    }
    size_ = {std::max(pixel_, size_.x), std::max(pixel_, size_.y)};
}

void Relief::scale(double factor)
{
    const auto scaled = [factor](auto& seen) {
        seen.eye = factor * seen.eye;
        PixelPlaces& p = seen.places;
        p = {factor * p.first, factor * p.right, factor * p.down};
    };
    for (ReliefPicture& picture : pictures_)
        scaled(picture);
    for (ReliefMap& map : maps_)
        scaled(map);
    distance_ *= factor;
    pixel_ *= factor;
    for (Vec2* v : {&size_, &first_eye_, &last_eye_, &spacing_})
        *v = factor * *v;
}

void Relief::thin(Vec2 spacing)
{
    for (ReliefMap& map : maps_) {
        // Maps of turned views have their rows upright.
        const auto pixels = [&](Vec2 step, int all) {
            const double each = std::fabs(step.x) >= std::fabs(step.y) ? spacing.x : spacing.y;
            return int(std::clamp(each / length(step) + 1e-6, 1.0, double(all)));
        };
        const int across = pixels(map.places.right, map.width),
                  down = pixels(map.places.down, map.height);
        if (across == 1 && down == 1)
            continue;
        const int left = across / 2, above = down / 2;
        std::vector<float> thinned;
        for (int y = above; y < map.height; y += down)
            for (int x = left; x < map.width; x += across)
                thinned.push_back(map.parallax[std::size_t(y) * map.width + x]);
        map.places = {map.places.at(left, above), double(across) * map.places.right,
                      double(down) * map.places.down};
        map.width = (map.width - left + across - 1) / across;
        map.height = (map.height - above + down - 1) / down;
        map.parallax = std::move(thinned);
    }
}

Relief::Meeting Relief::meet(const ReliefMap& map, const ReliefLine& line) const
{
    // A point of parallax s on the line is seen from the map's eye at place + s (eye - line.eye).
    const Vec2 start = map.places.pixel_at(line.place),
               way = map.places.pixel_at(line.place + map.eye - line.eye) - start;
    const double far = std::max(std::fabs(way.x), std::fabs(way.y)), span = greatest_ - least_;
    const int steps = 1 + int(std::ceil(far * span)); // of at most a pixel
    const float edge = float(longest_stretch / std::max(far, 1e-9));
    Meeting behind; // the farther surface next to the edge that hides the line
    bool is_behind = false;
    float before = HUGE_VALF, last = 0; // the map's depth at the last step; the line's minus it
    std::size_t last_pixel = pixel_around(map, start + double(least_) * way);
    for (int k = 0; k <= steps; ++k) {
        const double s = least_ + span * k / steps;
        const Vec2 at = start + s * way;
        const std::size_t pixel = pixel_around(map, at);
        const float here = map.parallax[pixel], past = float(s) - here;
        if (std::isnan(here))
            continue;
        if (is_behind && past < 0)
            is_behind = false;
        else if (is_behind && s >= behind.parallax)
            return behind;
        else if (!is_behind && past >= 0) {
            const bool passes = before < HUGE_VALF && before - here > edge && past > 0.5f * edge;
            if (!passes) {
                const double part = past > last ? past / (past - last) : 0;
                const double met = k > 0 && last < 0 ? s - part * span / steps : s;
                return {far < 0.25 ? here : met, is_inside(map, at), pixel};
            }
            is_behind = true;
            behind = {before, false, last_pixel};
        }
        before = here;
        last = past;
        last_pixel = pixel;
    }
    return is_behind ? behind : Meeting{before < HUGE_VALF ? before : greatest_, false, last_pixel};
}

bool Relief::is_between_eyes(Vec2 eye) const
{
    const Vec2 rest = 0.75 * spacing_;
    return eye.x > first_eye_.x - rest.x && eye.x < last_eye_.x + rest.x &&
           eye.y > first_eye_.y - rest.y && eye.y < last_eye_.y + rest.y;
}

bool Relief::is_seen(const ReliefMap& map, double parallax, const ReliefLine& line) const
{
    const Meeting met = meet(map, line);
    return met.known && std::fabs(met.parallax - parallax) < 0.03 * (greatest_ - least_) + 1e-6;
}

Colour Relief::light_at(const ReliefMap& map, double parallax, const ReliefLine& line) const
{
    // A picture's eye may not see the surface.
    const bool may_be_hidden = sparse_ || !is_between_eyes(line.eye);
    const Vec2 nearest{std::clamp(line.eye.x, first_eye_.x, last_eye_.x),
                       std::clamp(line.eye.y, first_eye_.y, last_eye_.y)};
    Colour sum{0, 0, 0, 0}, edge{0, 0, 0, 0};
    float weights = 0, of_edge = 0;
    for (const ReliefPicture& picture : pictures_) {
        const double across = 1 - std::fabs(picture.eye.x - nearest.x) / spacing_.x,
                     up = 1 - std::fabs(picture.eye.y - nearest.y) / spacing_.y;
        if (!(across > 0 && up > 0))
            continue;
        const Vec2 place = line.place + parallax * (picture.eye - line.eye);
        if (may_be_hidden && !is_seen(map, parallax, {place, picture.eye}))
            continue;
        const Vec2 at = picture.places.pixel_at(place);
        const bool inside = is_inside(picture, at);
        add_between(picture, at, float(across * up), inside ? sum : edge,
                    inside ? weights : of_edge);
    }
    if (weights > 0 || of_edge > 0)
        return weights > 0 ? divided(sum, weights) : divided(edge, of_edge);
    const ReliefPicture& own = pictures_[map.picture];
    return light_of(own, line.place + parallax * (own.eye - line.eye));
}

Colour Relief::light_beside(const ReliefMap& map, const Meeting& hidden,
                            const ReliefLine& line) const
{
    // Mirrors the surface at the edge that hides the line, as far as the surface extends.
    const Vec2 edge{double(hidden.beside % std::size_t(map.width)),
                    double(hidden.beside / std::size_t(map.width))};
    const Vec2 at = map.places.pixel_at(line.place + hidden.parallax * (map.eye - line.eye));
    Vec2 from = 2.0 * edge - at;
    const float there = map.parallax[pixel_around(map, from)];
    const double farther = std::fabs(there - hidden.parallax);
    if (!is_inside(map, from) || !(farther < 0.05 * (greatest_ - least_) + 1e-6))
        from = edge;
    return light_of(pictures_[map.picture], map.places.at(from.x, from.y));
}

Seen Relief::along(const ReliefLine& line) const
{
    const ReliefMap* nearest = nullptr;
    Meeting of_nearest;
    std::uint32_t tried = 0;
    for (std::size_t k = 0; k < maps_.size(); ++k) {
        std::size_t next = maps_.size();
        for (std::size_t i = 0; i < maps_.size(); ++i)
            if (!(tried >> i & 1) &&
                (next == maps_.size() ||
                 length(maps_[i].eye - line.eye) < length(maps_[next].eye - line.eye)))
                next = i;
        tried |= std::uint32_t(1) << next;
        const Meeting met = meet(maps_[next], line);
        if (met.known)
            return {light_at(maps_[next], met.parallax, line), met.parallax, true};
        if (!nearest) {
            nearest = &maps_[next];
            of_nearest = met;
        }
    }
    // No map shows the line's end, but a picture whose eye is near the line does.
    if (!sparse_ && is_between_eyes(line.eye))
        return {light_at(*nearest, of_nearest.parallax, line), of_nearest.parallax,
                pictures_.size() > 1};
    return {light_beside(*nearest, of_nearest, line), of_nearest.parallax, false};
}

Vec2 eye_of(const ViewSet& views, const DepthView& view)
{
    const Vec2 steps = view.shift.x * views.places.right + view.shift.y * views.places.down;
    return views.eye - views.scale->ratio * steps;
}

Relief relief_of(const ViewSet& views, Encoding encoding, std::vector<ReliefMap> maps, Vec2 size,
                 int threads)
{
    std::vector<ReliefPicture> pictures(views.others.size() + 1);
    for_each_row(int(pictures.size()), threads, [&](int k) {
        const DepthView& view = k == 0 ? views.middle : views.others[std::size_t(k - 1)];
        ReliefPicture& picture = pictures[std::size_t(k)];
        picture = {eye_of(views, view), views.width,   views.height,
                   views.places,        view.channels, view.lit};
        for (auto& channel : picture.light)
            for (float& value : channel)
                value = float(decode(encoding, value));
    });
    return Relief(std::move(pictures), std::move(maps), views.scale->distance, size);
}

} // namespace integral
