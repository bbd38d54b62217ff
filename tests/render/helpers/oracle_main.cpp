// SPDX-License-Identifier: AGPL-3.0-or-later
// oracle camera KEY=VALUE...             prints the camera in the scene language
// oracle mesh OUT KEY=VALUE...           OUT.inc: the same rays as a mesh_camera, one triangle a pixel, for an unmodified
//                                        POV-Ray; OUT.mask: a row of 0 (images nothing) and 1 a line of pixels
// oracle rays OUT KEY=VALUE...           OUT.csv: A, P and the direction of every imaged pixel in the scene, for SDL's
//                                        #read: "imaged, Ax, Ay, Az, Px, Py, Pz, dx, dy, dz,"; OUT.mask as above
//                                        left_of=X or right_of=X (mm on the aperture) leaves out the others: - in the mask
// oracle around OUT PIXELS KEY=VALUE...  for every "i j" line of the file PIXELS a row of film points about that pixel,
//                                        through the pixel's own lens, as a mesh_camera in OUT.inc: the pixel itself, then 8
//                                        points at each of the radii 0.02, 0.2 and 1 pixel
// oracle perspective KEY=VALUE...        prints POV-Ray's perspective camera of the same description
// oracle pinhole OUT KEY=VALUE...        its rays as a mesh_camera: proves placement, transforms and the mesh itself
// All but camera print the frame's figures: pixels imaged, and the least relative margin by which a tie or the
// aperture's edge was decided.
#include "oracle.h"

#include <cmath>
#include <fstream>
#include <iostream>
#include <stdexcept>

using namespace oracle;

