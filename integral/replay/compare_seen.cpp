// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/replay/compare_seen.h"

#include "integral/base/constants.h"
#include "integral/replay/arrange.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace integral {
namespace {

constexpr int longest_side = 600; // of a view, pixels

std::vector<Eye> eyes_of(const SeenEyes& request, const FrameMetadata& metadata)
{
    std::vector<Eye> eyes;
    for (const Vec3& place : request.places)
        eyes.push_back({place.x, place.y, place.z});
    if (!eyes.empty())
        return eyes;
    const bool one_way = metadata.sheet.arrangement == Arrangement::lenticular;
    return contact_sheet_eyes(metadata, centre_eye(metadata),
                              request.columns > 0 ? request.columns
                              : one_way           ? 9
                                                  : 3,
                              request.rows > 0 ? request.rows
                              : one_way        ? 1
                                               : 3);
}

/// The result with the reference's pixels where those are ignored.
Frame without_ignored(const Frame& reference, const Frame& result, const ComparisonRules& rules)
{
    const auto weights = settings_of(rules, reference, result).weights;
    if (!weights)
        return result;
    Frame frame = result;
    const Image &image = reference.image,
                from = converted(image, sample_bits(result.image), result.image.encoding,
                                 result.image.premultiplied);
    std::vector<float> row(std::size_t(image.width), 0.0f);
    for (int y = 0; y < image.height; ++y) {
        weights->fill(y, row.data());
        for (int x = 0; x < image.width; ++x)
            if (!(row[std::size_t(x)] > 0))
                store_pixel(frame.image, x, y, stored_pixel(from, x, y));
    }
    return frame;
}

/// A view of the whole film in pixels of `pitch` mm, or larger.
View view_of(Eye eye, const FrameMetadata& metadata, double pitch)
{
    View view;
    view.eye = eye;
    const Vec2 size = size_of(metadata.film);
    set_view_size(view, metadata.film,
                  int(std::clamp(std::max(size.x, size.y) / pitch, 16.0, double(longest_side))));
    set_as_seen(view, metadata);
    return view;
}

/// What an eye sees of a frame in the place of another, of which the view is.
Image seen_of(const Frame& frame, View view)
{
    view.blur = 0;
    set_as_seen(view, *frame.metadata);
    return *replay(frame, view);
}

/// Takes the worse of each figure.
void take_worse(Comparison& overall, const Comparison& c)
{
    overall.rmse = std::max(overall.rmse, c.rmse);
    overall.psnr = std::min(overall.psnr, c.psnr);
    overall.ssim = std::min(overall.ssim, c.ssim);
    overall.largest_difference = std::max(overall.largest_difference, c.largest_difference);
    overall.within_two = std::min(overall.within_two, c.within_two);
    overall.differing = std::max(overall.differing, c.differing);
    if (c.flip && (!overall.flip || c.flip->mean > overall.flip->mean))
        overall.flip = c.flip;
    if (c.not_finite.unequal > overall.not_finite.unequal)
        overall.not_finite = c.not_finite;
}

/// A view's luma, as stored.
std::vector<float> lumas(const Image& view)
{
    std::vector<float> values;
    for (int y = 0; y < view.height; ++y)
        for (int x = 0; x < view.width; ++x) {
            const Colour c = stored_pixel(view, x, y);
            values.push_back(0.2126f * c.r + 0.7152f * c.g + 0.0722f * c.b);
        }
    return values;
}

/// Finds details of one view in another, which lie moved along one axis. A pixel of the views is at
/// least a lens wide, as finer details are not seen.
class DetailSearch {
public:
    static constexpr int half = 4; ///< of a detail's side, pixels

    /// `reach`: the greatest movement, pixels. `upwards`: details move along the columns.
    DetailSearch(const Image& from, const Image& to, int reach, bool upwards)
        : width_(from.width),
          height_(from.height),
          reach_(reach),
          upwards_(upwards),
          from_(lumas(from)),
          to_(lumas(to))
    {
    }

    /// The movement in pixels of the detail about (x, y); empty where it has no texture along the
    /// axis, lies at the edge, or is not found again.
    std::optional<double> movement(int x, int y) const
    {
        std::vector<double> errors;
        double texture = 0;
        for (int j = -half; j < half; ++j)
            for (int i = -half; i < half; ++i)
                texture += squared(from(x + i, y + j) - from(x + i + !upwards_, y + j + upwards_));
        for (int shift = -reach_; shift <= reach_; ++shift) {
            double error = 0;
            const int dx = upwards_ ? 0 : shift, dy = upwards_ ? shift : 0;
            for (int j = -half; j < half; ++j)
                for (int i = -half; i < half; ++i)
                    error += squared(from(x + i, y + j) - to(x + i + dx, y + j + dy));
            errors.push_back(error);
        }
        const int best = int(std::min_element(errors.begin(), errors.end()) - errors.begin());
        constexpr double least_texture = 4 * half * half * 0.01 * 0.01;
        if (texture < least_texture || best == 0 || best == 2 * reach_ ||
            errors[std::size_t(best)] > 0.5 * texture)
            return std::nullopt;
        const double before = errors[std::size_t(best - 1)], here = errors[std::size_t(best)],
                     after = errors[std::size_t(best + 1)], bend = before - 2 * here + after;
        return best - reach_ + (bend > 0 ? 0.5 * (before - after) / bend : 0);
    }

private:
    static double squared(double v) { return v * v; }
    float value(const std::vector<float>& values, int x, int y) const
    {
        return values[std::size_t(std::clamp(y, 0, height_ - 1)) * width_ +
                      std::clamp(x, 0, width_ - 1)];
    }
    float from(int x, int y) const { return value(from_, x, y); }
    float to(int x, int y) const { return value(to_, x, y); }

