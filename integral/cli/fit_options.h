// SPDX-License-Identifier: AGPL-3.0-or-later
// The options about shapes and order of pictures, for every command that has them.
#ifndef INTEGRAL_CLI_FIT_OPTIONS_H
#define INTEGRAL_CLI_FIT_OPTIONS_H

#include "integral/cli/command.h"
#include "integral/lightfield/picture_fit.h"

namespace integral {

/// --fit: how a picture is brought onto a target of another shape.
struct FitOptions {
    std::optional<std::string> given;
    /// Throws UsageError.
    Fit value() const;
};

void declare(options::options_description& all, FitOptions& fit);

/// --aspect and --right-to-left: what given views do not state themselves.
struct ViewOrderOptions {
    std::optional<std::string> given_aspect;
    bool right_to_left = false;
    /// Width divided by height of each view, if it was given. Throws UsageError.
    std::optional<double> aspect() const;
};

void declare(options::options_description& all, ViewOrderOptions& views);

} // namespace integral

#endif