namespace {

Point3 along(const Placed& p, Real x, Real y, Real z)
{
    Point3 v{};
    for (int i = 0; i < 3; i++) v[i] = p.x[i] * x + p.y[i] * y + p.z[i] * z;
    return v;
}

/// Writes triangles whose centroid is the ray's origin and whose normal is its direction. POV-Ray takes the normal from
/// the vertices in double and keeps both in single precision: so the vertices are written about the aperture's centre,
/// close together, and the whole mesh is moved there.
class MeshCamera {
public:
    MeshCamera(const std::string& file, const Placed& placed) : out_(file), placed_(placed)
    {
        out_.precision(17);
        out_ << "camera { mesh_camera { 1 0 mesh {\n";
    }
    void add(const SheetRay* ray)
    {
        const SheetRay nothing{{}, {0, 0}, {0, 0, 1}}; // any ray: these pixels are masked
        if (!ray) ray = &nothing;
        const Point3 centre = along(placed_, ray->aperture_point[0], ray->aperture_point[1], 0);
        Point3 direction = along(placed_, ray->direction[0], ray->direction[1], ray->direction[2]);
        const Real k = std::sqrt(direction[0] * direction[0] + direction[1] * direction[1] + direction[2] * direction[2]);
        for (Real& v : direction) v /= k;
        // Two unit vectors across the direction.
        const int least = std::fabs(direction[0]) < 0.6L ? 0 : 1;
        Point3 u{}, v;
        for (int i = 0; i < 3; i++) u[i] = (i == least) - direction[least] * direction[i];
        const Real norm = std::sqrt(u[0] * u[0] + u[1] * u[1] + u[2] * u[2]);
        for (Real& x : u) x /= norm;
        v = {direction[1] * u[2] - direction[2] * u[1], direction[2] * u[0] - direction[0] * u[2],
             direction[0] * u[1] - direction[1] * u[0]};
        const Real radius = k * (1 + std::hypot(ray->aperture_point[0], ray->aperture_point[1])) / 8;
        out_ << "triangle {";
        for (int corner = 0; corner < 3; corner++) {
            // Clockwise: POV-Ray's normal is (P3 - P1) x (P2 - P1).
            const Real turn = -2 * std::acos(-1.0L) * corner / 3, c = std::cos(turn) * radius, s = std::sin(turn) * radius;
            out_ << (corner ? ",<" : "<");
            for (int i = 0; i < 3; i++) out_ << (i ? "," : "") << double(centre[i] + u[i] * c + v[i] * s);
            out_ << ">";
        }
        out_ << "}\n";
    }
    ~MeshCamera()
    {
        out_ << "translate <" << placed_.location[0] << "," << placed_.location[1] << "," << placed_.location[2]
             << "> } } location 0 }\n";
    }
private:
    std::ofstream out_;
    Placed placed_;
};

void print_figures(long imaged, long pixels, Real margin, const Placed& placed)
{
    std::cout << imaged << " of " << pixels << " imaged; margin " << double(margin) << "; d " << double(placed.distance)
              << " mm\n";
}

void frame(const Description& d, const std::string& out, bool csv)
{
    const Placed placed = place(d);
    MeshCamera* const mesh = csv ? nullptr : new MeshCamera(out + ".inc", placed);
    std::ofstream mask(out + ".mask"), rays;
    if (csv) rays.open(out + ".csv"), rays.precision(17);
    Real margin = 1;
    long imaged = 0;
    // Rays that are left out are traced like the first that is not: no pixel starts elsewhere.
    std::optional<SheetRay> first;
    const auto left_out = [&](const SheetRay& ray) { return d.only * (ray.aperture_point[0] - d.only_from) < 0; };
    for (int n = 0; d.only && !first && n < d.width * d.height; n++) {
        first = film_ray(d, placed.distance, film_from_pixel(d, n % d.width + 0.5L, n / d.width + 0.5L), margin);
        if (first && left_out(*first)) first.reset();
    }
    for (int j = 0; j < d.height; j++, mask << '\n')
        for (int i = 0; i < d.width; i++) {
            const auto ray = film_ray(d, placed.distance, film_from_pixel(d, i + 0.5L, j + 0.5L), margin);
            const bool skipped = ray && left_out(*ray);
            mask << (skipped ? '-' : ray ? '1' : '0');
            imaged += ray.has_value();
            if (mesh) { mesh->add(ray && !skipped ? &*ray : first ? &*first : nullptr); continue; }
            if (!ray) { rays << "0,0,0,0,0,0,0,0,0,0,\n"; continue; }
            const Point3 a = along(placed, ray->aperture_point[0], ray->aperture_point[1], 0);
            const Point3 w = along(placed, ray->direction[0], ray->direction[1], ray->direction[2]);
            const Real to_sheet = placed.distance / ray->direction[2];
            rays << 1 << ',';
            for (int n = 0; n < 3; n++) rays << a[n] + placed.location[n] << ',';
            for (int n = 0; n < 3; n++) rays << a[n] + placed.location[n] + w[n] * to_sheet << ',';
            for (int n = 0; n < 3; n++) rays << w[n] << ',';
            rays << '\n';
        }
    delete mesh;
    print_figures(imaged, long(d.width) * d.height, margin, placed);
}

void around(const Description& d, const std::string& out, const std::string& pixels)
{
    const Placed placed = place(d);
    MeshCamera mesh(out + ".inc", placed);
    std::ifstream in(pixels);
    Real margin = 1;
    int i, j;
    while (in >> i >> j) {
        const auto own = film_ray(d, placed.distance, film_from_pixel(d, i + 0.5L, j + 0.5L), margin);
        mesh.add(own ? &*own : nullptr);
        for (const Real radius : {0.02L, 0.2L, 1.0L})
            for (int n = 0; n < 8; n++) {
                const Real turn = n * std::acos(-1.0L) / 4;
                const Point2 f = film_from_pixel(d, i + 0.5L + radius * std::cos(turn), j + 0.5L + radius * std::sin(turn));
                const auto ray = own ? ray_through(d, placed.distance, f, own->lens) : own;
                mesh.add(ray ? &*ray : own ? &*own : nullptr);
            }
    }
}

/// The rays of POV-Ray's perspective camera: from the location through the sheet's points that lie before the pixels.
void pinhole(const Description& d, const std::string& out)
{
    const Placed placed = place(d);
    MeshCamera mesh(out + ".inc", placed);
    for (int j = 0; j < d.height; j++)
        for (int i = 0; i < d.width; i++) {
            const Point2 f = film_from_pixel(d, i + 0.5L, j + 0.5L);
            const Real length = std::sqrt(f[0] * f[0] + f[1] * f[1] + placed.distance * placed.distance);
            const SheetRay ray{{}, {0, 0}, {f[0] / length, f[1] / length, placed.distance / length}};
            mesh.add(&ray);
        }
}

int run(std::vector<std::string> words)
{
    const auto next = [&] {
        if (words.empty()) throw std::invalid_argument("usage: the head of oracle_main.cpp says it");
        const std::string word = words.front();
        words.erase(words.begin());
        return word;
    };
    const std::string command = next();
    if (command == "camera") { std::cout << camera_text(read_description(words)); return 0; }
    if (command == "perspective") { std::cout << perspective_text(read_description(words)); return 0; }
    const std::string out = next();
    if (command == "around") {
        const std::string pixels = next();
        around(read_description(words), out, pixels);
        return 0;
    }
    if (command == "pinhole") { pinhole(read_description(words), out); return 0; }
    if (command != "mesh" && command != "rays") throw std::invalid_argument("unknown command: " + command);
    frame(read_description(words), out, command == "rays");
    return 0;
}

} // namespace

int main(int argc, char** argv)
{
    try {
        return run({argv + 1, argv + argc});
    } catch (const std::exception& error) {
        std::cerr << "oracle: " << error.what() << '\n';
        return 2;
    }
}
