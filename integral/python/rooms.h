// SPDX-License-Identifier: AGPL-3.0-or-later
// The parts of the extension module _integral, one for each room of the library. Functions take
// and return arrays, tuples and documents; the classes of the package integral (integral/*.py)
// give them their names, units and explanations.
#ifndef INTEGRAL_PYTHON_ROOMS_H
#define INTEGRAL_PYTHON_ROOMS_H

#include <pybind11/pybind11.h>

namespace integral {

void declare_frame(pybind11::module_& module);
void declare_io(pybind11::module_& module);
void declare_optics(pybind11::module_& module);
void declare_sheet(pybind11::module_& module);
void declare_compare(pybind11::module_& module);
void declare_replay(pybind11::module_& module);
void declare_views(pybind11::module_& module);
void declare_panel(pybind11::module_& module);
void declare_depth(pybind11::module_& module);

} // namespace integral

#endif
