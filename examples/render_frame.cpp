// SPDX-License-Identifier: AGPL-3.0-or-later
// A renderer of one's own that makes a micro-image frame: a checkered wall and a ball before it,
// traced along the rays of a lens sheet.
//
//     g++ -std=c++17 -O2 render_frame.cpp $(pkg-config --cflags --libs libintegral) -o render_frame
//     ./render_frame frame.png
#include "integral/base/parallel.h"
#include "integral/io/image_file.h"
#include "integral/optics/camera.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <exception>

using namespace integral;

// The scene, in mm: x to the right, y up, z away from the viewer; the sheet is at z = 0.
const Vec3 ball_centre{0, 0, 2};
constexpr double ball_radius = 6, wall = 12;

// The linear colour that a line of sight meets.
static Colour trace(const SightLine& line)
{
    const Vec3 from_centre = line.origin - ball_centre;
    const double b = dot(from_centre, line.direction);
    const double root = b * b - dot(from_centre, from_centre) + ball_radius * ball_radius;
    if (root >= 0) {
        const Vec3 hit = line.origin + (-b - std::sqrt(root)) * line.direction;
        const Vec3 normal = (1 / ball_radius) * (hit - ball_centre);
        const float light = float(std::max(0.1, 0.6 * dot(normal, {-0.5, 0.5, -0.7})));
        const bool stripe = std::fmod(hit.x + 100, 2) < 1;
        return {light, stripe ? 0.8f * light : 0.3f * light, 0.2f * light, 1};
    }
    const Vec3 hit = line.origin + ((wall - line.origin.z) / line.direction.z) * line.direction;
    const bool bright = (int(std::floor(hit.x / 3)) + int(std::floor(hit.y / 3))) % 2 == 0;
    return bright ? Colour{0.7f, 0.8f, 1, 1} : Colour{0.2f, 0.3f, 0.5f, 1};
}

// A sheet of 30 lenses an inch before a film of 720 x 480 pixels at 300 dpi, seen from 300 mm.
static IntegralCamera camera_of_example()
{
    CameraParameters parameters;
    parameters.sheet.arrangement = Arrangement::lenticular;
    parameters.sheet.pitch = 25.4 / 30;
    parameters.sheet.thickness = 2;
    parameters.sheet.ior = 1.56;
    parameters.film.pixel_pitch = {25.4 / 300, 25.4 / 300};
    parameters.film.units_per_mm = 1; // the scene is in mm
    ViewFrame view;
    view.location = {0, 0, -300};
    view.direction = {0, 0, 300}; // to the sheet's centre
    view.right = {1.5, 0, 0};
    view.up = {0, 1, 0};
    return make_camera(parameters, view, 720, 480);
}

int main(int count, char** words)
try {
    if (count != 2)
        throw std::invalid_argument("usage: render_frame FRAME.png");
    const IntegralCamera camera = camera_of_example();
    const Film& film = camera.film;
    Frame frame;
    frame.image = make_image<std::uint8_t>(film.width, film.height, 3, Encoding{});
    for_each_row(film.height, 0, [&](int y) {
        for (int x = 0; x < film.width; ++x) {
            // Pixel -> point on the film -> its lens and ray -> the line of sight in the scene.
            const Vec2 point = film_from_pixel(film, {x + 0.5, y + 0.5});
            const MappedPoint mapped = camera.optics.map(point, camera.mapping);
            if (mapped.ray) // else no lens shows this pixel to a viewer: it stays black
                store_linear(frame.image, x, y, trace(sight_line(camera, pole_beam(*mapped.ray))));
        }
    });
    // The geometry goes into the file, so that integral and read_frame know the sheet.
    FrameMetadata geometry;
    geometry.sheet = camera.optics.sheet();
    geometry.film = film;
    geometry.aperture = camera.optics.aperture();
    geometry.placement = camera.placement;
    set_metadata(frame, geometry);
    write_frame(words[1], frame);
} catch (const std::exception& error) {
    std::fprintf(stderr, "render_frame: %s\n", error.what());
    return 1;
}
