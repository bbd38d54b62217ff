// SPDX-License-Identifier: AGPL-3.0-or-later
// oracle camera KEY=VALUE...      prints the camera in the scene language
// oracle mesh OUT KEY=VALUE...    writes OUT.inc, a mesh_camera for an unmodified POV-Ray with the
//                                 same rays, one triangle a pixel; and OUT.mask, for each row of
//                                 pixels a line of 0 (images nothing) and 1
// oracle rays OUT KEY=VALUE...    writes OUT.csv for the scene language's #read: A, P and the
//                                 direction of every imaged pixel in the scene, as
//                                 "imaged, Ax, Ay, Az, Px, Py, Pz, dx, dy, dz,"; and OUT.mask as
//                                 above. groups=FILE group=N leaves out the pixels that have
//                                 another number in FILE; the mask has - for them
// oracle samples OUT COUNT SEED KEY=VALUE...
//                                 writes OUT.inc with COUNT rays a pixel, evenly spread over what
//                                 the keys sample; and OUT.mask
// oracle weights KEY=VALUE...     prints the weights of the hybrid model's rays
// oracle around OUT PIXELS KEY=VALUE...
//                                 writes OUT.inc, a mesh_camera with a row of rays for every "i j"
//                                 line of the file PIXELS: the pixel's own ray; 8 rays moved by no
//                                 more than the rounding to single precision, in which a mesh keeps
//                                 them; then the rays of 8 film points through the pixel's own lens
//                                 at each of the radii 0.02, 0.2 and 1 pixel
// oracle mirrored KEY=VALUE...    prints for every pixel the "i j" of the pixel at the place
//                                 mirrored in its lens, if that belongs to the same lens and lies
//                                 on the film, else "-1 -1"
// oracle perspective KEY=VALUE... prints POV-Ray's perspective camera of the same description
// oracle pinhole OUT KEY=VALUE... writes the perspective camera's rays as a mesh_camera, which
//                                 tests placement, transforms and the mesh itself
// All but camera print the frame's figures: the number of pixels imaged, and the least relative
// margin by which a tie or the aperture's edge was decided.
#include "oracle.h"

#include <cmath>
#include <fstream>
#include <iostream>
#include <random>
#include <stdexcept>

using namespace oracle;

