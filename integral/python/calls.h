// SPDX-License-Identifier: AGPL-3.0-or-later
// Calls long-running functions of the library from Python: without Python's lock, and so that
// Ctrl-C ends them.
#ifndef INTEGRAL_PYTHON_CALLS_H
#define INTEGRAL_PYTHON_CALLS_H

#include "integral/base/parallel.h"

#include <pybind11/pybind11.h>

#include <functional>
#include <optional>
#include <utility>

namespace integral {

namespace py = pybind11;

/// Runs `work` in a thread of its own and waits for it without Python's lock. `progress`: None, or
/// a Python function that is called with (done, total), in the calling thread, some times a second.
/// An exception of it, or Ctrl-C, stops the work and is thrown; so is an exception of the work. The
/// notices of the work, also if it fails, become Python warnings.
void run_long(const py::object& progress, const std::function<void(const Progress&)>& work);

/// The result of work(Progress), run as in run_long.
template <class Work> auto result_of_long(const py::object& progress, Work work)
{
    std::optional<decltype(work(Progress()))> result;
    run_long(progress, [&](const Progress& report) { result.emplace(work(report)); });
    return std::move(*result);
}

/// Adds the exceptions of the library to a module, and receives its notices.
void declare_messages(py::module_& module);

} // namespace integral

#endif
