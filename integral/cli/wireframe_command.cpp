// SPDX-License-Identifier: AGPL-3.0-or-later
// integral wireframe: draws a mesh as a micro-image frame, by geometric projection.
#include "integral/cli/choices.h"
#include "integral/cli/command.h"
#include "integral/cli/geometry_options.h"
#include "integral/cli/progress.h"
#include "integral/cli/thread_options.h"
#include "integral/cli/values.h"
#include "integral/frame/names.h"
#include "integral/io/image_file.h"
#include "integral/wireframe/mesh_file.h"
#include "integral/wireframe/point_squares.h"
#include "integral/wireframe/wireframe.h"
#include "integral/wireframe/wireframe_report.h"

#include <chrono>
#include <cstdlib>
#include <iostream>

#ifndef PACKAGE_VERSION
#error "PACKAGE_VERSION must be defined, as configure does"
#endif

namespace integral {
namespace {

constexpr const char* default_print = "152.4x101.6"; // mm: 6 x 4 inches
constexpr int most_samples = 4096;

struct WireframeOptions : CommonOptions {
    SheetOptions sheet;
    FilmOptions film;
    ApertureOptions aperture;
    std::optional<std::string> start, print, model, mapping, faces, colour, background, light, fit,
        scale, turn, move, parallax, point_size, output;
    std::optional<int> samples, bits;
    bool in_scene = false, plain = false, pseudoscopic = false, json = false;
    ThreadOptions threads;
};

void declare_mesh(options::options_description& all, WireframeOptions& o)
{
    add(all, "fit", o.fit, "MM",
        "put the mesh's middle into the sheet's centre and make its largest extent so long, "
        "whatever its unit");
    add(all, "scale", o.scale, "K[,K,K]",
        "mm for a unit of the file, or one for each axis; negative mirrors (1,1,-1 for files whose "
        "z comes towards the viewer; default 1)");
    add(all, "turn", o.turn, "X,Y,Z", "degrees about x, then y, then z, as POV-Ray's rotate");
    add(all, "move", o.move, "X,Y,Z",
        "mm to the right, up and into the sheet; negative Z comes out of it");
    add(all, "in-scene", o.in_scene,
        "the mesh's coordinates are those of the scene of --sheet FRAME");
    add(all, "parallax", o.parallax, "K",
        "show the mesh as the camera's word does: its eye moves K mm where the viewer's moves 1 "
        "mm, "
        "0 to 100 (default: the mesh as it stands; with --in-scene as the frame has it)");
    add(all, "faces", o.faces, "STYLE",
        "wire: all edges; hidden: without those behind a face; flat: filled, shaded (default "
        "wire)");
    add(all, "colour", o.colour, "R,G,B", "of what has none in the file, 0 to 1 (default 1,1,1)");
    add(all, "background", o.background, "R,G,B", "(default 0,0,0)");
    add(all, "plain", o.plain, "ignore the file's colours");
    add(all, "point-size", o.point_size, "MM",
        "width and height of the points of a file without lines and faces; 0 is a pixel (default: "
        "of vertices alone, so that they join where they are dense; else 0)");
    add(all, "light", o.light, "X,Y,Z",
        "where the light of flat faces is (default -1,1,-1: left above the viewer)");
}

void declare(options::options_description& all, WireframeOptions& o)
{
    add(all, "output,o", o.output, "FRAME", "the frame: .png, .exr or .tiff");
    declare_mesh(all, o);
    add(all, "lens-model", o.model, "MODEL",
        "extended_pinhole, pinhole, hybrid or full (default extended_pinhole)");
    add(all, "samples", o.samples, "N",
        "rays for each lens (full), or points of a point's spread (hybrid; default 32)");
    add(all, "lens-mapping", o.mapping, "RULE",
        "auto, closest, accurate or exhaustive (default auto)");
    add(all, "pseudoscopic", o.pseudoscopic,
        "what a single-stage capture records: only what is behind the sheet, inverted in depth");
    declare(all, o.sheet);
    declare(all, o.film);
    add(all, "print", o.print, "WxH",
        "size of the frame in mm, instead of --size (default 152.4x101.6)");
    declare(all, o.aperture);
    declare_start_geometry(all, o.start);
    add(all, "bits", o.bits, "N", "8 or 16 for PNG and TIFF (default 8)");
    add(all, "json", o.json, "print what was drawn and at what cost");
    declare(all, o.threads);
}

void read_colour(const char* option, const std::optional<std::string>& text, Colour& colour)
{
    if (!text)
        return;
    const auto v = parse_numbers(option, *text, "R,G,B", 3, 3);
    for (const double c : v)
        if (!(c >= 0 && c <= 1))
            throw UsageError(std::string("--") + option + " " + *text +
                             ": three numbers from 0 to 1 are expected");
    const Encoding srgb;
    colour = {float(decode(srgb, v[0])), float(decode(srgb, v[1])), float(decode(srgb, v[2])), 1};
}

FaceStyle face_style(const WireframeOptions& o)
{
    return meaning_of("faces", o.faces.value_or("wire"), faces_choices);
}

MeshPlace place_of(const WireframeOptions& o)
{
    MeshPlace place;
    if (o.scale) {
        const auto v = parse_numbers("scale", *o.scale, "K or K,K,K", 1, 3);
        if (v.size() == 2 || v[0] == 0 || v.back() == 0 || (v.size() == 3 && v[1] == 0))
            throw UsageError("--scale " + *o.scale + ": K or K,K,K is expected, none of them 0");
        place.scale = {v[0], v.size() == 3 ? v[1] : v[0], v.back()};
    }
    read_positive("fit", o.fit, place.fit, "a length in mm");
    read_vector("turn", o.turn, place.turn);
    read_vector("move", o.move, place.move);
    return place;
}

/// --parallax: sets the factor, for a scene's eye `scene_distance` mm in front of the sheet.
void change_parallax(const WireframeOptions& o, double scene_distance, FrameMetadata& geometry)
{
    if (o.parallax)
        geometry.parallax = Parallax{
            parse_number_between("parallax", *o.parallax, "a number", 0, 100, "0 to 100"),
            scene_distance};
}

/// The frame's geometry on the line.
FrameMetadata geometry_of(const WireframeOptions& o)
{
    FrameMetadata geometry = given_geometry(o.start, o.sheet, o.film, o.print);
    if (geometry.projection)
        throw InputError(*o.start + ": it is a frame for replay through a projection lens, through "
                                    "which wireframes are not drawn");
    if (geometry.film.width < 1)
        set_film_size("print", default_print, geometry.film);
    const bool is_frame = geometry.placement || geometry.parallax;
    const double frames_eye = scene_distance(geometry);
    change_aperture(o.aperture, geometry, o.start && !changes_lenses(o.sheet, o.aperture));
    change_parallax(o, is_frame ? frames_eye : viewer_distance(geometry), geometry);
    geometry.quilt.reset();
    return geometry;
}

/// The drawing's record for the frame's document.
RenderRecord record_of(const WireframeOptions& o, const FrameMetadata& geometry)
{
    RenderRecord record;
    if (geometry.render) { // from --sheet FRAME
        record.model = geometry.render->model;
        record.mapping = geometry.render->mapping;
        record.pseudoscopic = geometry.render->pseudoscopic;
    }
    record.program = "integral wireframe " PACKAGE_VERSION;
    const std::string& mesh = o.inputs[0];
    record.scene = mesh == "-" ? "" : mesh.substr(mesh.find_last_of('/') + 1);
    read_kind("lens-model", o.model, record.model);
    read_kind("lens-mapping", o.mapping, record.mapping);
    record.pseudoscopic = record.pseudoscopic || o.pseudoscopic;
    if (refracts_at_surface(record.model)) {
        record.beam_samples = o.samples ? in_range("samples", *o.samples, 1, most_samples) : 32;
    } else if (o.samples)
        throw UsageError("--samples is for --lens-model full and hybrid");
    return record;
}

/// The mesh, in the sheet frame.
Mesh mesh_of(const WireframeOptions& o, const FrameMetadata& geometry)
{
    MeshReading how;
    read_colour("colour", o.colour, how.plain);
    how.ignore_colours = o.plain;
    how.warn = [](const std::string& what) { say("wireframe", what); };
    const MeshPlace at = place_of(o);
    if (o.in_scene && (o.fit || o.scale || o.turn || o.move))
        throw UsageError("--in-scene takes the mesh as it stands in the scene; --fit, --scale, "
                         "--turn and --move do not work with it");
    if (o.in_scene && !geometry.placement)
        throw UsageError("--in-scene needs --sheet FRAME, a frame that povray-integral has "
                         "rendered");
    Mesh mesh = read_mesh(o.inputs[0], how);
    if (o.in_scene)
        for (Vec3& v : mesh.vertices)
            v = sheet_from_scene(*geometry.placement, v);
    try {
        place(mesh, at);
        if (o.in_scene || o.parallax)
            show_in_relief(mesh, relief_of(geometry));
    } catch (const std::invalid_argument& error) {
        throw InputError(o.inputs[0] + ": " + error.what());
    }
    return mesh;
}

/// Bits per sample of a frame written to `output`: 32 for floats.
int bits_of(const WireframeOptions& o, const std::string& output)
{
    const bool floats = format_for(output) == ImageFormat::exr;
    if (floats && o.bits == 32)
        return 32;
    const int bits = bits_given(o.bits, 8);
    return floats ? 32 : bits;
}

/// Gives points a size if the file has nothing else.
void enlarge_points(const WireframeOptions& o, WireframeRequest& request)
{
    Mesh& mesh = request.mesh;
    if (!mesh.lines.empty() || !mesh.triangles.empty()) {
        if (o.point_size)
            throw UsageError("--point-size is for files of points alone; " + o.inputs[0] +
                             " has lines or faces");
        return;
    }
    double side = mesh.is_cloud ? joining_size(mesh, request.optics.sheet().pitch) : 0;
    if (o.point_size) {
        side = parse_numbers("point-size", *o.point_size, "a length in mm", 1, 1)[0];
        if (!(side >= 0))
            throw UsageError("--point-size " + *o.point_size + ": 0 mm or more are expected");
    }
    if (side > 0) {
        add_squares(mesh, side);
        request.faces = FaceStyle::flat;
        request.light = {0, 0, -1}; // leaves the colours unchanged
    }
}

WireframeRequest request_of(const WireframeOptions& o, const FrameMetadata& geometry,
                            const RenderRecord& record)
{
    if (refracts_at_surface(record.model) && !has_surface(geometry.sheet))
        throw UsageError("--lens-model " + std::string(name_of(record.model)) +
                         " needs lenses whose surface reaches their edge; extended_pinhole works "
                         "for any");
    WireframeRequest request{mesh_of(o, geometry),
                             SheetOptics(geometry.sheet, geometry.aperture, record.model),
                             geometry.film, record.mapping};
    request.faces = face_style(o);
    request.samples = record.beam_samples;
    request.pseudoscopic = record.pseudoscopic;
    read_colour("background", o.background, request.background);
    read_vector("light", o.light, request.light);
    if (!(length(request.light) > 0))
        throw UsageError("--light 0,0,0 is no direction");
    enlarge_points(o, request);
    return request;
}

int run(const WireframeOptions& o)
{
    const std::string output = needed_output(o.output, "FRAME");
    const int bits = bits_of(o, output);
    check_writable(output);
    FrameMetadata geometry = geometry_of(o);
    const RenderRecord record = record_of(o, geometry);
    const WireframeRequest request = request_of(o, geometry, record);

    const auto start = std::chrono::steady_clock::now();
    WireframeCost cost;
    std::optional<Image> image = usage_checked(o.start.value_or("the geometry") + ": ", [&] {
        return draw_wireframe(request, bits, o.threads.count(), progress_bar("wireframe"), cost);
    });
    if (!image)
        throw Interrupted();
    const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start)
                               .count();
    geometry.render = record;
    geometry.render->seconds = std::getenv("SOURCE_DATE_EPOCH") ? 0 : seconds; // repeatable builds
    Frame frame{std::move(*image), std::nullopt};
    set_metadata(frame, geometry);
    write_frame(output, std::move(frame));
    if (o.json)
        std::cout << drawing_json(request.mesh, cost, seconds).dump(2) << "\n";
    else
        say("wireframe", drawing_text(request.mesh, cost, seconds));
    return exit_done;
}

} // namespace

const Command wireframe_command = {
    "wireframe",
    "points, lines and faces as a frame, without a scene to render",
    "MESH -o FRAME [--fit MM] [--faces hidden] [--print WxH] [--lens-model MODEL] ...",
    R"(Draws the points, lines and faces of a mesh as a frame, by projecting each
vertex through every lens that can image it (thesis 3.4). It takes less than a
second, so that things can be placed before they are traced. MESH is a Wavefront
OBJ file, or where the program was built with Assimp a file that Assimp reads:
PLY, STL, glTF, COLLADA, 3DS and many others. Vertices without lines and faces,
as in the clouds of points that integral depth writes, are drawn as points, so
large that they join where they are dense.
Its film points are those of povray-integral's rays; integral replay and print
take the frame as any other.

The file's coordinates are millimetres from the sheet's centre: x to the right,
y up, z into the picture; negative z comes out of it. Colours are those of v X Y
Z R G B, or usemtl's Kd, or what other formats have for them. Next to the sheet,
within its thickness, points and lines cover their lens; with --lens-model
pinhole they vanish between the lenses (figure 3-13).
)",
    1,
    1,
    described<WireframeOptions>,
    run_with<WireframeOptions, run>,
    true};

} // namespace integral
