// SPDX-License-Identifier: AGPL-3.0-or-later
// Depth measured in frames, and pictures in focus at a depth, for Python.
#include "integral/base/interrupt.h"
#include "integral/depth/depth_files.h"
#include "integral/depth/depth_quality.h"
#include "integral/depth/relief_frame.h"
#include "integral/depth/relief_input.h"
#include "integral/io/image_file.h"
#include "integral/python/arrays.h"
#include "integral/python/calls.h"
#include "integral/python/rooms.h"

#include <pybind11/stl.h>

#include <algorithm>
#include <cmath>

namespace integral {
namespace {

constexpr int largest_map_side = 32768; // pixels, as of integral depth

DepthQuality quality_named(const std::string& name)
{
    const auto quality = depth_quality(name);
    if (!quality)
        throw std::invalid_argument("quality " + name + ": draft, good or best is expected");
    return *quality;
}

UprightMap measured(DepthInput input, DepthQuality quality, int width, int threads,
                    const Progress& progress)
{
    soften(input.views, threads);
    keep_views(input.views, quality);
    const auto map = multibaseline(input.views, settings_for(quality), threads, progress);
    if (!map)
        throw Interrupted();
    return upright_map(input.views, *map, input.width, input.height, width);
}

/// (depth_mm, metadata, eye_distances) of a depth frame.
py::tuple read_depth_frame(const std::string& path)
{
    DepthFrame frame = result_of_long(py::none(),
                                      [&](const Progress&) { return read_depths(path); });
    for (std::size_t k = 0; k < frame.depth.size(); ++k)
        if (!(frame.imaged[k] > 0))
            frame.depth[k] = NAN;
    const Film& film = frame.metadata.film;
    const py::object metadata = parsed(to_json(frame.metadata));
    return py::make_tuple(
        array_of(std::move(frame.depth), {film.height, film.width}), metadata,
        array_of(std::move(frame.eye_distances), {py::ssize_t(frame.eye_distances.size())}));
}

/// Writes the depths [y, x] of a frame or a quilt with its metadata.
void write_depth_frame(const std::string& path, const py::array& array, const py::object& document)
{
    DepthFrame frame;
    frame.metadata = frame_metadata_from_json(text_of(document));
    const Film& film = frame.metadata.film;
    const auto depths = py::array_t<float, py::array::c_style | py::array::forcecast>(array);
    if (depths.ndim() != 2 || depths.shape(0) != film.height || depths.shape(1) != film.width)
        throw std::invalid_argument("depth_mm: an array of shape (" + std::to_string(film.height) +
                                    ", " + std::to_string(film.width) + ") is expected");
    frame.depth.assign(depths.data(), depths.data() + depths.size());
    frame.imaged.assign(frame.depth.size(), 1);
    for (std::size_t k = 0; k < frame.depth.size(); ++k)
        if (std::isnan(frame.depth[k]))
            frame.depth[k] = frame.imaged[k] = 0;
    run_long(py::none(), [&](const Progress&) { write_depths(path, frame); });
}

/// (depth_mm, disparity, confidence, colour, pixel_mm) of a map; depth_mm and pixel_mm are None if
/// only disparities are known.
py::tuple arrays_of(UprightMap map)
{
    const std::vector<py::ssize_t> shape{map.height, map.width};
    std::vector<float> colour(map.disparity.size() * 3);
    for (std::size_t k = 0; k < colour.size(); ++k)
        colour[k] = map.colour[k % 3][k / 3];
    py::object depths = py::none(), pixel = py::none();
    if (map.scale) {
        depths = array_of(map.depths(), shape); // of the disparities, which then go
        pixel = py::float_(map.pixel);
    }
    return py::make_tuple(depths, array_of(std::move(map.disparity), shape),
                          array_of(std::move(map.confidence), shape),
                          array_of(std::move(colour), {map.height, map.width, 3}), pixel);
}

/// (depth_mm, disparity, confidence, colour, pixel_mm) of what the centre eye sees.
py::tuple depth(const py::object& of_python, const std::string& quality, int width, int threads,
                const py::object& progress)
{
    check_number("width", width, 0, largest_map_side);
    check_threads(threads);
    const Frame frame = frame_with_geometry(of_python);
    const DepthQuality chosen = quality_named(quality);
    return arrays_of(result_of_long(progress, [&](const Progress& report) {
        return measured(depth_input_of(frame, threads, piece_of(report, 0, 2)), chosen, width,
                        threads, piece_of(report, 1, 2));
    }));
}

/// The same of the middle one of views [row, column, y, x, channel]. `eyes`: spacing across and up,
/// distance and width, as of ViewEyes; without them depth_mm and pixel_mm are None.
py::tuple depth_of_views(const py::array& array, const py::object& encoding, double aspect,
                         const std::optional<std::array<double, 4>>& eyes,
                         const std::string& quality, int width, int threads,
                         const py::object& progress)
{
    check_number("width", width, 0, largest_map_side);
    check_number("aspect", aspect, 0.01, 100);
    for (const double length : eyes.value_or(std::array<double, 4>{1, 1, 1, 1}))
        check_number("eyes", length, 1e-9, 1e9);
    check_threads(threads);
    const DepthQuality chosen = quality_named(quality);
    std::optional<ViewEyes> places;
    if (eyes)
        places = ViewEyes{{(*eyes)[0], (*eyes)[1]}, (*eyes)[2], (*eyes)[3]};
    const ViewsOfArray views = views_from(array, encoding_from(encoding));
    return arrays_of(result_of_long(progress, [&](const Progress& report) {
        return measured(depth_input_of(views.pictures, views.grid, places, aspect), chosen, width,
                        threads, report);
    }));
}

py::array refocus(const py::object& of_python, double focus, double pupil, std::optional<int> width,
                  const std::string& quality, int threads, const py::object& progress)
{
    check_number("focus", focus, -1e6, 1e6);
    check_number("pupil", pupil, 0, 1e6);
    check_number("width", width.value_or(1), 1, largest_map_side);
    check_threads(threads);
    const Frame frame = frame_with_geometry(of_python);
    const DepthQuality chosen = quality_named(quality);
    return array_of(result_of_long(progress, [&](const Progress& report) {
        const DepthInput input = depth_input_of(frame, threads, piece_of(report, 0, 3));
        const Relief relief = measured_relief(input, chosen, threads, piece_of(report, 1, 3));
        if (!(focus > -relief.distance()))
            throw std::invalid_argument("focus: a depth before the eye is expected");
        constexpr double least_longer_side = 500; // pixels, as of integral depth
        Refocus lens;
        lens.focus = focus;
        lens.pupil = pupil;
        lens.width = width.value_or(
            int(std::lround(std::max(least_longer_side, input.width / relief.pixel()))));
        lens.height = std::max(1, int(std::lround(lens.width * input.height / input.width)));
        return refocused(relief, lens, input.form, threads, piece_of(report, 2, 3)).image;
    }));
}

} // namespace

void declare_depth(py::module_& module)
{
    module.def("read_depths", read_depth_frame);
    module.def("write_depths", write_depth_frame);
    module.def("depth", depth);
    module.def("depth_of_views", depth_of_views);
    module.def("refocus", refocus);
}

} // namespace integral
