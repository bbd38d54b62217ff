// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/panel/panel_images.h"

#include "integral/base/interrupt.h"
#include "integral/base/number_text.h"
#include "integral/frame/quilt_name.h"
#include "integral/io/image_file.h"
#include "integral/io/video.h"
#include "integral/panel/panel_cards.h"
#include "integral/panel/panel_likeness.h"
#include "integral/replay/arrange.h"
#include "integral/views/parallel_views.h"
#include "integral/views/quilt.h"

#include <algorithm>
#include <cmath>

namespace integral {
namespace {

constexpr int card_views = 8, longer_side_of_a_view = 1000;
constexpr double most_samples = 1e9;

/// Converts to three channels of 8 or 16 bits over black; `linear`: 16 bits of linear light, for
/// blending.
Image prepared(const Image& view, bool linear)
{
    const Encoding light{Encoding::Kind::linear, 1}, encoding = linear ? light
                                                                : sample_bits(view) > 16
                                                                    ? Encoding()
                                                                    : view.encoding;
    return over_black(view, linear || sample_bits(view) > 8 ? 16 : 8, encoding);
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

const char* name_of(PanelCard card)
{
    switch (card) {
    case PanelCard::views: return "views";
    case PanelCard::crosstalk: return "crosstalk";
    case PanelCard::colours: return "colours";
    case PanelCard::pitch: break;
    }
    return "pitch";
}

/// Returns work(); puts a name before the message of its std::invalid_argument, unless that is a
/// RequestError, whose message has a name.
template <class Work> auto with_name(const std::string& name, Work work)
{
    try {
        return work();
    } catch (const RequestError&) {
        throw;
    } catch (const std::invalid_argument& error) {
        throw RequestError(name + ": " + error.what());
    }
}

bool has_round_lenses(const FrameMetadata& geometry)
{
    return geometry.sheet.arrangement != Arrangement::lenticular;
}

} // namespace

bool blends_light(Blend blend, const PanelImageOptions& options)
{
    const bool blends = blend.views == Neighbours::linear || blend.pixels == Neighbours::linear;
    return blends && !options.encoded;
}

Image over_black(const Image& picture, int bits, Encoding encoding)
{
    if (picture.channels == 3)
        return converted(picture, bits, encoding, false);
    Image opaque = bits == 8
                       ? make_image<std::uint8_t>(picture.width, picture.height, 3, encoding)
                       : make_image<std::uint16_t>(picture.width, picture.height, 3, encoding);
    const LinearReader reader(picture);
    for (int y = 0; y < picture.height; ++y)
        for (int x = 0; x < picture.width; ++x) {
            Colour c = reader(x, y);
            c.a = 1;
            store_linear(opaque, x, y, c);
        }
    return opaque;
}

PanelImages::PanelImages(const Panel& panel, PanelImageOptions options)
    : panel_(panel), options_(std::move(options)), geometry_(frame_geometry(panel))
{
    if (double(panel.film.width) * panel.film.height * 3 > most_samples)
        throw RequestError(options_.panel_name +
                           ": it has more pixels than this program makes at once");
}

std::vector<std::vector<std::string>> PanelImages::groups(
    const std::vector<std::string>& inputs) const
{
    if (inputs.size() == 1)
        return {inputs};
    // Files of single views, quilts and frames identify themselves; any other file is taken for a
    // view.
    bool alone = is_list_of_views(inputs[0]);
    if (!alone) {
        const auto views = ViewsReader(inputs[0], false).head().metadata;
        if (views && views->quilt->view)
            return {inputs};
        alone = views || quilt_in_name(inputs[0]) || FrameReader(inputs[0]).frame().metadata;
    }
    if (!alone)
        return {inputs};
    std::vector<std::vector<std::string>> each;
    for (const std::string& input : inputs)
        each.push_back({input});
    return each;
}

Image PanelImages::as_sent(Image upright) const
{
    return panel_.mirrored_x || panel_.mirrored_y
               ? mirrored(upright, panel_.mirrored_x, panel_.mirrored_y)
               : upright;
}

Frame PanelImages::frame_of_image(Image image, std::optional<Aperture> zone) const
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

FittedPicture PanelImages::fitted_to_panel(double shape) const
{
    return fitted(shape, shape_of(panel_.film), options_.fit);
}

/// Sets mapping_ for a picture's place on the panel, and for the eyes of its views (nothing: the
/// panel's own eyes). Keeps a mapping that is already right.
void PanelImages::map_picture(const FittedPicture& picture, std::optional<EyeGrid> eyes)
{
    if (picture.size.x != mapped_picture_.size.x || picture.size.y != mapped_picture_.size.y) {
        mapping_.reset();
        mapped_eyes_.reset();
    }
    mapped_picture_ = picture;
    if (!panel_.calibration)
        map_through_lenses(eyes);
    else if (!mapping_)
        mapping_ = mapping_of(*panel_.calibration, picture);
}

/// Sets mapping_ through the lenses for these eyes (nothing: the panel's own eyes).
void PanelImages::map_through_lenses(std::optional<EyeGrid> eyes)
{
    if (!eyes && !(std::isfinite(panel_.aperture.width) && std::isfinite(panel_.aperture.height)))
        throw RequestError(options_.panel_name +
                           ": no zone, however wide, fills its lenses; give aperture in its "
                           "description, or check thickness and pitch: they may be swapped");
    const double distance = panel_.aperture.distance;
    const EyeGrid requested = eyes.value_or(EyeGrid{viewing_zone(geometry_, distance), distance});
    if (mapped_eyes_ && requested.zone.x == mapped_eyes_->zone.x &&
        requested.zone.y == mapped_eyes_->zone.y && requested.distance == mapped_eyes_->distance)
        return;
    mapped_eyes_.reset();
    mapping_ = mapping_of(geometry_, requested, options_.threads, options_.progress("panel"),
                          mapped_picture_);
    if (!mapping_)
        throw Interrupted();
    mapped_eyes_ = requested;
}

const PanelMapping& PanelImages::mapping_for(const PanelPictures& pictures)
{
    const ViewGrid grid = pictures.grid;
    map_picture(pictures.fit, pictures.eyes);
    if (mapping_->up.rows > 0 && grid.count() > 1 && (grid.columns == 1 || grid.rows == 1))
        throw RequestError("round lenses show views across and up; " +
                           size_text(grid.columns, grid.rows) + " are given");
    return *mapping_;
}

Frame PanelImages::image_of(PanelPictures pictures)
{
    std::vector<Image>& views = pictures.views;
    views_ = pictures.is_image ? 0 : pictures.grid.count();
    if (pictures.is_image)
        return frame_of_image(std::move(views[0]), pictures.zone);
    const Blend blend = pictures.blend;
    const bool light = blends_light(blend, options_);
    const Encoding encoding = sample_bits(views[0]) > 16 ? Encoding() : views[0].encoding;
    const int bits = std::min(16, sample_bits(views[0]));
    for (Image& view : views) {
        view = prepared(view, light);
        stop_if_interrupted();
    }
    const ViewRaster raster(views, pictures.grid);
    Image image = panel_image(raster, panel_.film.width, panel_.film.height);
    interlace(image, raster, mapping_for(pictures), blend, options_.threads);
    if (!panel_.calibration) // a calibration's mapping is for the image as it is sent
        image = as_sent(std::move(image));
    return frame_of_image(light ? converted(image, bits, encoding, false) : std::move(image),
                          pictures.zone);
}

/// Reads the frame, with metadata, that a group consists of; nothing if the group has views.
std::optional<Frame> PanelImages::read_frame_of(const std::vector<std::string>& group) const
{
    const std::string& name = group[0];
    if (group.size() > 1 || quilt_in_name(name) || is_list_of_views(name) || is_video(name) ||
        read_views(name, true).metadata)
        return std::nullopt;
    Frame frame = read_frame(name);
    if (frame.metadata)
        return frame;
    if (!options_.views)
        throw RequestError(name + ": it says neither a frame's geometry nor its views; "
                                  "--views CxR would tell the views of a quilt");
    return std::nullopt;
}

/// Reads the views that a group consists of.
ViewInput PanelImages::read_views_of(const std::vector<std::string>& group) const
{
    ViewsRequest request;
    request.grid = options_.views;
    request.of_eyes = true;
    request.aspect = options_.aspect;
    request.video_time = options_.video_time;
    ViewInput views = read_given_views(group, request);
    if (options_.right_to_left)
        turn_right_to_left(views.views, directions_of(views.grid, geometry_.sheet));
    return views;
}

PanelPictures PanelImages::pictures_of_views(const std::string& name, ViewInput views) const
{
    if (views.metadata && !views.metadata->quilt->eyes)
        throw RequestError(name + ": it holds parallel views; a panel shows those of eyes "
                                  "(integral views --eyes), or the frame (integral views "
                                  "--to-frame)");
    PanelPictures pictures;
    if (views.metadata) {
        check_directions(name, *views.metadata, views.grid);
        pictures.eyes = eyes_before(panel_.film, *views.metadata, *views.metadata->quilt->eyes);
    }
    pictures.fit = fitted_to_panel(views.shape);
    if (pictures.fit.differs())
        options_.tell(name + ": " + fit_text(views, pictures.fit, "the panel"));
    pictures.views = std::move(views.views);
    pictures.grid = views.grid;
    pictures.blend = options_.blend;
    return pictures;
}

/// Throws RequestError if there are several views and missing_views gives a message.
void PanelImages::check_directions(const std::string& name, const FrameMetadata& frame,
                                   ViewGrid grid) const
{
    const auto what = missing_views(frame.sheet, geometry_.sheet);
    if (what && grid.count() > 1)
        throw RequestError(name + ": " + *what + "; --camera says what to render for the panel");
}

/// Passes through a frame that was rendered for the panel.
PanelPictures PanelImages::native_image(const std::string& name, const Frame& frame) const
{
    if (const auto what = other_zone(frame.metadata->aperture, panel_))
        options_.tell(name + ": " + *what);
    PanelPictures pictures;
    pictures.views = {as_sent(prepared(frame.image, false))};
    pictures.is_image = true;
    pictures.zone = frame.metadata->aperture;
    return pictures;
}

PanelPictures PanelImages::pictures_of_frame(const std::string& name, const Frame& frame) const
{
    const FrameMetadata& metadata = *frame.metadata;
    if (options_.aspect || options_.right_to_left)
        throw RequestError(name + ": it is a frame; --aspect and --right-to-left are for views");
    if (likeness(metadata, geometry_).all())
        return native_image(name, frame);
    const ViewGrid grid = directions_of(options_.views.value_or(natural_views(geometry_)),
                                        geometry_.sheet);
    check_directions(name, metadata, grid);
    if (const auto what = near_miss(metadata, geometry_))
        options_.tell(name + ": it is nearly a frame of this panel's own, but " + *what +
                      ": the image is made of " + counted(grid.count(), "view") +
                      " of it; --camera says what to render for the panel");
    PanelPictures pictures;
    pictures.fit = fitted_to_panel(shape_of(metadata.film));
    if (pictures.fit.differs())
        options_.tell(name + ": " + fit_text(pictures.fit, "the panel"));
    View view;
    set_view_size(view, pictures.fit.differs() ? metadata.film : geometry_.film,
                  longer_side_of_a_view);
    if (options_.width > 0) {
        view.width = options_.width;
        view.height = options_.height;
    }
    const double distance = metadata.aperture.distance;
    pictures.views = views_of_eyes(frame, grid, view, options_.threads, options_.progress("views"));
    pictures.grid = grid;
    pictures.eyes = eyes_before(panel_.film, metadata,
                                {viewing_zone(metadata, distance), distance});
    pictures.blend = options_.blend;
    return pictures;
}

Frame PanelImages::image_of_frame(const std::string& name, const Frame& frame)
{
    return image_of(pictures_of_frame(name, frame));
}

Frame PanelImages::image_of_views(const std::string& name, ViewInput views)
{
    return image_of(pictures_of_views(name, std::move(views)));
}

PanelPictures PanelImages::pictures_of(const std::vector<std::string>& group)
{
    return with_name(group[0], [&] {
        const auto frame = read_frame_of(group);
        stop_if_interrupted();
        return frame ? pictures_of_frame(group[0], *frame)
                     : pictures_of_views(group[0], read_views_of(group));
    });
}

PanelPictures PanelImages::pictures_of_video(const std::string& path) const
{
    const auto name = quilt_in_name(path);
    if (!name && !(options_.views && options_.aspect))
        throw RequestError(path +
                           ": its name does not end as a quilt's, as in film_qs8x6a0.75.mp4; "
                           "rename it, or give --views CxR and --aspect A");
    if (name && options_.views)
        throw RequestError(path + ": its name gives the views; leave --views out");
    if (options_.right_to_left)
        throw RequestError(path + ": --right-to-left does not work with a video");
    PanelPictures pictures;
    pictures.grid = name ? name->grid : *options_.views;
    pictures.fit = fitted_to_panel(options_.aspect.value_or(name ? name->aspect : 1));
    if (pictures.fit.differs())
        options_.tell(path + ": " + fit_text(pictures.fit, "the panel"));
    pictures.blend = options_.blend;
    return pictures;
}

Frame PanelImages::image_of(const std::vector<std::string>& group)
{
    return with_name(group[0], [&] { return image_of(pictures_of(group)); });
}

PanelPictures PanelImages::pictures_of_card(PanelCard card) const
{
    PanelPictures pictures;
    if (card == PanelCard::pitch) {
        pictures.views = {as_sent(options_.lens_card ? lens_card_picture(*options_.lens_card)
                                                     : pitch_card(panel_))};
        pictures.is_image = true;
        return pictures;
    }
    pictures.grid = options_.views.value_or(has_round_lenses(geometry_) ? ViewGrid{4, 4}
                                                                        : ViewGrid{card_views, 1});
    const int count = pictures.grid.count();
    const auto lit = options_.lit_view;
    if (lit && (*lit < 0 || *lit >= count))
        throw RequestError("--view " + std::to_string(*lit) + ": a whole number from 0 to " +
                           std::to_string(count - 1) + " is expected");
    pictures.views = card == PanelCard::views       ? view_number_card(count, shape_of(panel_.film))
                     : card == PanelCard::crosstalk ? crosstalk_card(count, lit)
                                                    : colour_card(count, lit.value_or(count / 2));
    pictures.blend = {Neighbours::nearest, Neighbours::nearest};
    return pictures;
}

PanelPictures PanelImages::pictures_of(PanelCard card)
{
    return with_name(std::string("--card ") + name_of(card),
                     [&] { return pictures_of_card(card); });
}

Frame PanelImages::card(PanelCard card)
{
    return with_name(std::string("--card ") + name_of(card),
                     [&] { return image_of(pictures_of_card(card)); });
}

} // namespace integral
