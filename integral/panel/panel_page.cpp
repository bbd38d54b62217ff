// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/panel/panel_page.h"

#include "build/generated/page_texts.h" // panel_page_html and its like
#include "integral/base/file_bytes.h"
#include "integral/base/json.h"
#include "integral/io/html_page.h"
#include "integral/io/markup.h"
#include "integral/panel/blended_values.h"
#include "integral/views/quilt.h"

namespace integral {
namespace {

constexpr int channels = 3;

/// The pictures as 8 bits over black, with a notice if that changes them.
std::vector<Image> page_pictures(const PanelImages& images, const PanelPictures& pictures,
                                 const std::string& name)
{
    const Image& first = pictures.views[0];
    if (sample_bits(first) > 8 || first.channels > channels)
        images.options().tell(name + ": its pictures are converted to 8 bits over black, which "
                                     "is what a page can show");
    std::vector<Image> converted;
    for (const Image& view : pictures.views)
        converted.push_back(
            over_black(view, 8, sample_bits(view) > 8 ? Encoding() : view.encoding));
    return converted;
}

/// A table of phases as a picture: from the top, all first bytes of the phases, all second bytes
/// and so on. Red, green and blue of a pixel have the phases of the panel's subpixels.
Image picture_of(const PhaseTable& table)
{
    const bool whole = !table.phase32.empty();
    const int planes = whole ? 4 : 2, width = std::max(1, table.columns / channels);
    Image picture = make_image<std::uint8_t>(width, planes * table.rows, channels, Encoding());
    auto& samples = std::get<std::vector<std::uint8_t>>(picture.samples);
    const std::size_t plane = std::size_t(width) * table.rows * channels;
    for (std::size_t i = 0; i < plane; ++i) {
        const std::size_t at = table.columns == 1 ? i / channels : i;
        const std::uint32_t phase = whole ? table.phase32[at] : table.phase16[at];
        for (int k = 0; k < planes; ++k)
            samples[k * plane + i] = std::uint8_t(phase >> 8 * (planes - 1 - k));
    }
    return picture;
}

/// The page's data of a table; its picture is in `uri`.
Json json_of(const PhaseTable& table)
{
    if (table.rows == 0)
        return nullptr;
    return {{"size", {std::max(1, table.columns / channels), table.rows}},
            {"planes", table.phase32.empty() ? 2 : 4},
            {"picture", picture_uri(picture_of(table))}};
}

/// The phases that are added to those across, as a table.
PhaseTable shift_of(const PanelMapping& mapping)
{
    PhaseTable table;
    table.columns = 1;
    table.phase32 = mapping.across.shift;
    table.rows = int(table.phase32.size());
    return table;
}

/// The values that are blended for each stored value of 8 bits, and for each stored value the least
/// blended value that becomes it.
Json light_of(const PanelImages& images, const Blend& blend, Encoding encoding)
{
    std::vector<int> light(256), least;
    if (!blends_light(blend, images.options())) {
        for (int value = 0; value < 256; ++value)
            light[value] = value;
        return {{"light", light}, {"least", light}};
    }
    const BlendedValues values = blended_values(encoding);
    light.assign(values.light.begin(), values.light.end());
    for (int value = 0; value < int(values.stored.size()); ++value)
        while (int(least.size()) <= values.stored[std::size_t(value)])
            least.push_back(value);
    return {{"light", light}, {"least", least}};
}

/// The mapping by which each pixel of the panel shows the same pixel of one picture.
PanelMapping whole_picture(const Film& film)
{
    LookingGlassCalibration any; // its only view is seen from everywhere
    any.width = film.width;
    any.height = film.height;
    any.pitch = any.slope = any.dpi = 1;
    return mapping_of(any);
}

/// The quilt in a page. A video's sizes are 0: the page finds them.
struct PageQuilt {
    std::string uri; ///< the picture or video, as a data URI
    ViewGrid grid;
    int width = 0, height = 0, view_width = 0, view_height = 0; ///< pixels
};

/// A page for a quilt that is made of the pictures, or for a video.
std::string page_of(PanelImages& images, const PanelPictures& pictures, const std::string& name,
                    Encoding encoding, const PageQuilt& quilt)
{
    const Panel& panel = images.panel();
    const PanelMapping mapping = pictures.is_image ? whole_picture(panel.film)
                                                   : images.mapping_for(pictures);
    const bool round = mapping.up.rows > 0;
    const ViewGrid grid = pictures.grid;
    const Blend blend = pictures.is_image ? Blend{Neighbours::nearest, Neighbours::nearest}
                                          : pictures.blend;
    const bool mirrors = !panel.calibration && !pictures.is_image;
    const Json data = {
        {"name", name},
        {"panel", panel.name},
        {"size", {mapping.width, mapping.height}},
        {"grid", {quilt.grid.columns, quilt.grid.rows}},
        {"picture_size", {quilt.width, quilt.height}},
        {"view", {quilt.view_width, quilt.view_height}},
        {"views", {round ? grid.columns : grid.count(), round ? grid.rows : 1}},
        {"blends", {blend.views == Neighbours::linear, blend.pixels == Neighbours::linear}},
        {"is_separable", mapping.is_separable()},
        {"has_unseen", mapping.has_unseen},
        {"mirrored", {mirrors && panel.mirrored_x, mirrors && panel.mirrored_y}},
        {"shown",
         {mapping.left, mapping.top, mapping.width - mapping.right,
          mapping.height - mapping.bottom}},
        {"values", light_of(images, blend, encoding)},
        {"tables",
         {{"across", json_of(mapping.across)},
          {"shift", json_of(shift_of(mapping))},
          {"up", json_of(mapping.up)},
          {"x", json_of(mapping.x)},
          {"y", json_of(mapping.y)}}}};
    return filled_template(panel_page_html,
                           {{"DATA", json_within_html(data.dump())},
                            {"PICTURE", quilt.uri},
                            {"SHADER", panel_page_glsl},
                            {"SCRIPT", std::string(replay_drawing_js) + panel_page_js}});
}

/// The quilt of `count` views whose longer side is shortest; graphics have a longest side. The
/// views have the same numbers in all quilts.
ViewGrid compact_grid(int count, int view_width, int view_height)
{
    ViewGrid best{count, 1};
    const auto longer_side = [&](ViewGrid grid) {
        return std::max(grid.columns * view_width, grid.rows * view_height);
    };
    for (int rows = 2; rows <= count; ++rows)
        if (const ViewGrid grid{count / rows, rows};
            count % rows == 0 && longer_side(grid) < longer_side(best))
            best = grid;
    return best;
}

} // namespace

std::string panel_page(PanelImages& images, const PanelPictures& pictures, const std::string& name)
{
    std::vector<Image> views = page_pictures(images, pictures, name);
    const Encoding encoding = views[0].encoding;
    PageQuilt quilt;
    quilt.view_width = views[0].width;
    quilt.view_height = views[0].height;
    quilt.grid = compact_grid(int(views.size()), quilt.view_width, quilt.view_height);
    const Image picture = quilt_of_views(std::move(views), quilt.grid);
    quilt.width = picture.width;
    quilt.height = picture.height;
    quilt.uri = picture_uri(picture);
    return page_of(images, pictures, name, encoding, quilt);
}

std::string panel_video_page(PanelImages& images, const std::string& path)
{
    const PanelPictures pictures = images.pictures_of_video(path);
    PageQuilt quilt;
    quilt.uri = "data:video/" + extension_of(path) + ";base64," + base64(read_file(path));
    quilt.grid = pictures.grid;
    return page_of(images, pictures, path, Encoding(), quilt);
}

} // namespace integral
