// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/print/paper.h"

#include <cctype>

namespace integral {
namespace {

struct Named {
    const char* name;
    double width, height; ///< in units of `unit` mm
    double unit;
};

constexpr Named papers[] = {{"3.5x5", 3.5, 5, mm_per_inch},
                            {"4x6", 4, 6, mm_per_inch},
                            {"4.5x8", 4.5, 8, mm_per_inch},
                            {"5x7", 5, 7, mm_per_inch},
                            {"6x6", 6, 6, mm_per_inch},
                            {"6x8", 6, 8, mm_per_inch},
                            {"6x9", 6, 9, mm_per_inch},
                            {"8x8", 8, 8, mm_per_inch},
                            {"8x10", 8, 10, mm_per_inch},
                            {"8x12", 8, 12, mm_per_inch},
                            {"postcard", 100, 148, 1},
                            {"letter", 8.5, 11, mm_per_inch},
                            {"legal", 8.5, 14, mm_per_inch},
                            {"tabloid", 11, 17, mm_per_inch},
                            {"A0", 841, 1189, 1},
                            {"A1", 594, 841, 1},
                            {"A2", 420, 594, 1},
                            {"A3", 297, 420, 1},
                            {"A4", 210, 297, 1},
                            {"A5", 148, 210, 1},
                            {"A6", 105, 148, 1},
                            {"B1", 707, 1000, 1},
                            {"B2", 500, 707, 1},
                            {"B3", 353, 500, 1},
                            {"SRA3", 320, 450, 1},
                            {"SRA4", 225, 320, 1}};

std::string lower(std::string text)
{
    for (char& c : text)
        c = char(std::tolower(static_cast<unsigned char>(c)));
    return text;
}

} // namespace

std::optional<Paper> paper_named(const std::string& name)
{
    for (const Named& paper : papers)
        if (lower(paper.name) == lower(name))
            return Paper{paper.width * paper.unit, paper.height * paper.unit};
    return std::nullopt;
}

Paper paper_for(Paper named, const Film& film)
{
    const Vec2 size = size_of(film);
    return size.x > size.y ? Paper{named.height, named.width} : named;
}

std::string paper_names()
{
    std::string names;
    const std::size_t count = std::size(papers);
    for (std::size_t k = 0; k < count; ++k)
        names += std::string(k == 0 ? "" : k + 1 == count ? " and " : ", ") + papers[k].name;
    return names;
}

} // namespace integral
