// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/cli/compare_figures.h"

#include "integral/base/number_text.h"
#include "integral/cli/values.h"
#include "integral/lightfield/names.h"

#include <nlohmann/json.hpp>

#include <algorithm>

namespace integral {
namespace {

std::string option_of(const LimitKind& kind)
{
    std::string option = kind.word;
    std::replace(option.begin(), option.end(), '_', '-');
    return option;
}

} // namespace

void add_limit_options(options::options_description& all)
{
    for (const LimitKind& kind : limit_kinds)
        all.add_options()(option_of(kind).c_str(), options::value<std::string>()->value_name(kind.value_name), kind.explanation);
}

Limits limits_from(const options::variables_map& arguments)
{
    Limits limits;
    for (std::size_t i = 0; i < limit_count; ++i) {
        const LimitKind& kind = limit_kinds[i];
        const std::string option = option_of(kind);
        if (!given(arguments, option.c_str()))
            continue;
        const std::string text = text_of(arguments, option.c_str());
        const double limit = parse_number(option.c_str(), text, "a number");
        if (!(limit >= kind.least && limit <= kind.greatest))
            throw UsageError("--" + option + " " + text + ": a number from " + with_digits(kind.least, 6) + " to " +
                             with_digits(kind.greatest, 6) + " is expected");
        limits[i] = limit;
    }
    return limits;
}

nlohmann::ordered_json figures_json(const Comparison& c)
{
    nlohmann::ordered_json json = {{"rmse", c.rmse},
                                   {"psnr", c.psnr}, // infinity is written as null
                                   {"ssim", c.ssim},
                                   {"largest_difference", c.largest_difference},
                                   {"within_two", c.within_two},
                                   {"encoding", name_of(c.encoding.kind)},
                                   {"worst_micro_image", nullptr}};
    if (c.worst)
        json["worst_micro_image"] = {{"lens", {c.worst->lens.i, c.worst->lens.j}},
                                     {"pole_mm", {c.worst->pole.x, c.worst->pole.y}},
                                     {"rmse", c.worst->rmse}};
    return json;
}

} // namespace integral
