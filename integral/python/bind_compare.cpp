// SPDX-License-Identifier: AGPL-3.0-or-later
// Figures of two pictures, for Python.
#include "integral/compare/comparison_rules.h"
#include "integral/compare/figures_json.h"
#include "integral/python/arrays.h"
#include "integral/python/calls.h"
#include "integral/python/rooms.h"

namespace integral {

void declare_compare(py::module_& module)
{
    module.def("compare", [](const py::object& a, const py::object& b, bool flip) {
        const Frame first = frame_from(a), second = frame_from(b);
        require_same_size(first.image, second.image);
        ComparisonRules rules;
        rules.flip = flip;
        return python_of(result_of_long(py::none(), [&](const Progress&) {
            return figures_json(compare(first, second, settings_in_memory(rules, first, second)));
        }));
    });
    module.def("difference", [](const py::object& a, const py::object& b, double gain) {
        const Frame first = frame_from(a), second = frame_from(b);
        require_same_size(first.image, second.image);
        return array_of(difference_picture(first.image, second.image, gain));
    });
}

} // namespace integral
