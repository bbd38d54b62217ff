// SPDX-License-Identifier: AGPL-3.0-or-later
// Rays of pixels and back, many at once, for Python.
#include "integral/frame/recorded_camera.h"
#include "integral/optics/film_in_sight.h"
#include "integral/python/arrays.h"
#include "integral/python/calls.h"
#include "integral/python/rooms.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace integral {
namespace {

constexpr double none = std::numeric_limits<double>::quiet_NaN();

Vec2 vec2_at(const double* row) { return {row[0], row[1]}; }
Vec3 vec3_at(const double* row) { return {row[0], row[1], row[2]}; }
void put(double* row, Vec2 v) { row[0] = v.x, row[1] = v.y; }
void put(double* row, Vec3 v) { row[0] = v.x, row[1] = v.y, row[2] = v.z; }
void put(std::int64_t* row, LensIndex lens) { row[0] = lens.i, row[1] = lens.j; }

/// Calls work(k) for k from 0 to n - 1; many from several threads, without Python's lock, and so
/// that Ctrl-C ends them.
template <class Work> void for_each_of(py::ssize_t n, int threads, Work work)
{
    constexpr py::ssize_t block = 4096;
    check_threads(threads);
    const auto do_block = [&](int row) {
        for (py::ssize_t k = row * block; k < std::min(n, (row + 1) * block); ++k)
            work(k);
    };
    if (n <= block)
        return do_block(0);
    run_long(py::none(), [&](const Progress& progress) {
        for_each_row(int((n + block - 1) / block), threads, do_block, progress);
    });
}

/// (imaged, origins, directions, lenses) of n places on the film.
py::tuple rays(const IntegralCamera& camera, const py::object& pixels, int threads)
{
    const auto from = rows_from<double>(pixels, 2, "pixels");
    const py::ssize_t n = from.shape(0);
    py::array_t<bool> imaged(n);
    py::array_t<double> origins({n, py::ssize_t(3)}), directions({n, py::ssize_t(3)});
    py::array_t<std::int64_t> lenses({n, py::ssize_t(2)});
    const double* const pixel = from.data();
    bool* const is_imaged = imaged.mutable_data();
    double *const origin = origins.mutable_data(), *const direction = directions.mutable_data();
    std::int64_t* const lens = lenses.mutable_data();
    for_each_of(n, threads, [&](py::ssize_t k) {
        const Vec2 point = film_from_pixel(camera.film, vec2_at(pixel + 2 * k));
        const auto ray = camera.optics.map(point, camera.mapping).ray;
        const SightLine line = ray ? sight_line(camera, pole_beam(*ray))
                                   : SightLine{{none, none, none}, {none, none, none}};
        is_imaged[k] = ray.has_value();
        put(origin + 3 * k, line.origin);
        put(direction + 3 * k, line.direction);
        put(lens + 2 * k, ray ? ray->lens : LensIndex());
    });
    return py::make_tuple(imaged, origins, directions, lenses);
}

/// (pixels, lenses) of n lines.
py::tuple pixels_seen(const IntegralCamera& camera, const py::object& points,
                      const py::object& directions, int threads)
{
    const auto from = rows_from<double>(points, 3, "origins"),
               along = rows_from<double>(directions, 3, "directions");
    const py::ssize_t n = from.shape(0);
    if (along.shape(0) != n)
        throw std::invalid_argument("origins and directions differ in number");
    py::array_t<double> pixels({n, py::ssize_t(2)});
    py::array_t<std::int64_t> lenses({n, py::ssize_t(2)});
    const double *const origin = from.data(), *const direction = along.data();
    double* const pixel = pixels.mutable_data();
    std::int64_t* const lens = lenses.mutable_data();
    for_each_of(n, threads, [&](py::ssize_t k) {
        const auto seen = film_in_sight(camera, vec3_at(origin + 3 * k),
                                        vec3_at(direction + 3 * k));
        put(pixel + 2 * k,
            seen ? pixel_from_film(camera.film, seen->film_point) : Vec2{none, none});
        put(lens + 2 * k, seen ? seen->lens : LensIndex());
    });
    return py::make_tuple(pixels, lenses);
}

/// Places on the film at which n lenses image n points.
py::array pixels_imaging(const IntegralCamera& camera, const py::object& points,
                         const py::object& lenses, int threads)
{
    const auto from = rows_from<double>(points, 3, "points");
    const auto through = rows_from<std::int64_t>(lenses, 2, "lenses");
    const py::ssize_t n = from.shape(0);
    if (through.shape(0) != n)
        throw std::invalid_argument("points and lenses differ in number");
    py::array_t<double> pixels({n, py::ssize_t(2)});
    const double* const point = from.data();
    const std::int64_t* const lens = through.data();
    double* const pixel = pixels.mutable_data();
    for_each_of(n, threads, [&](py::ssize_t k) {
        const Vec3 seen = seen_from_scene(camera, vec3_at(point + 3 * k));
        std::optional<Vec2> film;
        if (std::isfinite(seen.z))
            film = film_point_imaging(camera.optics, seen, {lens[2 * k], lens[2 * k + 1]});
        put(pixel + 2 * k, film ? pixel_from_film(camera.film, *film) : Vec2{none, none});
    });
    return pixels;
}

/// The poles of n lenses, mm.
py::array poles(const IntegralCamera& camera, const py::object& lenses, int threads)
{
    const auto from = rows_from<std::int64_t>(lenses, 2, "lenses");
    const py::ssize_t n = from.shape(0);
    py::array_t<double> points({n, py::ssize_t(2)});
    const std::int64_t* const lens = from.data();
    double* const point = points.mutable_data();
    for_each_of(n, threads, [&](py::ssize_t k) {
        put(point + 2 * k, camera.optics.lattice().pole({lens[2 * k], lens[2 * k + 1]}));
    });
    return points;
}

} // namespace

void declare_optics(py::module_& module)
{
    py::class_<IntegralCamera>(module, "Camera")
        .def(py::init([](const py::object& document, bool in_scene) {
            const FrameMetadata geometry = frame_metadata_from_json(text_of(document));
            check_film_size(geometry);
            return recorded_camera(geometry, in_scene ? CameraSpace::scene : CameraSpace::sheet);
        }))
        .def("rays", rays)
        .def("pixels_seen", pixels_seen)
        .def("pixels_imaging", pixels_imaging)
        .def("poles", poles);
}

} // namespace integral
