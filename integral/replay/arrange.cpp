// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/replay/arrange.h"

#include <stdexcept>

namespace integral {

namespace {

void demand_alike(const Image& a, const Image& b)
{
    if (a.width != b.width || a.height != b.height || a.channels != b.channels || sample_bits(a) != sample_bits(b)
        || a.premultiplied != b.premultiplied)
        throw std::invalid_argument("the pictures differ in size or form");
}

} // namespace

std::vector<Eye> eye_pair(Eye middle, double separation)
{
    Eye left = middle, right = middle;
    left.x -= 0.5 * separation;
    right.x += 0.5 * separation;
    return {left, right};
}

std::vector<Eye> eye_grid(Eye middle, int columns, int rows, double width, double height)
{
    std::vector<Eye> eyes;
    for (int j = 0; j < rows; ++j)
        for (int i = 0; i < columns; ++i)
            eyes.push_back({middle.x + ((i + 0.5) / columns - 0.5) * width, middle.y - ((j + 0.5) / rows - 0.5) * height,
                            middle.distance});
    return eyes;
}

Image tiled(const std::vector<Image>& pictures, int columns, int border)
{
    if (pictures.empty() || columns < 1)
        throw std::invalid_argument("there are no pictures");
    const Image& first = pictures[0];
    for (const Image& picture : pictures)
        demand_alike(first, picture);
    const int rows = (int(pictures.size()) + columns - 1) / columns;
    Image sheet = blank_like(first, columns * (first.width + border) - border, rows * (first.height + border) - border);
    for (int y = 0; y < sheet.height; ++y)
        for (int x = 0; x < sheet.width; ++x) {
            const int i = x / (first.width + border), j = y / (first.height + border);
            const int inner_x = x - i * (first.width + border), inner_y = y - j * (first.height + border);
            const std::size_t k = std::size_t(j) * columns + i;
            const bool inside = k < pictures.size() && inner_x < first.width && inner_y < first.height;
            store_pixel(sheet, x, y, inside ? stored_pixel(pictures[k], inner_x, inner_y) : Color{0, 0, 0, 1});
        }
    return sheet;
}

Image anaglyph(const Image& left, const Image& right)
{
    demand_alike(left, right);
    Image image = blank_like(left, left.width, left.height);
    for (int y = 0; y < left.height; ++y)
        for (int x = 0; x < left.width; ++x) {
            const Color l = stored_pixel(left, x, y), r = stored_pixel(right, x, y);
            store_pixel(image, x, y, {l.r, r.g, r.b, 0.5f * (l.a + r.a)});
        }
    return image;
}

} // namespace integral
