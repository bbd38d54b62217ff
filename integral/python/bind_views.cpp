// SPDX-License-Identifier: AGPL-3.0-or-later
// Light fields and views of frames, and frames of views, for Python.
#include "integral/python/arrays.h"
#include "integral/python/calls.h"
#include "integral/python/rooms.h"
#include "integral/replay/arrange.h"
#include "integral/views/light_field.h"
#include "integral/views/parallel_views.h"
#include "integral/views/perspective_views.h"
#include "integral/views/view_input.h"

#include <pybind11/stl.h>

#include <limits>

namespace integral {
namespace {

using Directions = std::optional<std::pair<int, int>>;

ViewGrid grid_of(const Directions& directions, const FrameMetadata& metadata)
{
    if (!directions)
        return natural_views(metadata);
    if (directions->first < 1 || directions->second < 1)
        throw std::invalid_argument("the numbers of directions must be 1 or more");
    return {directions->first, directions->second};
}

/// The axes of a light field as arrays: (u_mm, v_mm, s_mm, t_mm, aperture_mm [v, u, 2], poles_mm
/// [t, s, 2]). A direction without light is NaN.
py::tuple axes_of(const LightFieldAxes& axes, double distance)
{
    constexpr double none = std::numeric_limits<double>::quiet_NaN();
    std::vector<double> aperture, poles, u, v, s, t;
    const auto direction = [&](int j, int i) {
        return axes.aperture_point(j, i, distance).value_or(Vec2{none, none});
    };
    for (int j = 0; j < axes.v(); ++j)
        for (int i = 0; i < axes.u(); ++i) {
            const Vec2 at = direction(j, i);
            aperture.insert(aperture.end(), {at.x, at.y});
        }
    for (int j = 0; j < axes.t(); ++j)
        for (int i = 0; i < axes.s(); ++i) {
            const Vec2 at = axes.pole(j, i);
            poles.insert(poles.end(), {at.x, at.y});
        }
    for (int i = 0; i < axes.u(); ++i)
        u.push_back(axes.along_rows(direction(axes.v() / 2, i)));
    for (int j = 0; j < axes.v(); ++j)
        v.push_back(axes.across_rows(direction(j, axes.u() / 2)));
    for (int i = 0; i < axes.s(); ++i)
        s.push_back(axes.along_rows(axes.pole(axes.t() / 2, i)));
    for (int j = 0; j < axes.t(); ++j)
        t.push_back(axes.across_rows(axes.pole(j, axes.s() / 2)));
    return py::make_tuple(array_of(std::move(u), {axes.u()}), array_of(std::move(v), {axes.v()}),
                          array_of(std::move(s), {axes.s()}), array_of(std::move(t), {axes.t()}),
                          array_of(std::move(aperture), {axes.v(), axes.u(), 2}),
                          array_of(std::move(poles), {axes.t(), axes.s(), 2}));
}

/// (place, samples, axes): `place` is (first column, first row, v, u, t, s) of an exact light
/// field, whose samples are a view of the frame's own array and None here; else None, and the
/// samples are [v, u, t, s, channel].
py::tuple light_field(const py::object& frame, const Directions& directions, int threads,
                      const py::object& progress)
{
    const FrameMetadata metadata = geometry_from(frame);
    const LightFieldAxes axes(metadata, grid_of(directions, metadata));
    const py::tuple arrays = axes_of(axes, metadata.aperture.distance);
    if (axes.is_exact())
        return py::make_tuple(py::make_tuple(axes.first().column, axes.first().row, axes.v(),
                                             axes.u(), axes.t(), axes.s()),
                              py::none(), arrays);
    const Frame made = frame_with_geometry(frame);
    Image samples = *result_of_long(progress, [&](const Progress& report) {
        return light_field_samples(made, axes, threads, report);
    });
    const int channels = samples.channels;
    return py::make_tuple(
        py::none(),
        array_of(std::move(samples), {axes.v(), axes.u(), axes.t(), axes.s(), channels}), arrays);
}

/// [v, u, t, s] of bool.
py::array light_field_imaged(const py::object& document, const Directions& directions, int threads)
{
    const FrameMetadata metadata = frame_metadata_from_json(text_of(document));
    const LightFieldAxes axes(metadata, grid_of(directions, metadata));
    auto mask = result_of_long(
        py::none(), [&](const Progress&) { return light_field_mask(metadata, axes, threads); });
    return array_of(std::move(mask), {axes.v(), axes.u(), axes.t(), axes.s()}).view("bool");
}

/// [row, column, y, x, channel]. `size`: of views of eyes; nothing: 500 pixels on the longer side.
py::array views(const py::object& of_python, const Directions& grid, bool of_eyes,
                std::optional<std::array<int, 2>> size, int threads, const py::object& progress)
{
    const Frame frame = frame_with_geometry(of_python);
    const FrameMetadata& metadata = *frame.metadata;
    const ViewGrid directions = directions_of(grid_of(grid, metadata), metadata.sheet);
    View view;
    constexpr int default_longer_side = 500;
    set_view_size(view, metadata.film, default_longer_side);
    if (size && ((*size)[0] < 1 || (*size)[1] < 1))
        throw std::invalid_argument("the size must be 1 pixel or more each way");
    if (size)
        view.width = (*size)[0], view.height = (*size)[1];
    const auto pictures = result_of_long(progress, [&](const Progress& report) {
        return of_eyes ? std::optional(views_of_eyes(frame, directions, view, threads, report))
                       : parallel_views(frame, directions, threads, report);
    });
    return array_of(*pictures, {directions.rows, directions.columns});
}

/// The image of the frame with this geometry that shows the views [row, column, y, x, channel].
py::array frame_from_views(const py::array& array, const py::object& document,
                           const py::object& encoding, bool of_eyes, int threads,
                           const py::object& progress)
{
    const FrameMetadata geometry = frame_metadata_from_json(text_of(document));
    if (geometry.film.width == 0)
        throw std::invalid_argument("the film has no width and height; give the frame's pixels");
    if (array.ndim() != 5)
        throw std::invalid_argument("views: an array [row, column, y, x, channel] is expected");
    const std::vector<Image> pictures = images_from(array, encoding_from(encoding));
    const ViewGrid grid = directions_of({int(array.shape(1)), int(array.shape(0))}, geometry.sheet);
    return array_of(*result_of_long(progress, [&](const Progress& report) {
        if (!of_eyes)
            return frame_from_parallel_views(pictures, geometry, grid, threads, report);
        const double distance = geometry.aperture.distance;
        return frame_from_eye_views(pictures, geometry, grid,
                                    {viewing_zone(geometry, distance), distance}, threads, report);
    }));
}

} // namespace

void declare_views(py::module_& module)
{
    module.def("views", views);
    module.def("frame_from_views", frame_from_views);
    module.def("light_field", light_field);
    module.def("light_field_imaged", light_field_imaged);
}

} // namespace integral
