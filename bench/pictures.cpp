// SPDX-License-Identifier: AGPL-3.0-or-later
#include "bench/pictures.h"

#include "integral/base/file_bytes.h"
#include "integral/io/image_file.h"
#include "integral/io/plot_canvas.h"

#include <algorithm>
#include <cmath>

namespace integral::bench {

Image shrunk(const Image& image, int block)
{
    Image result = make_image<std::uint16_t>(image.width / block, image.height / block, 3,
                                             image.encoding);
    const LinearReader read(image);
    const float weight = 1.0f / float(block * block);
    for (int y = 0; y < result.height; ++y)
        for (int x = 0; x < result.width; ++x) {
            Colour sum;
            for (int j = 0; j < block; ++j)
                for (int i = 0; i < block; ++i) {
                    const Colour c = read(x * block + i, y * block + j);
                    sum = {sum.r + c.r * weight, sum.g + c.g * weight, sum.b + c.b * weight, 1};
                }
            store_linear(result, x, y, sum);
        }
    return result;
}

void ColourDifferences::add(const Colour& a, const Colour& b)
{
    for (const double difference : {double(a.r) - b.r, double(a.g) - b.g, double(a.b) - b.b})
        squares_ += difference * difference;
    values_ += 3;
}

double ColourDifferences::rms() const
{
    return std::sqrt(squares_ / double(std::max(values_, 1LL)));
}

void LabelledPictures::write(const std::string& path, int times) const
{
    constexpr int border = 4, head = 24;
    const int wide = times * pictures[0].width, high = times * pictures[0].height;
    const auto left = [&](std::size_t i) { return head + int(i) * (wide + border); };
    const auto top = [&](std::size_t j) { return head + int(j) * (high + border); };
    PlotCanvas canvas(left(columns.size()), top(rows.size()), PlotFormat::png);
    canvas.set_font(15, false);
    for (std::size_t i = 0; i < columns.size(); ++i)
        canvas.write(columns[i], left(i) + 0.5 * (wide - canvas.text_width(columns[i])), head - 7,
                     {0, 0, 0});
    for (std::size_t j = 0; j < rows.size(); ++j)
        canvas.write_upwards(rows[j], head - 7,
                             top(j) + high - 0.5 * (high - canvas.text_width(rows[j])), {0, 0, 0});
    write_file(path, canvas.finish(""));
    Image table = read_frame(path).image;
    for (std::size_t k = 0; k < pictures.size(); ++k)
        for (int y = 0; y < high; ++y)
            for (int x = 0; x < wide; ++x)
                store_pixel(table, left(k % columns.size()) + x, top(k / columns.size()) + y,
                            stored_pixel(pictures[k], x / times, y / times));
    write_frame(path, {table, {}});
}

} // namespace integral::bench
