// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/cli/compare_options.h"

#include "integral/base/number_text.h"
#include "integral/cli/values.h"

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
        all.add_options()(option_of(kind).c_str(),
                          options::value<std::string>()->value_name(kind.value_name),
                          kind.explanation);
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
            throw UsageError("--" + option + " " + text + ": a number from " +
                             with_digits(kind.least, 6) + " to " + with_digits(kind.greatest, 6) +
                             " is expected");
        limits[i] = limit;
    }
    return limits;
}

} // namespace integral
