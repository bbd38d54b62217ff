// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/depth/depth_picture.h"

#include "integral/replay/replay.h"
#include "integral/sheet/depth_advice.h"

#include <algorithm>
#include <cmath>

namespace integral {
namespace {

constexpr int longest_side = 800; // pixels
constexpr Colour sharp_tint{0.25f, 0.55f, 1.0f, 1}, soft_tint{1.0f, 0.75f, 0.1f, 1},
    beyond_tint{0.9f, 0.15f, 0.1f, 1}; // linear light; colour-blind readers can distinguish them

Colour tint_of(float depth, double budget)
{
    const double distance = std::fabs(double(depth));
    return distance <= budget                  ? sharp_tint
           : distance <= soft_budgets * budget ? soft_tint
                                               : beyond_tint;
}

/// A frame whose pixels have the tints of their depths.
Frame tinted_frame(const DepthFrame& depths, double budget)
{
    Encoding linear;
    linear.kind = Encoding::Kind::linear;
    const Film& film = depths.metadata.film;
    Frame frame{make_image<float>(film.width, film.height, 3, linear), std::nullopt};
    for (int y = 0; y < film.height; ++y)
        for (int x = 0; x < film.width; ++x) {
            const std::size_t at = std::size_t(y) * film.width + x;
            if (depths.imaged[at] > 0 && std::isfinite(depths.depth[at]))
                store_linear(frame.image, x, y, tint_of(depths.depth[at], budget));
        }
    FrameMetadata metadata = depths.metadata;
    metadata.encoding = linear;
    set_metadata(frame, metadata);
    return frame;
}

} // namespace

Image depth_picture(const DepthFrame& depths, double budget, const std::optional<Frame>& colours)
{
    View view;
    view.eye = centre_eye(depths.metadata);
    const Film& film = depths.metadata.film;
    set_view_size(view, film, std::min(longest_side, std::max(film.width, film.height)));
    const Image tints = *replay(tinted_frame(depths, budget), view);
    const std::optional<Image> seen = colours ? replay(*colours, view) : std::nullopt;
    const LinearReader tint(tints), light(seen ? *seen : tints);
    Image picture = make_image<std::uint8_t>(view.width, view.height, 3, Encoding());
    for (int y = 0; y < view.height; ++y)
        for (int x = 0; x < view.width; ++x) {
            const Colour t = tint(x, y), c = light(x, y);
            const float grey = std::min(1.0f, 0.2126f * c.r + 0.7152f * c.g + 0.0722f * c.b);
            const float lit = seen ? 0.15f + 0.85f * grey : 1.0f;
            store_linear(picture, x, y, {t.r * lit, t.g * lit, t.b * lit, 1});
        }
    return picture;
}

} // namespace integral
