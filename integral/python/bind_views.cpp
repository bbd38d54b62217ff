// SPDX-License-Identifier: AGPL-3.0-or-later
// Light fields and views of frames, and frames of views, for Python.
#include "integral/base/interrupt.h"
#include "integral/frame/quilt_name.h"
#include "integral/frame/view_eyes.h"
#include "integral/io/image_file.h"
#include "integral/python/arrays.h"
#include "integral/python/calls.h"
#include "integral/python/rooms.h"
#include "integral/replay/arrange.h"
#include "integral/views/light_field.h"
#include "integral/views/parallel_views.h"
#include "integral/views/perspective_views.h"
#include "integral/views/quilt.h"
#include "integral/views/view_export.h"
#include "integral/views/view_input.h"

#include <pybind11/stl.h>

#include <limits>

namespace integral {
namespace {

using Directions = std::optional<std::pair<int, int>>;

/// The grid of `directions`, at most `most` one way; without it the film's own grid
/// (natural_views).
ViewGrid grid_of(const Directions& directions, const FrameMetadata& metadata, int most)
{
    if (!directions)
        return natural_views(metadata);
    check_grid("number of directions", *directions, most);
    return {directions->first, directions->second};
}

constexpr int most_directions = 4096; // one way

/// The numbers along the axes of a light field, mm. A direction without light is NaN.
struct AxesInMm {
    std::vector<double> u, v, s, t;
    std::vector<double> aperture, poles; ///< [v, u, 2] and [t, s, 2]
};

AxesInMm axes_of(const LightFieldAxes& axes, double distance, const Progress& progress)
{
    constexpr double none = std::numeric_limits<double>::quiet_NaN();
    AxesInMm mm;
    mm.aperture.reserve(2 * std::size_t(axes.u()) * axes.v());
    mm.poles.reserve(2 * std::size_t(axes.s()) * axes.t());
    const int rows = axes.v() + axes.t();
    const auto report = [&](int row) {
        if (progress && !progress(row, rows))
            throw Interrupted();
    };
    const auto direction = [&](int j, int i) {
        return axes.aperture_point(j, i, distance).value_or(Vec2{none, none});
    };
    for (int j = 0; j < axes.v(); ++j) {
        report(j);
        for (int i = 0; i < axes.u(); ++i) {
            const Vec2 at = direction(j, i);
            mm.aperture.insert(mm.aperture.end(), {at.x, at.y});
        }
    }
    for (int j = 0; j < axes.t(); ++j) {
        report(axes.v() + j);
        for (int i = 0; i < axes.s(); ++i) {
            const Vec2 at = axes.pole(j, i);
            mm.poles.insert(mm.poles.end(), {at.x, at.y});
        }
    }
    for (int i = 0; i < axes.u(); ++i)
        mm.u.push_back(axes.along_rows(direction(axes.v() / 2, i)));
    for (int j = 0; j < axes.v(); ++j)
        mm.v.push_back(axes.across_rows(direction(j, axes.u() / 2)));
    for (int i = 0; i < axes.s(); ++i)
        mm.s.push_back(axes.along_rows(axes.pole(axes.t() / 2, i)));
    for (int j = 0; j < axes.t(); ++j)
        mm.t.push_back(axes.across_rows(axes.pole(j, axes.s() / 2)));
    return mm;
}

/// (u_mm, v_mm, s_mm, t_mm, aperture_mm, poles_mm) as arrays.
py::tuple arrays_of(AxesInMm mm, const LightFieldAxes& axes)
{
    return py::make_tuple(
        array_of(std::move(mm.u), {axes.u()}), array_of(std::move(mm.v), {axes.v()}),
        array_of(std::move(mm.s), {axes.s()}), array_of(std::move(mm.t), {axes.t()}),
        array_of(std::move(mm.aperture), {axes.v(), axes.u(), 2}),
        array_of(std::move(mm.poles), {axes.t(), axes.s(), 2}));
}

/// (place, samples, axes): `place` is (first column, first row, v, u, t, s) of an exact light
/// field, whose samples are a view of the frame's own array and None here; else None, and the
/// samples are [v, u, t, s, channel].
py::tuple light_field(const py::object& frame, const Directions& directions, int threads,
                      const py::object& progress)
{
    check_threads(threads);
    const FrameMetadata metadata = geometry_from(frame);
    const LightFieldAxes axes(metadata, grid_of(directions, metadata, most_directions));
    const py::tuple arrays = arrays_of(
        result_of_long(py::none(),
                       [&](const Progress& report) {
                           return axes_of(axes, metadata.aperture.distance, report);
                       }),
        axes);
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
    const LightFieldAxes axes(metadata, grid_of(directions, metadata, most_directions));
    auto mask = result_of_long(
        py::none(), [&](const Progress&) { return light_field_mask(metadata, axes, threads); });
    return array_of(std::move(mask), {axes.v(), axes.u(), axes.t(), axes.s()}).view("bool");
}

/// [row, column, y, x, channel]. `size`: of views of eyes, pixels.
py::array views(const py::object& of_python, const Directions& grid, bool of_eyes,
                std::optional<std::array<int, 2>> size, int threads, const py::object& progress)
{
    check_threads(threads);
    check_picture_size(size, largest_picture_side);
    const Frame frame = frame_with_geometry(of_python);
    const FrameMetadata& metadata = *frame.metadata;
    const ViewGrid directions = directions_of(grid_of(grid, metadata, most_views_one_way),
                                              metadata.sheet);
    View view;
    set_view_size(view, metadata.film, default_longer_side_of_view);
    if (size)
        view.width = (*size)[0], view.height = (*size)[1];
    auto pictures = result_of_long(progress, [&](const Progress& report) {
        return of_eyes ? std::optional(views_of_eyes(frame, directions, view, threads, report))
                       : parallel_views(frame, directions, threads, report);
    });
    return array_of(std::move(*pictures), {directions.rows, directions.columns});
}

/// [row, column, 2]: places of a quilt's eyes, mm to the right of the sheet's axis and above it.
py::array eyes_of(const EyeGrid& eyes, ViewGrid directions)
{
    std::vector<double> places;
    for (int view = 0; view < directions.count(); ++view) {
        const Vec2 eye = eye_of_view(eyes, directions, view);
        places.insert(places.end(), {eye.x, eye.y});
    }
    return array_of(std::move(places), {directions.rows, directions.columns, 2});
}

/// The image of the frame with this geometry that shows the views [row, column, y, x, channel].
py::array frame_from_views(const py::array& array, const py::object& document,
                           const py::object& encoding, bool of_eyes, int threads,
                           const py::object& progress)
{
    check_threads(threads);
    const FrameMetadata geometry = frame_metadata_from_json(text_of(document));
    check_film_size(geometry);
    const ViewsOfArray of_array = views_from(array, encoding_from(encoding));
    const std::vector<Image>& pictures = of_array.pictures;
    const ViewGrid grid = directions_of(of_array.grid, geometry.sheet);
    return array_of(*result_of_long(progress, [&](const Progress& report) {
        if (!of_eyes)
            return frame_from_parallel_views(pictures, geometry, grid, threads, report);
        const double distance = geometry.aperture.distance;
        return frame_from_eye_views(pictures, geometry, grid,
                                    {viewing_zone(geometry, distance), distance}, threads, report);
    }));
}

/// (views [row, column, y, x, channel], encoding, premultiplied, metadata or None, aspect, eyes
/// [row, column, 2] or None) of a quilt, of a file with several views, or of the files of all
/// views.
py::tuple read_quilt(const std::vector<std::string>& paths, const Directions& grid,
                     std::optional<double> aspect)
{
    if (paths.empty())
        throw std::invalid_argument("paths: a file is expected");
    ViewsRequest request;
    if (grid) {
        check_grid("grid", *grid, most_views_one_way);
        request.grid = ViewGrid{grid->first, grid->second};
    }
    check_number("aspect", aspect.value_or(1), 0.01, 100);
    request.aspect = aspect;
    request.needs_geometry = false;
    request.of_eyes = true;
    ViewInput given = result_of_long(
        py::none(), [&](const Progress&) { return read_given_views(paths, request); });
    const ViewGrid directions = given.metadata ? directions_of(given.grid, given.metadata->sheet)
                                               : given.grid;
    const Image form = form_of(given.views.at(0));
    py::object metadata = py::none(), eyes = py::none();
    if (given.metadata) {
        given.metadata->quilt->view.reset(); // the files of all views are one quilt
        metadata = parsed(to_json(*given.metadata));
        if (given.metadata->quilt->eyes)
            eyes = eyes_of(*given.metadata->quilt->eyes, directions);
    }
    return py::make_tuple(array_of(std::move(given.views), {directions.rows, directions.columns}),
                          python_of(form.encoding), form.premultiplied, metadata, given.shape,
                          eyes);
}

/// Writes views [row, column, y, x, channel] as a quilt, and returns its path. `document`: None, or
/// the metadata of a quilt.
std::string write_quilt(const std::string& path, const py::array& array, const py::object& encoding,
                        bool premultiplied, const py::object& document, double aspect)
{
    check_number("aspect", aspect, 0.01, 100);
    ViewsOfArray views = views_from(array, encoding_from(encoding), premultiplied);
    std::optional<FrameMetadata> metadata;
    ViewGrid tiles = views.grid;
    if (!document.is_none()) {
        metadata = frame_metadata_from_json(text_of(document));
        if (metadata->quilt)
            tiles = metadata->quilt->grid;
        if (!metadata->quilt || tiles.count() != views.grid.count())
            throw std::invalid_argument("the metadata are not those of a quilt of " +
                                        std::to_string(views.grid.count()) + " views");
        metadata->encoding = views.pictures.at(0).encoding;
    }
    const std::string name = quilt_name(path, tiles, aspect);
    const auto stated = quilt_in_name(name);
    if (stated->grid.columns != tiles.columns || stated->grid.rows != tiles.rows)
        throw std::invalid_argument(path + ": its name states another number of views; leave the "
                                           "ending _qs... out");
    run_long(py::none(), [&](const Progress&) {
        write_frame(name, Frame{quilt_of_views(std::move(views.pictures), tiles), metadata});
    });
    return name;
}

} // namespace

void declare_views(py::module_& module)
{
    module.def("read_quilt", read_quilt);
    module.def("write_quilt", write_quilt);
    module.def("views", views);
    module.def("frame_from_views", frame_from_views);
    module.def("light_field", light_field);
    module.def("light_field_imaged", light_field_imaged);
}

} // namespace integral
