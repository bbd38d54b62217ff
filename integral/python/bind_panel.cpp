// SPDX-License-Identifier: AGPL-3.0-or-later
// Images for light-field panels, for Python.
#include "integral/panel/panel_images.h"
#include "integral/python/arrays.h"
#include "integral/python/calls.h"
#include "integral/python/rooms.h"

#include <pybind11/stl.h>

namespace integral {
namespace {

/// Options of images for a panel; notices go to `notices`.
PanelImageOptions options_of(const std::string& panel, int threads, const Progress& report,
                             std::vector<std::string>& notices)
{
    PanelImageOptions options;
    options.threads = threads;
    options.panel_name = panel;
    options.tell = [&notices](const std::string& line) { notices.push_back(line); };
    options.progress = [report](const char*) { return report; };
    return options;
}

/// (image, encoding, premultiplied, metadata) of the panel's image, and notices. `views`: [row,
/// column, y, x, channel]; None: the frame's own views.
py::tuple interlace_for(const py::object& of_python, const py::object& views,
                        const py::object& encoding, const std::string& panel,
                        std::optional<std::pair<int, int>> grid, const std::string& fit,
                        int threads, const py::object& progress)
{
    check_threads(threads);
    if (grid)
        check_grid("grid", *grid, most_views_one_way);
    const Fit chosen = fit_from(fit);
    const Panel found = find_panel(panel);
    std::optional<Frame> frame;
    ViewInput input;
    if (views.is_none()) {
        frame = frame_with_geometry(of_python);
    } else {
        ViewsOfArray of_array = views_from(views, encoding_from(encoding));
        input.grid = of_array.grid;
        input.views = std::move(of_array.pictures);
        input.shape = double(input.views[0].width) / input.views[0].height;
    }
    std::vector<std::string> notices;
    Frame image = result_of_long(progress, [&](const Progress& report) {
        PanelImageOptions options = options_of(panel, threads, report, notices);
        options.fit = chosen;
        if (grid)
            options.views = ViewGrid{grid->first, grid->second};
        PanelImages images(found, options);
        return frame ? images.image_of_frame("the frame", *frame)
                     : images.image_of_views("the views", std::move(input));
    });
    return py::make_tuple(python_of(std::move(image)), notices);
}

} // namespace

void declare_panel(py::module_& module)
{
    module.def("interlace", interlace_for);
    module.def("panel", [](const std::string& name) { return parsed(to_json(find_panel(name))); });
    module.def("panel_names", [] {
        std::vector<std::string> names;
        for (const Panel& panel : known_panels())
            names.push_back(panel.name);
        return names;
    });
}

} // namespace integral
