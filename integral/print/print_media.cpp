// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/print/print_media.h"

#include "integral/optics/film.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstring>

namespace integral {

namespace {

constexpr double mm_per_point = mm_per_inch / 72;
constexpr double tolerance_mm = 0.5;

bool same_size(SizeMm a, SizeMm b)
{
    return std::abs(a.width - b.width) <= tolerance_mm &&
           std::abs(a.height - b.height) <= tolerance_mm;
}

/// Whether to prefer medium `a` to `b` of the same size: for its larger printable area (not if
/// `by_nominal`), else for its shorter name.
bool better(const PrintMedium& a, const PrintMedium& b, bool by_nominal)
{
    const double more = a.printable.width * a.printable.height -
                        b.printable.width * b.printable.height;
    if (!by_nominal && std::abs(more) > 1)
        return more > 0;
    return a.name.size() < b.name.size();
}

/// A page's samples. The page has to be 8-bit RGB.
const std::vector<std::uint8_t>& bytes_of(const Image& page)
{
    return std::get<std::vector<std::uint8_t>>(page.samples);
}
std::vector<std::uint8_t>& bytes_of(Image& page)
{
    return std::get<std::vector<std::uint8_t>>(page.samples);
}

} // namespace

SizeMm nominal_size(const PrintMedium& medium)
{
    double width = 0, height = 0;
    if (std::sscanf(medium.name.c_str(), "w%lfh%lf", &width, &height) == 2 && width > 0 &&
        height > 0)
        return {width * mm_per_point, height * mm_per_point};
    // The label's first figures; words may come before them, as in "Postcard 100x148mm".
    const std::size_t digit = medium.label.find_first_of("0123456789");
    int end = 0;
    if (digit != std::string::npos &&
        std::sscanf(medium.label.c_str() + digit, "%lf x %lf%n", &width, &height, &end) == 2) {
        const bool in_mm = medium.label.compare(digit + std::size_t(end), 2, "mm") == 0;
        const double unit = in_mm ? 1 : mm_per_inch;
        // A label such as "100x148", read as inches, would be metres wide: do not use it.
        if (width > 0 && height > 0 && (in_mm || (width <= 100 && height <= 100)))
            return {width * unit, height * unit};
    }
    return medium.standard.width > 0 ? medium.standard : medium.sheet;
}

std::optional<PagePlace> place_page(const std::vector<PrintMedium>& media, SizeMm page,
                                    const std::string& name)
{
    using SizeOf = SizeMm (*)(const PrintMedium&);
    static const SizeOf sizes[] = {[](const PrintMedium& medium) { return medium.printable; },
                                   nominal_size,
                                   [](const PrintMedium& medium) { return medium.sheet; }};
    for (SizeOf size_of : sizes)
        for (bool turned : {false, true}) {
            const SizeMm requested = turned ? SizeMm{page.height, page.width} : page;
            std::optional<PagePlace> best;
            for (std::size_t i = 0; i < media.size(); ++i) {
                if (!name.empty() && media[i].name != name)
                    continue;
                if (same_size(size_of(media[i]), requested) &&
                    (!best || better(media[i], media[best->medium], size_of == nominal_size)))
                    best = PagePlace{i, turned};
            }
            if (best)
                return best;
        }
    return std::nullopt;
}

std::string media_in_words(const std::vector<PrintMedium>& media)
{
    std::string words;
    for (const PrintMedium& medium : media) {
        const SizeMm nominal = nominal_size(medium);
        char size[64];
        std::snprintf(size, sizeof size, " (%.1f x %.1f mm, ", nominal.width, nominal.height);
        words += (words.empty() ? "" : ", ") + medium.label + size + medium.name + ")";
    }
    return words.empty() ? "none" : words;
}

Image turned_page(const Image& page)
{
    Image turned = blank_like(page, page.height, page.width);
    const std::uint8_t* from = bytes_of(page).data();
    std::uint8_t* to = bytes_of(turned).data();
    for (int y = 0; y < page.height; ++y)
        for (int x = 0; x < page.width; ++x)
            std::memcpy(to + (std::size_t(x) * turned.width + (page.height - 1 - y)) * 3,
                        from + (std::size_t(y) * page.width + x) * 3, 3);
    return turned;
}

std::optional<Image> centred_page(const Image& page, int width, int height)
{
    Image area = blank_like(page, width, height);
    const std::vector<std::uint8_t>& from = bytes_of(page);
    std::vector<std::uint8_t>& to = bytes_of(area);
    std::fill(to.begin(), to.end(), std::uint8_t(255));
    // The page's corner on the area, rounded down: a page a pixel too wide loses its first column.
    const int left = int(std::floor((width - page.width) / 2.0)),
              top = int(std::floor((height - page.height) / 2.0));
    const auto white = [&](int y, int begin, int end) {
        const auto row = from.begin() + std::ptrdiff_t(y) * page.width * 3;
        return begin >= end || std::all_of(row + begin * 3, row + end * 3,
                                           [](std::uint8_t sample) { return sample == 255; });
    };
    const int first = std::max(0, -left), last = std::min(page.width, width - left);
    for (int y = 0; y < page.height; ++y) {
        if (y + top < 0 || y + top >= height) {
            if (!white(y, 0, page.width))
                return std::nullopt;
            continue;
        }
        if (!white(y, 0, first) || !white(y, last, page.width))
            return std::nullopt;
        const std::size_t begin = (std::size_t(y) * page.width + std::size_t(first)) * 3;
        std::memcpy(&to[(std::size_t(y + top) * width + std::size_t(left + first)) * 3],
                    &from[begin], std::size_t(last - first) * 3);
    }
    return area;
}

} // namespace integral
