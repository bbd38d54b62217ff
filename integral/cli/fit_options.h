// SPDX-License-Identifier: AGPL-3.0-or-later
// Options about the shapes and order of pictures, shared by commands.
#ifndef INTEGRAL_CLI_FIT_OPTIONS_H
#define INTEGRAL_CLI_FIT_OPTIONS_H

#include "integral/cli/command.h"
#include "integral/frame/picture_fit.h"

namespace integral {

/// --fit: how a picture is fitted to a target of another shape.
struct FitOptions {
    std::optional<std::string> given;
    /// Throws UsageError.
    Fit value() const;
};

void declare(options::options_description& all, FitOptions& fit);

/// --aspect and --right-to-left: properties that views do not state themselves.
struct ViewOrderOptions {
    std::optional<std::string> given_aspect;
    bool right_to_left = false;
    /// Width divided by height of each view, if given. Throws UsageError.
    std::optional<double> aspect() const;
};

void declare(options::options_description& all, ViewOrderOptions& views);

} // namespace integral

#endif