namespace {

Point3 along(const Placed& p, Real x, Real y, Real z)
{
    Point3 v{};
    for (int i = 0; i < 3; i++)
        v[i] = p.x[i] * x + p.y[i] * y + p.z[i] * z;
    return v;
}

/// Writes triangles whose centroid is the ray's origin and whose normal is its direction. POV-Ray
/// computes the normal from the vertices in double precision, and stores both in single precision.
/// To lose little, vertices are written relative to the aperture's centre, close together, and the
/// whole mesh is then translated.
class MeshCamera {
public:
    MeshCamera(const std::string& file, const Description& d, const Placed& placed,
               int rays_per_pixel = 1)
        : out_(file),
          placed_(placed),
          ahead_(d.pseudoscopic ? placed.distance
                 : d.start      ? placed.distance - *d.start
                                : 0)
    {
        out_.precision(17);
        out_ << "camera { mesh_camera { " << rays_per_pixel << " 0\n";
        begin();
    }
    void add(const SheetRay* ray)
    {
        const SheetRay nothing{{}, {0, 0}, {0, 0, 1}}; // any ray, as the mask leaves the pixel out
        const SheetRay in_the_scene = in_scene(placed_, ray ? *ray : nothing);
        ray = &in_the_scene;
        Point3 start{ray->aperture_point[0], ray->aperture_point[1], 0}; // from the aperture's
                                                                         // centre
        for (int i = 0; i < 3; i++)
            start[i] += ray->direction[i] * (ahead_ / ray->direction[2]);
        const Point3 centre = along(placed_, start[0], start[1], start[2]);
        Point3 direction = along(placed_, ray->direction[0], ray->direction[1], ray->direction[2]);
        const Real k = std::sqrt(direction[0] * direction[0] + direction[1] * direction[1] +
                                 direction[2] * direction[2]);
        for (Real& v : direction)
            v /= k;
        // Two unit vectors across the direction.
        const int least = std::fabs(direction[0]) < 0.6L ? 0 : 1;
        Point3 u{}, v;
        for (int i = 0; i < 3; i++)
            u[i] = (i == least) - direction[least] * direction[i];
        const Real norm = std::sqrt(u[0] * u[0] + u[1] * u[1] + u[2] * u[2]);
        for (Real& x : u)
            x /= norm;
        v = {direction[1] * u[2] - direction[2] * u[1], direction[2] * u[0] - direction[0] * u[2],
             direction[0] * u[1] - direction[1] * u[0]};
        const Real radius = k * (1 + std::hypot(start[0], start[1])) / 8;
        out_ << "triangle {";
        for (int corner = 0; corner < 3; corner++) {
            // Clockwise: POV-Ray's normal is (P3 - P1) x (P2 - P1).
            const Real turn = -2 * std::acos(-1.0L) * corner / 3, c = std::cos(turn) * radius,
                       s = std::sin(turn) * radius;
            out_ << (corner ? ",<" : "<");
            for (int i = 0; i < 3; i++)
                out_ << (i ? "," : "") << double(centre[i] + u[i] * c + v[i] * s);
            out_ << ">";
        }
        out_ << "}\n";
    }
    /// Begins the next ray of every pixel.
    void next_ray()
    {
        end();
        begin();
    }
    ~MeshCamera()
    {
        end();
        out_ << "} location 0 }\n";
    }

private:
    void begin() { out_ << "mesh {\n"; }
    void end()
    {
        out_ << "translate <" << placed_.location[0] << "," << placed_.location[1] << ","
             << placed_.location[2] << "> }\n";
    }
    std::ofstream out_;
    Placed placed_;
    Real ahead_; ///< mm along the axis from the aperture to where the rays start
};

void print_figures(long imaged, long pixels, Real margin, const Placed& placed)
{
    std::cout << imaged << " of " << pixels << " imaged; margin " << double(margin) << "; d "
              << double(placed.distance) << " mm\n";
}

/// The ray of a pixel; for the hybrid model, the ray that the description chooses.
std::optional<SheetRay> pixel_ray(const Description& d, const Placed& placed, int i, int j,
                                  Real& margin)
{
    const Point2 f = film_from_pixel(d, i + 0.5L, j + 0.5L);
    const auto own = film_ray(d, placed.distance, f, margin);
    const LensPoint point = d.model == "hybrid" ? hybrid_points(d).at(d.marginal) : LensPoint{};
    return own ? beam_ray(d, placed.distance, f, own->lens, point) : own;
}

void frame(const Description& d, const std::string& out, bool csv)
{
    const Placed placed = place(d);
    MeshCamera* const mesh = csv ? nullptr : new MeshCamera(out + ".inc", d, placed);
    std::ofstream mask(out + ".mask"), rays;
    if (csv)
        rays.open(out + ".csv"), rays.precision(17);
    Real margin = 1;
    long imaged = 0;
    std::vector<int> groups;
    std::ifstream groups_file(d.groups);
    for (int group; groups_file >> group;)
        groups.push_back(group);
    if (!d.groups.empty() && long(groups.size()) != long(d.width) * d.height)
        throw std::invalid_argument(d.groups + ": not a number a pixel");
    const auto left_out = [&](int i, int j) {
        return !groups.empty() && groups[std::size_t(j) * d.width + i] != d.group;
    };
    // A ray that is left out gets the start of the first other ray, so that all rays start
    // together.
    std::optional<SheetRay> first;
    for (int n = 0; !groups.empty() && !first && n < d.width * d.height; n++)
        if (!left_out(n % d.width, n / d.width))
            first = pixel_ray(d, placed, n % d.width, n / d.width, margin);
    for (int j = 0; j < d.height; j++, mask << '\n')
        for (int i = 0; i < d.width; i++) {
            const auto ray = pixel_ray(d, placed, i, j, margin);
            const bool skipped = ray && left_out(i, j);
            mask << (skipped ? '-' : ray ? '1' : '0');
            imaged += ray.has_value();
            if (mesh) {
                mesh->add(ray && !skipped ? &*ray : first ? &*first : nullptr);
                continue;
            }
            if (!ray) {
                rays << "0,0,0,0,0,0,0,0,0,0,\n";
                continue;
            }
            const SheetRay sight = in_scene(placed, *ray);
            const Point3 a = along(placed, sight.aperture_point[0], sight.aperture_point[1], 0);
            const Point3 w = along(placed, sight.direction[0], sight.direction[1],
                                   sight.direction[2]);
            const Real to_sheet = placed.scene_distance / sight.direction[2];
            rays << 1 << ',';
            for (int n = 0; n < 3; n++)
                rays << a[n] + placed.location[n] << ',';
            for (int n = 0; n < 3; n++)
                rays << a[n] + placed.location[n] + w[n] * to_sheet << ',';
            for (int n = 0; n < 3; n++)
                rays << w[n] << ',';
            rays << '\n';
        }
    delete mesh;
    print_figures(imaged, long(d.width) * d.height, margin, placed);
}

/// Halton's sequence with one random shift for all points.
class Halton {
public:
    explicit Halton(std::mt19937_64& random)
    {
        for (Real& shift : shift_)
            shift = std::uniform_real_distribution<double>()(random);
    }
    Numbers operator()()
    {
        Numbers x;
        index_++;
        const int bases[] = {2, 3, 5, 7};
        for (int n = 0; n < 4; n++) {
            x[n] = shift_[n];
            Real part = 1;
            for (long left = index_; left > 0; left /= bases[n])
                part /= bases[n], x[n] += part * (left % bases[n]);
            x[n] -= std::floor(x[n]);
        }
        return x;
    }

private:
    Numbers shift_;
    long index_ = 0;
};

void samples(const Description& d, const std::string& out, int count, unsigned seed)
{
    const Placed placed = place(d);
    std::ofstream mask(out + ".mask");
    std::vector<std::vector<SheetRay>> pixels;
    std::mt19937_64 random(seed);
    for (int j = 0; j < d.height; j++, mask << '\n')
        for (int i = 0; i < d.width; i++) {
            pixels.push_back(pixel_rays(d, placed.distance, i, j, count, Halton(random)));
            mask << (pixels.back().empty() ? '0' : '1');
        }
    MeshCamera mesh(out + ".inc", d, placed, count);
    for (int n = 0; n < count; n++) {
        if (n > 0)
            mesh.next_ray();
        for (const auto& rays : pixels)
            mesh.add(rays.empty() ? nullptr : &rays[n % rays.size()]);
    }
}

void around(const Description& d, const std::string& out, const std::string& pixels)
{
    const Placed placed = place(d);
    MeshCamera mesh(out + ".inc", d, placed);
    std::ifstream in(pixels);
    Real margin = 1;
    int i, j;
    while (in >> i >> j) {
        const auto own = pixel_ray(d, placed, i, j, margin);
        mesh.add(own ? &*own : nullptr);
        const Real single = 1.2e-7L;
        for (int n = 0; n < 8; n++) {
            const Real turn = n * std::acos(-1.0L) / 4, step = n % 2 ? 4 * single : single;
            SheetRay ray = own ? *own : SheetRay{{}, {0, 0}, {0, 0, 1}};
            for (int k = 0; k < 2; k++) {
                const Real component = k ? std::sin(turn) : std::cos(turn);
                ray.aperture_point[k] += component * step * placed.distance;
                ray.direction[k] += component * step * (n / 2 % 2 ? 1 : -1);
            }
            mesh.add(&ray);
        }
        for (const Real radius : {0.02L, 0.2L, 1.0L})
            for (int n = 0; n < 8; n++) {
                const Real turn = n * std::acos(-1.0L) / 4;
                const Point2 f = film_from_pixel(d, i + 0.5L + radius * std::cos(turn),
                                                 j + 0.5L + radius * std::sin(turn));
                const LensPoint point = d.model == "hybrid" ? hybrid_points(d).at(d.marginal)
                                                            : LensPoint{};
                const auto ray = own ? beam_ray(d, placed.distance, f, own->lens, point) : own;
                mesh.add(ray ? &*ray : own ? &*own : nullptr);
            }
    }
}

void mirrored(const Description& d)
{
    const Placed placed = place(d);
    Real margin = 1;
    const Point2 corner = film_from_pixel(d, 0, 0), one = film_from_pixel(d, 1, 1);
    for (int n = 0; n < d.width * d.height; n++) {
        const Point2 f = film_from_pixel(d, n % d.width + 0.5L, n / d.width + 0.5L);
        const auto ray = film_ray(d, placed.distance, f, margin);
        int i = -1, j = -1;
        if (ray) {
            const Point2 m = mirrored_in_lens(d, f, ray->lens);
            i = int(std::floor((m[0] - corner[0]) / (one[0] - corner[0]) + 1e-9L));
            j = int(std::floor((m[1] - corner[1]) / (one[1] - corner[1]) + 1e-9L));
            const auto there = film_ray(d, placed.distance, film_from_pixel(d, i + 0.5L, j + 0.5L),
                                        margin);
            if (i < 0 || i >= d.width || j < 0 || j >= d.height || !there ||
                there->lens.first != ray->lens.first || there->lens.second != ray->lens.second)
                i = j = -1;
        }
        std::cout << i << ' ' << j << '\n';
    }
}

/// The rays of POV-Ray's perspective camera: from the location through the point of the sheet in
/// front of each pixel.
void pinhole(const Description& d, const std::string& out)
{
    const Placed placed = place(d);
    MeshCamera mesh(out + ".inc", d, placed);
    for (int j = 0; j < d.height; j++)
        for (int i = 0; i < d.width; i++) {
            const Point2 f = film_from_pixel(d, i + 0.5L, j + 0.5L);
            const Real length = std::sqrt(f[0] * f[0] + f[1] * f[1] +
                                          placed.distance * placed.distance);
            const SheetRay ray{
                {}, {0, 0}, {f[0] / length, f[1] / length, placed.distance / length}};
            mesh.add(&ray);
        }
}

int run(std::vector<std::string> words)
{
    const auto next = [&] {
        if (words.empty())
            throw std::invalid_argument("usage: the head of oracle_main.cpp says it");
        const std::string word = words.front();
        words.erase(words.begin());
        return word;
    };
    const std::string command = next();
    if (command == "camera") {
        std::cout << camera_text(read_description(words));
        return 0;
    }
    if (command == "perspective") {
        std::cout << perspective_text(read_description(words));
        return 0;
    }
    if (command == "weights") {
        for (const Real weight : hybrid_weights(read_description(words)))
            std::cout << double(weight) << '\n';
        return 0;
    }
    if (command == "mirrored") {
        mirrored(read_description(words));
        return 0;
    }
    const std::string out = next();
    if (command == "samples") {
        const int count = std::stoi(next()), seed = std::stoi(next());
        samples(read_description(words), out, count, seed);
        return 0;
    }
    if (command == "around") {
        const std::string pixels = next();
        around(read_description(words), out, pixels);
        return 0;
    }
    if (command == "pinhole") {
        pinhole(read_description(words), out);
        return 0;
    }
    if (command != "mesh" && command != "rays")
        throw std::invalid_argument("unknown command: " + command);
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
