// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/replay/arrange.h"

#include "integral/base/constants.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace integral {

Vec2 viewing_zone(const FrameMetadata& metadata, double distance)
{
    return (distance / metadata.aperture.distance) *
           viewing_zone(metadata.sheet, metadata.aperture);
}

std::vector<Eye> eye_pair(Eye middle, double separation)
{
    Eye left = middle, right = middle;
    left.x -= 0.5 * separation;
    right.x += 0.5 * separation;
    return {left, right};
}

std::vector<Eye> eye_grid(Eye middle, int columns, int rows, Vec2 zone)
{
    std::vector<Eye> eyes;
    for (int j = 0; j < rows; ++j)
        for (int i = 0; i < columns; ++i)
            eyes.push_back({middle.x + ((i + 0.5) / columns - 0.5) * zone.x,
                            middle.y - ((j + 0.5) / rows - 0.5) * zone.y, middle.distance});
    return eyes;
}

std::vector<Eye> contact_sheet_eyes(const FrameMetadata& metadata, Eye middle, int columns,
                                    int rows)
{
    const Vec2 zone = viewing_zone(metadata, middle.distance);
    if (rows > 1 || !lenses_lie_across(metadata.sheet))
        return eye_grid(middle, columns, rows, zone);
    std::vector<Eye> eyes = eye_grid(middle, 1, columns, zone);
    std::reverse(eyes.begin(), eyes.end());
    return eyes;
}

std::vector<Eye> eye_path(EyePath path, Eye middle, Vec2 zone, std::optional<double> span,
                          int steps, bool upwards)
{
    const double wide = upwards ? zone.y : zone.x, start = upwards ? middle.y : middle.x;
    std::vector<Eye> eyes;
    for (int k = 0; k < steps; ++k) {
        const double along = steps > 1 ? double(k) / (steps - 1) - 0.5 : 0; // -0.5 to 0.5
        Eye eye = middle;
        double& place = upwards ? eye.y : eye.x;
        switch (path) {
        case EyePath::turntable: {
            const double all = span ? *span * pi / 180
                                    : 2 * std::atan2(0.5 * wide, middle.distance);
            const double radius = std::hypot(start, middle.distance),
                         turn = std::atan2(start, middle.distance) + along * all;
            place = radius * std::sin(turn);
            eye.distance = radius * std::cos(turn);
            break;
        }
        case EyePath::sweep: place += along * span.value_or(wide); break;
        case EyePath::sway:
            place += 0.5 * span.value_or(0.8 * wide) * std::sin(2 * pi * k / steps);
            break;
        case EyePath::circle: {
            const double longer = std::max(zone.x, zone.y),
                         scale = 0.5 * span.value_or(0.8 * longer), turn = 2 * pi * k / steps;
            const Vec2 shape = longer > 0 ? (1 / longer) * zone
                                          : Vec2{1, 1}; // a zone of size 0 has no aspect
            eye.x -= scale * shape.x * std::cos(turn);
            eye.y += scale * shape.y * std::sin(turn);
            break;
        }
        case EyePath::dolly: eye.distance *= std::pow(span.value_or(4), -along); break;
        }
        eyes.push_back(eye);
    }
    return eyes;
}

std::optional<std::vector<Image>> replay_each(const Frame& frame, View view,
                                              const std::vector<Eye>& eyes, int threads,
                                              const Progress& progress)
{
    std::vector<Image> pictures;
    for (const Eye& eye : eyes) {
        view.eye = eye;
        auto picture = replay(frame, view, threads,
                              piece_of(progress, int(pictures.size()), int(eyes.size())));
        if (!picture)
            return std::nullopt;
        pictures.push_back(std::move(*picture));
    }
    return pictures;
}

Image anaglyph(const Image& left, const Image& right)
{
    if (!same_form(left, right))
        throw std::invalid_argument("the pictures differ in size or form");
    Image image = blank_like(left, left.width, left.height);
    for (int y = 0; y < left.height; ++y)
        for (int x = 0; x < left.width; ++x) {
            const Colour l = stored_pixel(left, x, y), r = stored_pixel(right, x, y);
            store_pixel(image, x, y, {l.r, r.g, r.b, 0.5f * (l.a + r.a)});
        }
    return image;
}

} // namespace integral
