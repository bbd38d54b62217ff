// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/compare/comparison_rules.h"

#include "integral/base/constants.h"
#include "integral/io/image_file.h"

#include <algorithm>
#include <cmath>

namespace integral {

double pixels_per_degree(const FrameMetadata& metadata)
{
    const double pitch = std::sqrt(metadata.film.pixel_pitch.x * metadata.film.pixel_pitch.y);
    return 1 / (degrees_per_radian * 2 * std::atan(pitch / (2 * viewer_distance(metadata))));
}

ComparisonSettings settings_of(const ComparisonRules& rules, const Frame& a, const Frame& b)
{
    ComparisonSettings settings;
    settings.channel_tolerance = rules.channel_tolerance;
    const auto& metadata = a.metadata ? a.metadata : b.metadata;
    if (!rules.regions.empty() || !rules.mask.empty()) {
        std::optional<Image> mask;
        if (!rules.mask.empty())
            mask = read_frame(rules.mask).image;
        settings.weights = std::make_shared<PixelWeights>(rules.regions, mask, a.image.width,
                                                          a.image.height, metadata);
    }
    if (rules.flip) {
        settings.flip.emplace();
        if (rules.ppd)
            settings.flip->ppd = *rules.ppd;
        else if (metadata && viewer_distance(*metadata) > 0)
            settings.flip->ppd = std::clamp(pixels_per_degree(*metadata), least_ppd, greatest_ppd);
    }
    return settings;
}

bool needs_exposures(const Image& a, const Image& b)
{
    return sample_bits(a) == 32 || sample_bits(b) == 32;
}

void meter_rows(FlipExposureMeter& meter, const Image& rows)
{
    const auto& luminance = flip_matrices().relative_from_rgb[1];
    const LinearReader read(rows);
    for (int y = 0; y < rows.height; ++y)
        for (int x = 0; x < rows.width; ++x) {
            const Colour c = read(x, y);
            meter.add(float(luminance[0] * c.r + luminance[1] * c.g + luminance[2] * c.b));
        }
}

ComparisonSettings settings_in_memory(const ComparisonRules& rules, const Frame& reference,
                                      const Frame& result)
{
    ComparisonSettings settings = settings_of(rules, reference, result);
    if (settings.flip && needs_exposures(reference.image, result.image)) {
        FlipExposureMeter meter;
        meter_rows(meter, reference.image);
        settings.flip->exposures = meter.exposures();
    }
    return settings;
}

} // namespace integral
