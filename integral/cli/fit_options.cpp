// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/cli/fit_options.h"

#include "integral/cli/choices.h"

namespace integral {

void declare(options::options_description& all, FitOptions& fit)
{
    add(all, "fit", fit.given, "HOW",
        "a picture of another shape: contain, whole with black bars (default); cover, filling, "
        "with two sides cut off; or stretch. Shapes that differ by at most 1% are stretched");
}

Fit FitOptions::value() const
{
    return meaning_of("fit", given.value_or("contain"), fit_choices);
}

void declare(options::options_description& all, ViewOrderOptions& views)
{
    add(all, "aspect", views.given_aspect, "A",
        "a view's width divided by its height, as it is to be seen (default: as geometry or a "
        "quilt's name states, else that of its pixels)");
    add(all, "right-to-left", views.right_to_left,
        "the views go from right to left, in place of from left to right");
}

std::optional<double> ViewOrderOptions::aspect() const
{
    if (!given_aspect)
        return std::nullopt;
    return parse_number_between("aspect", *given_aspect, "a width divided by a height", 0.01, 100,
                                "0.01 to 100");
}

} // namespace integral
