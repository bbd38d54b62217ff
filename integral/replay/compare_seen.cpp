// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/replay/compare_seen.h"

#include "integral/base/constants.h"
#include "integral/base/number_text.h"
#include "integral/compare/compare_geometry.h"
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

/// The result, with ignored pixels replaced by the reference's.
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

/// The picture of a frame in a given view, with the blur of the frame's own lenses.
Image seen_of(const Frame& frame, View view)
{
    view.blur = 0;
    set_as_seen(view, *frame.metadata);
    return *replay(frame, view);
}

/// Whether two frames look the same to all eyes: their samples and geometry are equal.
bool same_to_eyes(const Frame& a, const Frame& b)
{
    return same_form(a.image, b.image) && a.image.samples == b.image.samples &&
           geometry_difference_text(a.metadata, b.metadata).empty();
}

/// The width of a view's pixel on the sheet, mm: a 60th of a degree, but no less than the film's
/// pixels, as there is nothing finer to see.
double view_pitch(Eye eye, const Film& film)
{
    return std::max(eye.distance * std::tan(radians_per_degree / 60),
                    std::min(film.pixel_pitch.x, film.pixel_pitch.y));
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

/// Follows details of one view through the views of other eyes. Between views, a detail moves along
/// one axis in proportion to the eye's way. A pixel of the views is at least a lens wide, because
/// finer details are not visible.
class DetailSearch {
public:
    static constexpr int half = 4; ///< of a detail's side, pixels

    /// A view from another eye, and the way to that eye as a part of the whole way.
    struct Step {
        Image view;
        double way;
    };

    /// `steps`: sorted by `way`; the last `way` is 1. `reach`: the greatest movement in the first
    /// step, pixels. `upwards`: details move along the columns.
    DetailSearch(const Image& from, const std::vector<Step>& steps, int reach, bool upwards)
        : width_(from.width),
          height_(from.height),
          reach_(reach),
          upwards_(upwards),
          from_(lumas(from))
    {
        for (const Step& step : steps)
            to_.push_back({lumas(step.view), step.way});
    }

    /// The movement over the whole way, in pixels, of the detail about (x, y); empty if the detail
    /// has no texture along the axis, or is not found in each view.
    std::optional<double> movement(int x, int y) const
    {
        double texture = 0;
        for (int j = -half; j < half; ++j)
            for (int i = -half; i < half; ++i)
                texture += squared(from(x + i, y + j) - from(x + i + !upwards_, y + j + upwards_));
        constexpr double least_texture = 4 * half * half * 0.01 * 0.01;
        if (texture < least_texture)
            return std::nullopt;
        std::optional<double> found;
        double way = 0;
        for (const Target& target : to_) {
            const int expected = found ? int(std::lround(*found * target.way / way)) : 0;
            found = movement_to(target.lumas, x, y, expected, found ? 2 : reach_, texture);
            if (!found)
                return std::nullopt;
            way = target.way;
        }
        return found;
    }

private:
    struct Target {
        std::vector<float> lumas;
        double way;
    };

    /// The movement, in pixels, of the detail at (x, y) to the view `to`. It is sought less than
    /// `reach` pixels from `expected`. Empty if no movement matches.
    std::optional<double> movement_to(const std::vector<float>& to, int x, int y, int expected,
                                      int reach, double texture) const
    {
        std::vector<double> errors;
        for (int shift = expected - reach; shift <= expected + reach; ++shift) {
            double error = 0;
            const int dx = upwards_ ? 0 : shift, dy = upwards_ ? shift : 0;
            for (int j = -half; j < half; ++j)
                for (int i = -half; i < half; ++i)
                    error += squared(from(x + i, y + j) - value(to, x + i + dx, y + j + dy));
            errors.push_back(error);
        }
        const int best = int(std::min_element(errors.begin(), errors.end()) - errors.begin());
        if (best == 0 || best == 2 * reach || errors[std::size_t(best)] > 0.5 * texture)
            return std::nullopt;
        const double before = errors[std::size_t(best - 1)], here = errors[std::size_t(best)],
                     after = errors[std::size_t(best + 1)], bend = before - 2 * here + after;
        return expected + best - reach + (bend > 0 ? 0.5 * (before - after) / bend : 0);
    }

    static double squared(double v) { return v * v; }
    float value(const std::vector<float>& values, int x, int y) const
    {
        return values[std::size_t(std::clamp(y, 0, height_ - 1)) * width_ +
                      std::clamp(x, 0, width_ - 1)];
    }
    float from(int x, int y) const { return value(from_, x, y); }

    int width_, height_, reach_;
    bool upwards_;
    std::vector<float> from_;
    std::vector<Target> to_;
};

/// A place of the sheet, mm, for a pixel of a view.
Vec2 sheet_place(const View& view, const Film& film, double x, double y)
{
    const Vec2 size = size_of(film);
    return {(x / view.width - 0.5) * size.x, (0.5 - y / view.height) * size.y};
}

double along(Eye eye, bool upwards) { return upwards ? eye.y : eye.x; }

/// The eyes on the longest way across the lenses, in order. They have one distance and one height
/// (for lenses that lie across, one x). Of equally long ways, takes the nearest to the middle.
/// Fewer than two if no two eyes are on such a way.
std::vector<Eye> way_across(const std::vector<Eye>& eyes, bool upwards)
{
    std::vector<Eye> longest;
    for (const Eye& first : eyes) {
        std::vector<Eye> row;
        for (const Eye& eye : eyes)
            if (eye.distance == first.distance &&
                std::fabs(along(eye, !upwards) - along(first, !upwards)) < 1e-6 &&
                along(eye, upwards) >= along(first, upwards))
                row.push_back(eye);
        std::sort(row.begin(), row.end(),
                  [&](Eye a, Eye b) { return along(a, upwards) < along(b, upwards); });
        const auto length = [&](const std::vector<Eye>& way) {
            return way.empty() ? 0 : along(way.back(), upwards) - along(way.front(), upwards);
        };
        const double longer = length(row) - length(longest);
        if (longer > 1e-6 ||
            (longer > -1e-6 && !longest.empty() &&
             std::fabs(along(first, !upwards)) < std::fabs(along(longest.front(), !upwards))))
            longest = row;
    }
    return longest;
}

double median_of(std::vector<double> values)
{
    const auto middle = values.begin() + std::ptrdiff_t(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
}

/// The difference between the frames in the movement of details from one eye's view to another's.
std::optional<ParallaxDifference> parallax_difference(const Frame& reference, const Frame& result,
                                                      const std::vector<Eye>& eyes)
{
    const FrameMetadata& metadata = *reference.metadata;
    const bool upwards = lenses_lie_across(metadata.sheet);
    const std::vector<Eye> way = way_across(eyes, upwards);
    if (way.size() < 2)
        return std::nullopt;
    const double pitch = metadata.sheet.pitch, start = along(way.front(), upwards),
                 base = along(way.back(), upwards) - start, distance = way.front().distance;
    const View view = view_of(way.front(), metadata, pitch);
    const int reach = std::max(4, (upwards ? view.height : view.width) / 16);
    const auto search = [&](const Frame& frame) {
        std::vector<DetailSearch::Step> steps;
        for (std::size_t k = 1; k < way.size(); ++k)
            steps.push_back({seen_of(frame, view_of(way[k], metadata, pitch)),
                             (along(way[k], upwards) - start) / base});
        return DetailSearch(seen_of(frame, view), steps, reach, upwards);
    };
    const DetailSearch in_reference = search(reference), in_result = search(result);
    const double mm = upwards ? -size_of(metadata.film).y / view.height // rows count downwards
                              : size_of(metadata.film).x / view.width;
    // A point z behind the sheet is seen to move on the sheet by base z/(distance + z).
    const auto depth = [&](double moved) { return distance * moved / (base - moved); };
    std::vector<double> differences, depths;
    ParallaxDifference found;
    constexpr int step = 2 * DetailSearch::half;
    for (int y = step / 2; y + step / 2 <= view.height; y += step)
        for (int x = step / 2; x + step / 2 <= view.width; x += step) {
            const auto a = in_reference.movement(x, y), b = in_result.movement(x, y);
            if (!a || !b)
                continue;
            differences.push_back(std::fabs(mm * (*a - *b)));
            if (differences.back() >= found.greatest) {
                found.greatest = differences.back();
                found.place = sheet_place(view, metadata.film, x, y);
            }
            if (mm * *a < base && mm * *b < base) {
                depths.push_back(depth(mm * *b) - depth(mm * *a));
                found.greatest_depth = std::max(found.greatest_depth, std::fabs(depths.back()));
            }
        }
    if (differences.empty() || depths.empty())
        return std::nullopt;
    found.median = median_of(differences);
    found.median_depth = median_of(depths);
    found.details = int(differences.size());
    return found;
}

/// The place where two views differ most: the middle of the square with the greatest sum of squared
/// differences.
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
    const bool same = same_to_eyes(reference, compared);
    const std::vector<Eye> eyes = eyes_of(*rules.seen, metadata);
    for (std::size_t k = 0; k < eyes.size(); ++k) {
        const View view = view_of(eyes[k], metadata, view_pitch(eyes[k], metadata.film));
        Frame a{seen_of(reference, view), std::nullopt};
        Frame b = same ? a : Frame{seen_of(compared, view), std::nullopt};
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
    seen.parallax = parallax_difference(reference, compared, eyes);
    return seen;
}

std::string other_sheet(const FrameMetadata& a, const FrameMetadata& b)
{
    const Vec2 size_a = size_of(a.film), size_b = size_of(b.film);
    const auto words = [](Vec2 size) {
        return with_digits(size.x, 5) + "x" + with_digits(size.y, 5) + " mm";
    };
    if (std::fabs(size_a.x - size_b.x) <= std::max(a.film.pixel_pitch.x, b.film.pixel_pitch.x) &&
        std::fabs(size_a.y - size_b.y) <= std::max(a.film.pixel_pitch.y, b.film.pixel_pitch.y))
        return "";
    return "its film is " + words(size_b) + " large, the other's " + words(size_a);
}

Comparison compare_only_seen(const Frame& reference, const Frame& result,
                             const ComparisonRules& rules)
{
    Comparison comparison;
    comparison.of_pixels = false;
    comparison.rmse = comparison.psnr = comparison.ssim = comparison.largest_difference =
        comparison.within_two = comparison.differing = std::numeric_limits<double>::quiet_NaN();
    comparison.seen = std::make_shared<SeenFigures>(compare_seen(reference, result, rules));
    comparison.encoding = comparison.seen->overall.encoding;
    return comparison;
}

} // namespace integral
