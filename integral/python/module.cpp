// SPDX-License-Identifier: AGPL-3.0-or-later
// The extension module _integral of the Python package integral.
#include "integral/python/calls.h"
#include "integral/python/rooms.h"

#ifndef PACKAGE_VERSION
#error "PACKAGE_VERSION must be defined, as configure does"
#endif

PYBIND11_MODULE(_integral, module)
{
    module.doc() = "The C++ library of the package integral, which is the interface to use.";
    module.attr("version") = PACKAGE_VERSION;
    integral::declare_messages(module);
    integral::declare_frame(module);
    integral::declare_io(module);
    integral::declare_optics(module);
    integral::declare_sheet(module);
    integral::declare_compare(module);
    integral::declare_replay(module);
    integral::declare_views(module);
    integral::declare_panel(module);
    integral::declare_depth(module);
}
