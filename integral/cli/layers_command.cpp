// SPDX-License-Identifier: AGPL-3.0-or-later
// integral layers: flat pictures behind and in front of the sheet, as one frame.
#include "integral/base/number_text.h"
#include "integral/cli/fit_options.h"
#include "integral/cli/geometry_options.h"
#include "integral/cli/progress.h"
#include "integral/cli/thread_options.h"
#include "integral/io/image_file.h"
#include "integral/views/layers.h"

namespace integral {
namespace {

constexpr std::size_t max_layers = 256;
constexpr double largest_layer = 1e6; // mm
constexpr double max_degrees = 89;
constexpr char layer_form[] = "PICTURE@DISTANCE[,DISTANCE...][,width=MM][,height=MM][,x=MM][,y=MM]["
                              ",turn=DEGREES][,tilt=DEGREES]";

struct LayersOptions : CommonOptions {
    PicturesFrameOptions frame;
    std::optional<std::string> depth, output;
    bool transparent = false, json = false;
    FitOptions fit;
    ThreadOptions threads;
};

void declare(options::options_description& all, LayersOptions& o)
{
    add(all, "output,o", o.output, "FRAME", "the frame: .png, .exr or .tiff");
    add(all, "depth", o.depth, "FILE.exr",
        "the frame's depth frame, for integral combine: at each pixel the distance of the nearest "
        "layer that is opaque by half or more; named FRAME-depth.exr, combine finds it by itself");
    add(all, "transparent", o.transparent,
        "keep alpha: the frame is transparent where all layers are; without it they stand on "
        "black");
    add(all, "json", o.json, "print the figures as JSON");
    add(all, "fit", o.fit.given, "HOW",
        "a layer without a size, of another shape than the film: contain, whole with transparent "
        "bars (default); cover, filling the film and beyond; or stretch. Shapes that differ by at "
        "most 1% are stretched");
    declare(all, o.frame);
    declare(all, o.threads);
}

/// Reads one of the words after a layer's distance, NAME=NUMBER. Throws UsageError.
void read_layer_word(const std::string& word, const std::string& given, PictureLayer& layer)
{
    const auto equals = word.find('=');
    const std::string name = word.substr(0, equals);
    const auto value = equals == std::string::npos ? std::nullopt
                                                   : number_in(word.substr(equals + 1));
    const auto is_size = [&] {
        if (!(*value > 0 && *value <= largest_layer))
            throw UsageError(given + ": " + word +
                             " is not a size; give more than 0 mm, and at "
                             "most 1e6");
        return *value;
    };
    const auto within = [&](double limit, const char* help) {
        if (!(std::fabs(*value) <= limit))
            throw UsageError(given + ": " + word + help);
        return *value;
    };
    const char *const too_far = " is too far from the film; at most 1e6 mm is possible",
                      *const too_much = " turns the layer's edge to the viewer; give at most 89 "
                                        "degrees";
    if (value && name == "width")
        layer.width = is_size();
    else if (value && name == "height")
        layer.height = is_size();
    else if (value && name == "x")
        layer.place.x = within(largest_layer, too_far);
    else if (value && name == "y")
        layer.place.y = within(largest_layer, too_far);
    else if (value && name == "turn")
        layer.turn = within(max_degrees, too_much);
    else if (value && name == "tilt")
        layer.tilt = within(max_degrees, too_much);
    else
        throw UsageError(given + ": " + word +
                         " is not one of width=MM, height=MM, x=MM, y=MM, turn=DEGREES, "
                         "tilt=DEGREES; " +
                         layer_form + " is expected");
}

/// Reads DISTANCE[,DISTANCE...][,WORD...] into `layers`, which are as `layer` otherwise. `given`:
/// what messages quote. Throws UsageError.
std::vector<PictureLayer> layers_at(const std::string& words, const std::string& given,
                                    PictureLayer layer)
{
    std::vector<double> distances;
    bool has_words = false;
    for (const std::string& word : parts_between_commas(words)) {
        const auto value = number_in(word);
        if (has_words || (!value && !distances.empty())) {
            has_words = true;
            read_layer_word(word, given, layer);
            continue;
        }
        if (layer.path.empty() || !value)
            throw UsageError(given + ": " + (word.empty() ? "nothing" : word) +
                             " is not a distance in mm; " + layer_form + " is expected");
        if (!(*value <= max_layer_distance))
            throw UsageError(given + ": " + word + " mm is too far; at most 1e6 is possible");
        distances.push_back(*value);
    }
    std::vector<PictureLayer> layers(distances.size(), layer);
    for (std::size_t k = 0; k < layers.size(); ++k)
        layers[k].distance = distances[k];
    return layers;
}

/// Gives each layer the picture of one file that has its place in the list.
void number_pictures(std::vector<PictureLayer>& layers)
{
    for (std::size_t k = 0; k < layers.size(); ++k) {
        layers[k].picture = int(k);
        layers[k].pictures = int(layers.size());
    }
}

bool is_layered(const std::string& path) { return extension_of(path) == "ora"; }

/// The layers of a painting program's file whose names end in @DISTANCE[,WORD...].
std::vector<PictureLayer> layers_by_name(const std::string& path)
{
    const std::vector<std::string> names = names_of_layers(path);
    std::vector<PictureLayer> layers;
    for (const std::string& name : names) {
        const auto at = name.rfind('@');
        if (at == std::string::npos)
            throw UsageError(path + ": its layer \"" + name +
                             "\" has no distance; rename it NAME@DISTANCE, or give the distances "
                             "of all " +
                             std::to_string(names.size()) + " layers, the lowest first: " + path +
                             "@DISTANCE,...");
        PictureLayer layer;
        layer.path = path;
        layer.name = name.substr(0, at);
        const auto read = layers_at(name.substr(at + 1), path + ": its layer \"" + name + "\"",
                                    layer);
        if (read.size() != 1)
            throw UsageError(path + ": its layer \"" + name + "\" has " +
                             std::to_string(read.size()) + " distances; give it one");
        layers.push_back(read[0]);
    }
    number_pictures(layers);
    return layers;
}

/// Names the layers of a painting program's file. Throws UsageError if their number differs from
/// that of the distances.
void name_layers(std::vector<PictureLayer>& layers)
{
    const std::string& path = layers.at(0).path;
    const std::vector<std::string> names = names_of_layers(path);
    if (names.size() != layers.size())
        throw UsageError(path + ": it has " + counted(std::ptrdiff_t(names.size()), "layer") +
                         "; give as many distances, the lowest layer's first");
    for (std::size_t k = 0; k < layers.size(); ++k)
        layers[k].name = names[k];
    number_pictures(layers);
}

/// Reads PICTURE@DISTANCE,...; the picture's name ends at the last @. Several distances are of the
/// pictures of one file, a layer each. Throws UsageError.
std::vector<PictureLayer> layers_of(const std::string& given)
{
    if (is_layered(given))
        return layers_by_name(given);
    const auto at = given.rfind('@');
    if (at == std::string::npos)
        throw UsageError(given + ": it has no distance; " + layer_form + " is expected");
    PictureLayer layer;
    layer.path = given.substr(0, at);
    std::vector<PictureLayer> layers = layers_at(given.substr(at + 1), given, layer);
    if (is_layered(layer.path))
        name_layers(layers);
    else if (layers.size() > 1)
        number_pictures(layers);
    return layers;
}

LayersRequest request_of(const LayersOptions& o)
{
    LayersRequest request;
    for (const std::string& given : o.inputs)
        for (const PictureLayer& layer : layers_of(given))
            request.layers.push_back(layer);
    if (request.layers.size() > max_layers)
        throw UsageError("at most " + std::to_string(max_layers) + " layers are possible");
    request.output = needed_output(o.output, "FRAME");
    request.depth_output = o.depth.value_or("");
    if (o.depth)
        check_depth_name("depth", *o.depth);
    request.fit = o.fit.value();
    request.transparent = o.transparent;
    request.bits = bits_given(o.frame.bits);
    request.threads = o.threads.count();
    request.tell = [](const std::string& what) { say("layers", what); };
    return request;
}

int run(const LayersOptions& o)
{
    LayersRequest request = request_of(o);
    format_for(request.output);
    check_outputs({o.output, o.depth});
    request.geometry = geometry_for_pictures(o.frame, request.layers[0].path);
    const LayersView view = write_layers(request, progress_bar("layers"));
    print_figures(o.json ? layers_json(view) : layers_text(view), request.output == "-");
    return exit_done;
}

} // namespace

const Command layers_command = {
    "layers",
    "flat pictures at distances behind and in front of the sheet, as one frame",
    "PICTURE@DISTANCE...|ART.ora -o FRAME [--print WxH] [--lpi N] [--depth FILE.exr] ...",
    R"(Makes a frame from flat pictures, each at its own DISTANCE: mm behind the sheet, or in
front of it if less than 0, as depth frames have it.
Transparent pictures show what is behind them. For the eye in the middle all layers lie on
each other as they were painted: a layer fills the film there, however far it is.

After the distance, width=MM, height=MM, x=MM and y=MM, separated by commas, give a layer
another size, and its middle another place right of and above the film's middle. These
lengths, too, are measured on the sheet as the eye in the middle sees them. turn=DEGREES and
tilt=DEGREES let a layer's right side and its upper side go back from its middle, as a wall or
a floor. The last @ ends the picture's name.

A painting program's layers come as an OpenRaster file, ART.ora, whose layers' names end in
@DISTANCE[,width=MM...], or as ART.ora@DISTANCE,..., with the lowest layer's distance first.

Prints for each layer how large it is at its distance, how far it moves while the eye crosses
the viewing zone, and whether the sheet and film show that depth sharply.
)",
    1,
    int(max_layers),
    described<LayersOptions>,
    run_with<LayersOptions, run>};

} // namespace integral
