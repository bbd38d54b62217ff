// SPDX-License-Identifier: AGPL-3.0-or-later
// The table of fuzz targets. Readers get their bytes from a file, through the functions that the
// commands use. Their results are then used, in ways that take only microseconds.
#include "tests/sanitized/fuzz/target.h"

#include "integral/batch/manifest.h"
#include "integral/compare/compare.h"
#include "integral/compare/tolerances.h"
#include "integral/io/embedded_depth.h"
#include "integral/io/image_file.h"
#include "integral/io/layer_stack.h"
#include "integral/io/pfm_file.h"
#include "integral/laboratory/response.h"
#include "integral/print/colour_profile.h"
#include "integral/replay/replay.h"
#include "integral/sheet/camera_words.h"
#include "integral/sheet/panel.h"
#include "integral/sheet/scene_depth_report.h"
#include "integral/wireframe/obj_file.h"

#include <algorithm>
#include <cstdlib>

namespace fuzz {
namespace {

using namespace integral;

constexpr int most_pixels = 4096; // larger pictures are read, but not used further

void look_at(const Frame& frame)
{
    if (frame.image.width > most_pixels / frame.image.height)
        return;
    compare(frame, frame);
    if (!frame.metadata)
        return;
    View view;
    view.eye = centre_eye(*frame.metadata);
    view.width = view.height = 2;
    view.samples = 1;
    replay(frame, view, 1);
}

void read_picture(const Bytes& bytes)
{
    const std::string path = file_of(bytes);
    read_views(path, false);
    look_at(read_frame(path));
}

/// The views of an MPO or an OpenEXR, and its first picture.
void read_views_of_file(const Bytes& bytes)
{
    read_list_of_views(file_of(bytes));
    read_picture(bytes);
}

void read_embedded_depth(const Bytes& bytes)
{
    try {
        depth_in_jpeg(bytes);
    } catch (const std::runtime_error& error) { // embedded_depth adds the file's name
        throw InputError(error.what());
    }
}

void read_depth_frame(const Bytes& bytes)
{
    const std::string path = file_of(bytes);
    const DepthFrame depths = read_depths(path);
    scene_verdict_text(path, depths);
    scene_depth_text(depths);
}

/// Checks that a document which was read, when written and read again, is the same.
void read_sheet(const Bytes& bytes)
{
    const FrameMetadata metadata = read_metadata(file_of(bytes));
    const std::string text = to_json(metadata);
    if (to_json(frame_metadata_from_json(text)) != text)
        std::abort();
    const SheetOptics optics(metadata.sheet, metadata.aperture);
    for (const auto mapping : {LensMapping::automatic, LensMapping::closest, LensMapping::accurate})
        for (const Vec2 pixel : {Vec2{0, 0}, Vec2{0.5, 0.25}, Vec2{100, 1000}})
            optics.map(film_from_pixel(metadata.film, pixel), mapping);
}

/// Library readers throw std::invalid_argument; commands add the file's name.
template <class Read> auto as_input(Read read)
{
    try {
        return read();
    } catch (const std::invalid_argument& error) {
        throw InputError(error.what());
    }
}

void read_panel(const Bytes& bytes)
{
    const Panel panel = as_input([&] { return panel_from_json(bytes); });
    const std::string text = to_json(panel);
    if (to_json(panel_from_json(text)) != text)
        std::abort();
    camera_words(frame_geometry(panel));
    const FrameMetadata geometry = frame_geometry(panel);
    SheetOptics(geometry.sheet, geometry.aperture).map({0, 0}, LensMapping::automatic);
    if (panel.calibration)
        for (int channel = 0; channel < 3; ++channel) {
            const double view = view_of_subpixel(*panel.calibration, panel.film.width - 1, 0,
                                                 channel);
            if (!(view >= 0 && view < 1))
                std::abort();
        }
}

void read_tolerances(const Bytes& bytes)
{
    const Tolerances tolerances = as_input([&] { return tolerances_from_json(bytes); });
    for (const char* name : {"", "glass/ball.png", "a11.png"}) {
        limits_for(tolerances, name);
        rules_for(tolerances, name);
    }
}

void read_batch(const Bytes& bytes) { read_manifest(file_of(bytes)); }

void read_float_map(const Bytes& bytes)
{
    const FloatMap map = read_pfm(file_of(bytes));
    if (map.values.size() != std::size_t(map.width) * map.height)
        std::abort();
}

/// Checks that every point, line and triangle refers to vertices that exist.
void read_mesh(const Bytes& bytes)
{
    const Mesh mesh = read_obj(file_of(bytes), {});
    const auto check = [&](std::uint32_t vertex) {
        if (vertex >= mesh.vertices.size())
            std::abort();
    };
    for (const MeshPoint& point : mesh.points)
        check(point.vertex);
    for (const auto* lines : {&mesh.lines, &mesh.face_edges})
        for (const MeshLine& line : *lines)
            std::for_each(line.vertex.begin(), line.vertex.end(), check);
    for (const MeshTriangle& triangle : mesh.triangles)
        std::for_each(triangle.vertex.begin(), triangle.vertex.end(), check);
}

/// The list of layers in an OpenRaster file.
void read_layer_stack(const Bytes& bytes)
{
    try {
        layer_stack_of(bytes);
    } catch (const std::runtime_error& error) { // the command adds the file's name
        throw InputError(error.what());
    }
}

void read_responses(const Bytes& bytes) { response_text(read_response(file_of(bytes))); }

void read_profile(const Bytes& bytes)
{
    const Image picture = bytes.size() % 2 ? make_image<std::uint8_t>(2, 1, 3, {})
                                           : make_image<std::uint16_t>(2, 1, 3, {});
    try {
        in_profile(picture, bytes, Intent(bytes.size() / 2 % 4));
    } catch (const std::runtime_error& error) { // the command adds the file's name
        throw InputError(error.what());
    }
}

const std::vector<Bytes> json_words = {"\"sheet\":",
                                       "\"arrangement\":",
                                       "\"lenticular\"",
                                       "\"square\"",
                                       "\"hexagonal\"",
                                       "\"pitch_mm\":",
                                       "\"thickness_mm\":",
                                       "\"ior\":",
                                       "\"slant_degrees\":",
                                       "\"offset_mm\":",
                                       "\"film\":",
                                       "\"width\":",
                                       "\"height\":",
                                       "\"pixel_pitch_mm\":",
                                       "\"subpixels\":",
                                       "\"rgb\"",
                                       "\"bgr\"",
                                       "\"aperture\":",
                                       "\"distance_mm\":",
                                       "\"width_mm\":",
                                       "\"height_mm\":",
                                       "\"shape\":",
                                       "\"ellipse\"",
                                       "\"rectangle\"",
                                       "\"camera\":",
                                       "\"origin\":",
                                       "\"units_per_mm\":",
                                       "\"encoding\":",
                                       "\"kind\":",
                                       "\"linear\"",
                                       "\"srgb\"",
                                       "\"power\"",
                                       "\"gamma\":",
                                       "\"render\":",
                                       "\"quilt\":",
                                       "\"columns\":",
                                       "\"rows\":",
                                       "\"view\":",
                                       "\"eyes\":",
                                       "null",
                                       "true",
                                       "[0,0]",
                                       "1e-6",
                                       "1e-4",
                                       "1e3",
                                       "1e6",
                                       "1e9",
                                       "1e30",
                                       "1e100",
                                       "1e308",
                                       "1e999",
                                       "-1",
                                       "0",
                                       "90",
                                       "1000000",
                                       "4096",
                                       "9223372036854775807",
                                       "\\u0000",
                                       "{}",
                                       "[["};
const std::vector<Bytes> panel_words = {"\"panel\":",
                                        "\"name\":",
                                        "\"width\":",
                                        "\"height\":",
                                        "\"pixel_pitch_mm\":",
                                        "\"subpixels\":",
                                        "\"vrgb\"",
                                        "\"pattern\":",
                                        "\"cells\":",
                                        "\"mirrored\":",
                                        "\"xy\"",
                                        "\"sheet\":",
                                        "\"micro_image_pitch_mm\":",
                                        "\"viewing_distance_mm\":",
                                        "\"aperture\":",
                                        "\"calibration\":",
                                        "\"pitch\":",
                                        "\"slope\":",
                                        "\"center\":",
                                        "\"viewCone\":",
                                        "\"invView\":",
                                        "\"DPI\":",
                                        "\"screenW\":",
                                        "\"screenH\":",
                                        "\"flipImageX\":",
                                        "\"subpixelCells\":",
                                        "\"ROffsetX\":",
                                        "\"CellPatternMode\":",
                                        "\"value\":",
                                        "\"devices\":",
                                        "null",
                                        "1e-300",
                                        "1e300",
                                        "0",
                                        "-1",
                                        "1e9"};
const std::vector<Bytes> layer_stack_words = {"<image w='1' h='1'>", "<stack>",   "</stack>",
                                              "<layer src='a'/>",    " name='a'", " x='-1'",
                                              " opacity='.5'",       "&amp;",     "<!--"};
const std::vector<Bytes> suite_words = {"\"defaults\":",
                                        "\"files\":",
                                        "\"max_rmse\":",
                                        "\"min_psnr\":",
                                        "\"min_ssim\":",
                                        "\"max_difference\":",
                                        "\"max_micro_image_rmse\":",
                                        "null",
                                        "*",
                                        "[",
                                        "]",
                                        "\\",
                                        "1e999",
                                        "-1"};
const std::vector<Bytes> manifest_words = {
    "\"output\":", "\"scenes\":", "\"sheets\":", "\"papers\":",  "\"panels\":",  "\"previews\":",
    "\"jobs\":",   "\"name\":",   "\"file\":",   "\"options\":", "\"declare\":", "\"size\":",
    "\"camera\":", "\"inputs\":", "\"format\":", "\"scene\":",   "\"sheet\":",   "\"/dev/null\"",
    "[1,1]",       "\n",          "\"..\"",      "\"-o\"",       "null",         "1e999"};
const std::vector<Bytes> png_words = {"IHDR", "PLTE", "IDAT", "IEND", "tRNS", "gAMA",
                                      "sRGB", "cHRM", "iCCP", "iTXt", "zTXt", "tEXt",
                                      "pHYs", "sBIT", "bKGD", "hIST", "eXIf", "integral"};
const std::vector<Bytes> exr_words = {"channels",
                                      "chlist",
                                      "compression",
                                      "dataWindow",
                                      "displayWindow",
                                      "box2i",
                                      "lineOrder",
                                      "pixelAspectRatio",
                                      "float",
                                      "screenWindowCenter",
                                      "screenWindowWidth",
                                      "v2f",
                                      "tiles",
                                      "tiledesc",
                                      "string",
                                      "integral",
                                      "xDensity",
                                      "type",
                                      "name",
                                      "chunkCount",
                                      "scanlineimage",
                                      "tiledimage",
                                      "deepscanline",
                                      "R",
                                      "G",
                                      "B",
                                      "A",
                                      "Y",
                                      "Z"};
const std::vector<Bytes> tiff_words = {
    "II*",          "MM",           "\x06\x01\x03", "\x0e\x01\x02", "\x11\x01\x04",
    "\x15\x01\x03", "\x16\x01\x04", "\x17\x01\x04", "\x1a\x01\x05", "\x1c\x01\x03",
    "\x3d\x01\x03", "\x40\x01\x03", "\x42\x01\x04", "\x52\x01\x03", "\x53\x01\x03"};
const std::vector<Bytes> jpeg_words = {"\xff\xd8", "\xff\xd9", "\xff\xe1",    "\xff\xe2",
                                       "\xff\xc0", "\xff\xc2", "\xff\xdd",    "\xff\xda",
                                       "MPF",      "MM",       "\xb0\x01",    "\xb0\x02",
                                       "Exif",     "Adobe",    "\xff\xff\xff"};
const std::vector<Bytes> phone_words = {"http://ns.adobe.com/xap/1.0/",
                                        "http://ns.adobe.com/xmp/extension/",
                                        "GDepth:Data=\"",
                                        "GDepth:Format=\"RangeLinear\"",
                                        "GDepth:Near=\"",
                                        "GDepth:Far=\"",
                                        "Item:Mime=\"",
                                        "Item:Length=\"",
                                        "Item:Semantic=\"Depth\"",
                                        "\xff\xe1",
                                        "1e300",
                                        "<",
                                        ">"};
const std::vector<Bytes> profile_words = {"acsp", "prtr", "mntr", "spac", "RGB ", "CMYK", "Lab ",
                                          "XYZ ", "A2B0", "B2A0", "rTRC", "gXYZ", "wtpt", "curv",
                                          "para", "mft1", "mft2", "mAB ", "mBA ", "desc"};

const std::vector<Bytes> mesh_words = {"v ", "p ", "l ", "f ", "usemtl ", "mtllib ", "//", "-1"};

/// A planted fault, for the test of the fuzzing itself: reads past the end of its input, but only
/// for certain bytes.
void planted(const Bytes& bytes)
{
    [[maybe_unused]] static volatile char sink;
    if (bytes.size() > 20 && bytes[3] == 'f' && bytes[5] == 'a' && bytes[7] == 'u' &&
        bytes[11] == 'l' && bytes[13] == 't') {
        const std::vector<char> copy(bytes.begin(), bytes.end());
        sink = copy.data()[bytes.size()];
    }
}

std::vector<Bytes> planted_seeds() { return {Bytes(32, ' ')}; }

} // namespace

const Target planted_fault = {"planted", planted, planted_seeds, {}};

const std::vector<Target> targets = {
    {"png", read_picture, png_seeds, png_words, mutated_png},
    {"exr", read_views_of_file, exr_seeds, exr_words},
    {"tiff", read_picture, tiff_seeds, tiff_words},
    {"jpeg", read_views_of_file, jpeg_seeds, jpeg_words},
    {"phone", read_embedded_depth, phone_seeds, phone_words},
    {"depths", read_depth_frame, depth_seeds, exr_words},
    {"sheet", read_sheet, sheet_seeds, json_words},
    {"panel", read_panel, panel_seeds, panel_words},
    {"suite", read_tolerances, tolerance_seeds, suite_words},
    {"batch", read_batch, manifest_seeds, manifest_words},
    {"profile", read_profile, profile_seeds, profile_words},
    {"floats", read_float_map, float_map_seeds, {}},
    {"mesh", read_mesh, mesh_seeds, mesh_words},
    {"layers", read_layer_stack, layer_stack_seeds, layer_stack_words},
    {"response", read_responses, response_seeds, {}},
    {"commands", run_command, command_seeds, {}},
};

} // namespace fuzz