    int width_, height_, reach_;
    bool upwards_;
    std::vector<float> from_, to_;
};

/// A place of the sheet, mm, for a pixel of a view.
Vec2 sheet_place(const View& view, const Film& film, double x, double y)
{
    const Vec2 size = size_of(film);
    return {(x / view.width - 0.5) * size.x, (0.5 - y / view.height) * size.y};
}

/// How the movement of details from one eye's view to another's differs between the frames.
std::optional<ParallaxDifference> parallax_difference(const Frame& reference, const Frame& result,
                                                      Eye first, Eye last)
{
    const FrameMetadata& metadata = *reference.metadata;
    const View from = view_of(first, metadata, metadata.sheet.pitch),
               to = view_of(last, metadata, metadata.sheet.pitch), &view = from;
    const bool upwards = lenses_lie_across(metadata.sheet);
    const int reach = std::max(4, (upwards ? view.height : view.width) / 16);
    const DetailSearch in_reference(seen_of(reference, from), seen_of(reference, to), reach,
                                    upwards),
        in_result(seen_of(result, from), seen_of(result, to), reach, upwards);
    const double mm = upwards ? size_of(metadata.film).y / view.height
                              : size_of(metadata.film).x / view.width;
    std::vector<double> differences;
    ParallaxDifference found;
    constexpr int step = 2 * DetailSearch::half;
    for (int y = step / 2; y + step / 2 <= view.height; y += step)
        for (int x = step / 2; x + step / 2 <= view.width; x += step) {
            const auto a = in_reference.movement(x, y), b = in_result.movement(x, y);
            if (!a || !b)
                continue;
            differences.push_back(mm * std::fabs(*a - *b));
            if (differences.back() >= found.greatest) {
                found.greatest = differences.back();
                found.place = sheet_place(view, metadata.film, x, y);
            }
        }
    if (differences.empty())
        return std::nullopt;
    const auto middle = differences.begin() + std::ptrdiff_t(differences.size() / 2);
    std::nth_element(differences.begin(), middle, differences.end());
    found.median = *middle;
    found.details = int(differences.size());
    return found;
}

/// Where two views differ most: the middle of the square whose squared differences are greatest.
Vec2 worst_place(const Image& a, const Image& b, const View& view, const Film& film)
{
    const int side = std::max(8, std::max(view.width, view.height) / 24);
    const Image difference = difference_picture(a, b, 1);
    double most = -1;
    Vec2 place;
    for (int top = 0; top < view.height; top += side)
        for (int left = 0; left < view.width; left += side) {
            double sum = 0;
            const int right = std::min(view.width, left + side),
                      bottom = std::min(view.height, top + side);
            for (int y = top; y < bottom; ++y)
                for (int x = left; x < right; ++x) {
                    const Colour c = stored_pixel(difference, x, y);
                    sum += double(c.r) * c.r + double(c.g) * c.g + double(c.b) * c.b;
                }
            if (sum > most) {
                most = sum;
                place = sheet_place(view, film, 0.5 * (left + right), 0.5 * (top + bottom));
            }
        }
    return place;
}

} // namespace

SeenFigures compare_seen(const Frame& reference, const Frame& result, const ComparisonRules& rules)
{
    const FrameMetadata& metadata = *reference.metadata;
    const Frame compared = without_ignored(reference, result, rules);
    ComparisonRules view_rules = rules;
    view_rules.regions.clear();
    view_rules.mask.clear();
    SeenFigures seen;
    seen.overall.psnr = std::numeric_limits<double>::infinity();
    seen.overall.ssim = seen.overall.within_two = 1;
    seen.overall.channel_tolerance = rules.channel_tolerance;
    double most = -1;
    const std::vector<Eye> eyes = eyes_of(*rules.seen, metadata);
    for (std::size_t k = 0; k < eyes.size(); ++k) {
        const double finest = eyes[k].distance * std::tan(radians_per_degree / 60);
        const View view = view_of(eyes[k], metadata, finest);
        Frame a{seen_of(reference, view), std::nullopt}, b{seen_of(compared, view), std::nullopt};
        if (!rules.ppd)
            view_rules.ppd = std::clamp(radians_per_degree * eyes[k].distance * view.width /
                                            size_of(metadata.film).x,
                                        least_ppd, greatest_ppd);
        const Comparison figures = compare(a, b, settings_in_memory(view_rules, a, b));
        seen.eyes.push_back({{eyes[k].x, eyes[k].y, eyes[k].distance}, figures});
        seen.overall.encoding = figures.encoding;
        take_worse(seen.overall, figures);
        const double worse = figures.flip ? figures.flip->mean : figures.rmse;
        if (worse > most) {
            most = worse;
            seen.worst = k;
            seen.place = worst_place(a.image, b.image, view, metadata.film);
            seen.reference = std::move(a.image);
            seen.result = std::move(b.image);
        }
    }
    if (eyes.size() > 1 && eyes.front().distance == eyes.back().distance)
        seen.parallax = parallax_difference(reference, compared, eyes.front(), eyes.back());
    return seen;
}

} // namespace integral
