// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/analysis/page_code.h"

#include <algorithm>
#include <optional>
#include <stdexcept>

namespace integral {
namespace {

/// Luminance of a point of the page; nothing outside the photo.
std::optional<double> light_at(const Plane& photo, const PhotoCamera& camera, Vec2 page)
{
    const Vec2 at = photo_from_page(camera, {page.x, page.y, 0});
    if (!is_inside(photo, at))
        return std::nullopt;
    return value_at(photo, at);
}

/// Whether a square has a dot; nothing if the photo does not show it clearly.
std::optional<bool> has_dot(const Plane& photo, const PhotoCamera& camera, const CodeSquare& square)
{
    constexpr double beside = 2.1 * code_dot, least_contrast = 0.3;
    double white = 0;
    for (const Vec2 away : {Vec2{beside, 0}, Vec2{-beside, 0}, Vec2{0, beside}, Vec2{0, -beside}}) {
        const auto light = light_at(photo, camera, square.middle + away);
        if (!light)
            return std::nullopt;
        white += *light / 4;
    }
    const auto middle = light_at(photo, camera, square.middle),
               black = light_at(photo, camera, square.black);
    if (!middle || !black || !(white - *black > least_contrast * white))
        return std::nullopt;
    return *middle < 0.5 * (white + *black);
}

} // namespace

void check_page_code(const Plane& photo, const PhotoCamera& camera,
                     const std::vector<CodeSquare>& code)
{
    const std::size_t least = std::min<std::size_t>(24, code.size());
    constexpr double least_share = 0.85;
    std::size_t seen = 0, right = 0;
    for (const CodeSquare& square : code)
        if (const auto dot = has_dot(photo, camera, square)) {
            ++seen;
            right += *dot == square.dot;
        }
    if (seen < least)
        throw std::invalid_argument(
            "fewer than " + std::to_string(least) +
            " white squares between the rings are visible; photograph the page without anything on "
            "its squares, sharp");
    if (!(double(right) >= least_share * double(seen)))
        throw std::invalid_argument("its code is that of a page for other options; give the "
                                    "options that the page was made with, which its heading has, "
                                    "or print the page again");
}

} // namespace integral
