// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/cli/lcd_image.h"

#include "integral/base/number_text.h"
#include "integral/cli/given_views.h"
#include "integral/cli/progress.h"
#include "integral/cli/values.h"
#include "integral/io/image_file.h"
#include "integral/output/panel_cards.h"
#include "integral/output/quilt.h"
#include "integral/replay/arrange.h"
#include "integral/replay/parallel_views.h"

#include <algorithm>
#include <cmath>

namespace integral {
namespace {

constexpr int largest_side = 32768, card_views = 8;
constexpr double most_samples = 1e9;

Neighbours neighbours(const options::variables_map& arguments, const char* option)
{
    const std::string word = text_of(arguments, option);
    if (word == "nearest")
        return Neighbours::nearest;
    if (word == "linear")
        return Neighbours::linear;
    throw UsageError(std::string("--") + option + " " + word + ": nearest or linear is expected");
}

Blend blend_of(const options::variables_map& arguments)
{
    return {neighbours(arguments, "blend"), neighbours(arguments, "sampling")};
}

bool close(double a, double b)
{
    return std::fabs(a - b) <= 1e-9 * std::max({1.0, std::fabs(a), std::fabs(b)});
}

/// What a frame has in common with those that are rendered for a panel.
struct Likeness {
    bool lenses, size, pixel_pitch, colours;
    bool all() const
    {
        return lenses && size && pixel_pitch && colours;
    } ///< its pixels are the panel's, under the same lenses
    /// It seems to have been meant for the panel: before one of the two was changed.
    bool nearly() const { return pixel_pitch && (lenses || (size && colours)); }
};

Likeness likeness(const FrameMetadata& frame, const FrameMetadata& panel)
{
    const LensSheet &a = frame.sheet, &b = panel.sheet;
    const Film &ours = frame.film, &theirs = panel.film;
    return {a.arrangement == b.arrangement && close(a.pitch, b.pitch) &&
                close(a.thickness, b.thickness) && close(a.ior, b.ior) && close(a.slant, b.slant) &&
                close(a.offset.x, b.offset.x) && close(a.offset.y, b.offset.y),
            ours.width == theirs.width && ours.height == theirs.height,
            close(ours.pixel_pitch.x, theirs.pixel_pitch.x) &&
                close(ours.pixel_pitch.y, theirs.pixel_pitch.y),
            same_layout(ours.subpixels, theirs.subpixels)};
}

/// Says so where a frame that seems to have been meant for the panel does not pass through.
void tell_near_miss(const std::string& name, const FrameMetadata& frame, const FrameMetadata& panel,
                    int views)
{
    const Likeness like = likeness(frame, panel);
    if (!like.nearly())
        return;
    const std::string what = !like.size
                                 ? "it has " + size_text(frame.film.width, frame.film.height) +
                                       " pixels and the panel " +
                                       size_text(panel.film.width, panel.film.height)
                             : !like.lenses ? std::string("its lenses are not the panel's")
                                            : "its pixels' colours lie otherwise";
    say("lcd", name + ": it is nearly a frame of this panel's own, but " + what +
                   ": the image is made of " + counted(views, "view") +
                   " of it; --camera says what to render for the panel");
}

/// Three channels of 8 or 16 bits over black; `linear`: 16 bits of linear light, to be blended.
Image prepared(const Image& view, bool linear)
{
    const Encoding light{Encoding::Kind::linear, 1}, encoding = linear ? light
                                                                : sample_bits(view) > 16
                                                                    ? Encoding()
                                                                    : view.encoding;
    const int bits = linear || sample_bits(view) > 8 ? 16 : 8;
    if (view.channels == 3)
        return converted(view, bits, encoding, false);
    Image opaque = bits == 8 ? make_image<std::uint8_t>(view.width, view.height, 3, encoding)
                             : make_image<std::uint16_t>(view.width, view.height, 3, encoding);
    const LinearReader reader(view);
    for (int y = 0; y < view.height; ++y)
        for (int x = 0; x < view.width; ++x) {
            Color c = reader(x, y);
            c.a = 1;
            store_linear(opaque, x, y, c);
        }
    return opaque;
}

Image mirrored(const Image& image, bool in_x, bool in_y)
{
    Image turned = image;
    for (int y = 0; y < image.height; ++y)
        for (int x = 0; x < image.width; ++x)
            store_pixel(turned, in_x ? image.width - 1 - x : x, in_y ? image.height - 1 - y : y,
                        stored_pixel(image, x, y));
    return turned;
}

/// The eyes of views of a frame, where the panel is as large as that frame's film; of a smaller or
/// larger one the views are spread over the panel's own zone, as their pictures are over the panel.
std::optional<EyeGrid> eyes_before(const Film& panel, const FrameMetadata& frame, EyeGrid eyes)
{
    constexpr double alike = 0.01;
    const auto same = [&](double a, double b) { return std::fabs(a - b) <= alike * b; };
    if (same(frame.film.width * frame.film.pixel_pitch.x, panel.width * panel.pixel_pitch.x) &&
        same(frame.film.height * frame.film.pixel_pitch.y, panel.height * panel.pixel_pitch.y))
        return eyes;
    return std::nullopt;
}

/// Says so where a frame of the panel's pixels and lenses is rendered for eyes elsewhere.
void tell_other_zone(const std::string& name, const Aperture& frame, const Aperture& panel)
{
    constexpr double alike = 0.01;
    const auto same = [&](double a, double b) { return a == b || std::fabs(a - b) <= alike * b; };
    if (same(frame.distance, panel.distance) && same(frame.width, panel.width))
        return;
    const auto mm = [](double length) { return with_decimals(length, 0) + " mm"; };
    say("lcd", name + ": it is rendered for eyes " + mm(frame.distance) + " away in a zone " +
                   mm(frame.width) + " wide; the panel's are " + mm(panel.distance) + " away in " +
                   mm(panel.width) +
                   ", and near the ends see neighbouring views; the scene's location and angle "
                   "decide (guide, Panels)");
}

/// The value of --view: one of `count`. Nothing if it was not given.
std::optional<int> chosen_view(const options::variables_map& arguments, int count)
{
    if (!given(arguments, "view"))
        return std::nullopt;
    return in_range(arguments, "view", 0, count - 1);
}

} // namespace

void add_panel_options(options::options_description& all)
{
    const auto value = [](const char* name) {
        return options::value<std::string>()->value_name(name);
    };
    all.add_options()("output,o", value("FILE"),
                      "the panel's image: .png, .tiff or .exr; of several frames or quilts files "
                      "with numbers before the extension, or a folder "
                      "that is there already, for files of the inputs' names")(
        "panel", value("NAME|FILE.json"),
        "the panel: one of --list, a description as --describe writes, or the calibration file of "
        "a Looking Glass display")(
        "views", value("CxR"),
        "views of a quilt whose name does not tell, across and up, or how many to see a frame of "
        "other geometry from (default: as many "
        "as pixels are nearest to a lens's), or of a card (default: 8)")(
        "blend", value("WAY")->default_value("linear"),
        "between views: linear, or nearest, as displays' makers do")(
        "sampling", value("WAY")->default_value("linear"),
        "between pixels of a view: linear or nearest")(
        "encoded", options::bool_switch(),
        "blend the values as they are stored, as displays' own programs do; not linear light: "
        "several times as fast, "
        "edges between views a little darker")(
        "size", value("WxH"),
        "pixels of each view that is seen of a frame (default: 1000 on the longer side)")(
        "viewing-distance", value("MM"),
        "how far the viewers are from the panel (default: as the panel says)")(
        "card", value("CARD"),
        "a test card in place of INPUT: views (each its number and colour), crosstalk (one view "
        "white), colours (red, green, blue and "
        "white bands in one view), pitch (bars of lines about the calibrated pitch)")(
        "view", options::value<int>()->value_name("K"),
        "the view that --card crosstalk or colours lights, from 0, the leftmost (default: every "
        "other; the middle one)")("list", options::bool_switch(),
                                  "list the panels that are known by name")(
        "describe", options::bool_switch(),
        "print the panel's description, to be changed and given to --panel")(
        "camera", options::bool_switch(),
        "print what povray-integral needs to render for the panel: an INI file's lines");
}

void check_panel_options(const options::variables_map& arguments)
{
    const bool describes = arguments["describe"].as<bool>(),
               camera = arguments["camera"].as<bool>(), card = given(arguments, "card");
    const int inputs = int(inputs_of(arguments).size());
    if (int(describes) + int(camera) + int(card) > 1)
        throw UsageError("--describe, --camera and --card do not go together");
    if ((describes || camera || card) && inputs > 0)
        throw UsageError(std::string(describes ? "--describe"
                                     : camera  ? "--camera"
                                               : "--card") +
                         " takes no INPUT");
    if (!given(arguments, "panel"))
        throw UsageError("--panel NAME|FILE.json is missing; --list tells the names");
    if (!describes && !camera && !given(arguments, "output") && !given(arguments, "show"))
        throw UsageError("-o FILE is missing, or --show DISPLAY");
    if (!describes && !camera && !card && inputs == 0)
        throw UsageError("INPUT is missing: a frame, a quilt or views");
    const std::string kind = text_of(arguments, "card");
    if (card && kind != "views" && kind != "crosstalk" && kind != "colours" && kind != "pitch")
        throw UsageError("--card " + kind + ": views, crosstalk, colours or pitch is expected");
    if (given(arguments, "view") && kind != "crosstalk" && kind != "colours")
        throw UsageError("--view is for --card crosstalk and --card colours");
    blend_of(arguments);
}

Panel panel_of(const options::variables_map& arguments)
{
    const std::string text = text_of(arguments, "panel");
    Panel panel;
    if (const auto known = panel_named(text)) {
        panel = *known;
    } else if (extension_of(text) != "json") {
        throw UsageError("--panel " + text +
                         ": no panel has this name; --list tells those that are known, and a "
                         "description's name ends in .json");
    } else {
        const std::string bytes = read_file(text);
        try {
            panel = panel_from_json(bytes);
        } catch (const std::invalid_argument& error) {
            throw InputError(text + ": " + error.what());
        }
    }
    if (!given(arguments, "viewing-distance"))
        return panel;
    const double distance = parse_number("viewing-distance", text_of(arguments, "viewing-distance"),
                                         "a number of mm");
    if (!(distance >= 1 && distance <= 1e6))
        throw UsageError("--viewing-distance " + text_of(arguments, "viewing-distance") +
                         ": 1 to 1000000 mm is expected");
    if (panel.calibration) {
        const Panel seen = panel_from(*panel.calibration, distance, panel.sheet.ior);
        panel.sheet = seen.sheet;
        panel.aperture = seen.aperture;
        return panel;
    }
    const auto filling = filling_aperture(panel.sheet, distance);
    if (!filling)
        throw UsageError(text +
                         ": no zone fills its lenses; a description with an aperture would do");
    panel.aperture = *filling;
    return panel;
}

PanelImages::PanelImages(const options::variables_map& arguments, const Panel& panel)
    : arguments_(arguments),
      panel_(panel),
      geometry_(frame_geometry(panel)),
      threads_(in_range(arguments, "threads", 0, 1024))
{
    if (double(panel.film.width) * panel.film.height * 3 > most_samples)
        throw UsageError("--panel " + text_of(arguments, "panel") +
                         ": it has more pixels than this program makes at once");
}

std::vector<std::vector<std::string>> PanelImages::groups(
    const std::vector<std::string>& inputs) const
{
    if (inputs.size() == 1)
        return {inputs};
    // Files of views say so; so do quilts and frames. What says nothing is a view.
    const Views first = read_views(inputs[0], false);
    const bool one_view = first.metadata && first.metadata->quilt->view;
    bool alone = first.metadata || grid_in_name(inputs[0]);
    if (!first.metadata && !alone)
        alone = read_frame(inputs[0]).metadata.has_value();
    if (one_view || !alone)
        return {inputs};
    std::vector<std::vector<std::string>> each;
    for (const std::string& input : inputs)
        each.push_back({input});
    return each;
}

Frame PanelImages::finished(Image image, std::optional<Aperture> zone) const
{
    Frame frame{std::move(image), std::nullopt};
    if (panel_.mirrored_x || panel_.mirrored_y)
        return frame;
    FrameMetadata geometry = geometry_;
    geometry.aperture = zone.value_or(panel_.aperture);
    geometry.encoding = frame.image.encoding;
    set_metadata(frame, geometry);
    return frame;
}

Image PanelImages::interlaced(std::vector<Image> views, ViewGrid grid, std::optional<EyeGrid> eyes,
                              Blend blend)
{
    views_ = grid.count();
    const bool blends = blend.views == Neighbours::linear || blend.pixels == Neighbours::linear;
    const bool light = blends && !arguments_["encoded"].as<bool>();
    const Encoding encoding = sample_bits(views[0]) > 16 ? Encoding() : views[0].encoding;
    const int bits = std::min(16, sample_bits(views[0]));
    for (Image& view : views) {
        view = prepared(view, light);
        stop_if_interrupted();
    }
    const ViewPictures pictures(views, grid);
    Image image = panel_image(pictures, panel_.film.width, panel_.film.height);
    if (panel_.calibration) {
        if (!published_)
            published_ = published_mapping(*panel_.calibration);
        interlace(image, pictures, *published_, blend, threads_);
    } else {
        if (!eyes &&
            !(std::isfinite(panel_.aperture.width) && std::isfinite(panel_.aperture.height)))
            throw UsageError("--panel " + text_of(arguments_, "panel") +
                             ": no zone, however wide, fills its lenses; give aperture in its "
                             "description, or check thickness and pitch: they may be swapped");
        const double distance = panel_.aperture.distance;
        const EyeGrid wanted = eyes.value_or(EyeGrid{viewing_zone(geometry_, distance), distance});
        if (!rays_ || wanted.zone.x != rays_eyes_.zone.x || wanted.zone.y != rays_eyes_.zone.y ||
            wanted.distance != rays_eyes_.distance) {
            rays_ = ray_mapping(geometry_, wanted, threads_, progress_bar("panel"));
            rays_eyes_ = wanted;
            if (!rays_)
                throw Interrupted();
        }
        if (rays_->round_lenses && grid.count() > 1 && (grid.columns == 1 || grid.rows == 1))
            throw UsageError("round lenses show views across and up; " +
                             std::to_string(grid.columns) + "x" + std::to_string(grid.rows) +
                             " are given");
        interlace(image, pictures, *rays_, blend, threads_);
        if (panel_.mirrored_x || panel_.mirrored_y)
            image = mirrored(image, panel_.mirrored_x, panel_.mirrored_y);
    }
    return light ? converted(image, bits, encoding, false) : image;
}

Frame PanelImages::image_of(const std::vector<std::string>& group)
{
    const std::string& name = group[0];
    try {
        std::optional<Frame> frame;
        if (group.size() == 1 && !grid_in_name(name) && !read_views(name, true).metadata)
            frame = read_frame(name);
        if (frame && !frame->metadata) {
            if (!given(arguments_, "views"))
                throw UsageError(name + ": it says neither a frame's geometry nor its views; "
                                        "--views CxR would tell the views of a quilt");
            frame.reset();
        }
        stop_if_interrupted();
        if (!frame) {
            GivenViews views = read_given_views(arguments_, group, true);
            if (views.metadata && !views.metadata->quilt->eyes)
                throw UsageError(name +
                                 ": it holds parallel views; a panel shows those of eyes (integral "
                                 "views --eyes), or the frame (integral views --to-frame)");
            std::optional<EyeGrid> eyes;
            if (views.metadata)
                eyes = eyes_before(panel_.film, *views.metadata, *views.metadata->quilt->eyes);
            return finished(
                interlaced(std::move(views.views), views.grid, eyes, blend_of(arguments_)));
        }
        if (likeness(*frame->metadata, geometry_).all()) {
            views_ = 0;
            tell_other_zone(name, frame->metadata->aperture, panel_.aperture);
            const Image image = prepared(frame->image, false);
            return finished(panel_.mirrored_x || panel_.mirrored_y
                                ? mirrored(image, panel_.mirrored_x, panel_.mirrored_y)
                                : image,
                            frame->metadata->aperture);
        }
        const ViewGrid grid = given(arguments_, "views") ? parse_view_grid(arguments_)
                                                         : natural_views(geometry_);
        const bool round = geometry_.sheet.arrangement != Arrangement::lenticular,
                   frame_round = frame->metadata->sheet.arrangement != Arrangement::lenticular;
        if (grid.rows > 1 && !(round && frame_round))
            throw UsageError(
                "--views " + std::to_string(grid.columns) + "x" + std::to_string(grid.rows) +
                ": lenticular lenses show nothing new from above: one row is expected");
        tell_near_miss(name, *frame->metadata, geometry_, grid.count());
        PixelSize size{};
        if (given(arguments_, "size")) {
            size = parse_size("size", text_of(arguments_, "size"), largest_side);
        } else {
            View view;
            set_view_size(view, geometry_.film, 1000);
            size = {view.width, view.height};
        }
        const double distance = frame->metadata->aperture.distance;
        const auto eyes = eyes_before(panel_.film, *frame->metadata,
                                      {viewing_zone(*frame->metadata, distance), distance});
        return finished(interlaced(views_of_eyes(*frame, grid, size, threads_), grid, eyes,
                                   blend_of(arguments_)));
    } catch (const std::invalid_argument& error) {
        throw UsageError(name + ": " + error.what());
    }
}

Frame PanelImages::card()
{
    const std::string kind = text_of(arguments_, "card");
    const bool round = geometry_.sheet.arrangement != Arrangement::lenticular;
    const ViewGrid grid = given(arguments_, "views") ? parse_view_grid(arguments_)
                          : round                    ? ViewGrid{4, 4}
                                                     : ViewGrid{card_views, 1};
    try {
        if (kind == "pitch") {
            const Image card = pitch_card(panel_);
            return finished(panel_.mirrored_x || panel_.mirrored_y
                                ? mirrored(card, panel_.mirrored_x, panel_.mirrored_y)
                                : card);
        }
        const int count = grid.count();
        const auto view = chosen_view(arguments_, count);
        const double aspect = panel_.film.width * panel_.film.pixel_pitch.x /
                              (panel_.film.height * panel_.film.pixel_pitch.y);
        auto views = kind == "views"       ? view_number_card(count, aspect)
                     : kind == "crosstalk" ? crosstalk_card(count, view)
                                           : colour_card(count, view.value_or(count / 2));
        return finished(interlaced(std::move(views), grid, std::nullopt,
                                   {Neighbours::nearest, Neighbours::nearest}));
    } catch (const std::invalid_argument& error) {
        throw UsageError("--card " + kind + ": " + error.what());
    }
}

} // namespace integral
