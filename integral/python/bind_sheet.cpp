// SPDX-License-Identifier: AGPL-3.0-or-later
// Figures of sheets, known sheets and fits, for Python.
#include "integral/frame/geometry_json.h"
#include "integral/python/arrays.h"
#include "integral/python/calls.h"
#include "integral/python/rooms.h"
#include "integral/sheet/known_sheets.h"
#include "integral/sheet/scene_fit.h"
#include "integral/sheet/sheet_report.h"
#include "integral/views/zone_view.h"

#include <pybind11/stl.h>

namespace integral {
namespace {

constexpr double smallest = 1e-9; // of what must be greater than 0

/// (sheet_distance, parallax, share of the distances within the allowed depth).
py::tuple fit(const py::array_t<double, py::array::c_style | py::array::forcecast>& array,
              const py::object& document, double budgets, std::optional<double> sheet_distance,
              std::optional<double> parallax)
{
    check_number("budgets", budgets, 0.1, 100);
    check_number("sheet_distance", sheet_distance.value_or(1), smallest, 1e9);
    check_number("parallax", parallax.value_or(1), smallest, 100);
    const std::vector<double> distances(array.data(), array.data() + array.size());
    const FrameMetadata geometry = frame_metadata_from_json(text_of(document));
    const auto budget = seen_budget(geometry);
    if (!budget)
        throw std::invalid_argument("this sheet has no depth budget: its lenses are too wide for "
                                    "their thickness");
    for (const double distance : distances)
        if (!(distance > 0))
            throw std::invalid_argument("distances must be greater than 0; math.inf is allowed");
    const auto ends = depth_ends(distances);
    if (!ends)
        throw std::invalid_argument("no distance is finite; give the distances of surfaces");
    const double beta = budgets * *budget / viewer_distance(geometry);
    const SceneFit found = fit_to_budget(*ends, {beta, sheet_distance, parallax});
    return py::make_tuple(found.sheet_distance, found.parallax,
                          part_within(found, distances, beta));
}

} // namespace

void declare_sheet(py::module_& module)
{
    module.def("sheet_figures", [](const py::object& document, std::vector<double> depths,
                                   double pupil) {
        check_number("pupil", pupil, smallest, 1e9);
        for (const double depth : depths)
            check_number("depths", depth, smallest, 1e12);
        Viewer viewer;
        viewer.pupil = pupil;
        viewer.depths = std::move(depths);
        const FrameMetadata geometry = frame_metadata_from_json(text_of(document));
        viewer.ghost = ghost_in_zone(geometry);
        return python_of(sheet_report_json(geometry, viewer));
    });
    module.def("known_sheets", [] {
        py::dict sheets;
        for (const KnownSheet& known : known_sheets())
            sheets[known.name] = python_of(json_of(known.sheet));
        return sheets;
    });
    module.def("fit", fit);
}

} // namespace integral
