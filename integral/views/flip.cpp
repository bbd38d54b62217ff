// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/views/flip.h"

#include "integral/base/number_text.h"
#include "integral/frame/geometry_difference.h"
#include "integral/io/frame_rows.h"
#include "integral/io/image_file.h"
#include "integral/replay/arrange.h"
#include "integral/views/deghost.h"
#include "integral/views/made_frame.h"

#include <algorithm>
#include <stdexcept>

namespace integral {
namespace {

struct Inputs {
    std::vector<SharedPicture> pictures;
    std::vector<std::optional<Vec2>> phases; ///< of the pictures (RenderRecord::phase)
    FrameMetadata geometry;
    Image form; ///< of the frame
};

/// The requested geometry, or else the geometry of the frames among the pictures.
FrameMetadata geometry_of(const PictureFlip& flip)
{
    std::optional<FrameMetadata> found;
    std::string first;
    for (const std::string& path : flip.pictures) {
        const FrameReader file(path);
        const auto& metadata = file.frame().metadata;
        if (!metadata)
            continue;
        file.refuse_projection();
        const FrameMetadata& requested = found           ? *found
                                         : flip.geometry ? *flip.geometry
                                                         : *metadata;
        if (const auto difference = geometry_difference(*metadata, requested))
            throw std::invalid_argument(
                path + ": its " + difference->path + " is " + difference->first + ", and that of " +
                (found ? first : "--sheet and the options") + " is " + difference->second +
                "; render all frames for one sheet, at one size");
        if (!found)
            first = path;
        found = metadata;
    }
    if (flip.geometry)
        return *flip.geometry;
    if (!found)
        throw std::invalid_argument("no picture is a frame, and no sheet is given");
    return *found;
}

/// Reads the pictures, each made small enough for the lenses.
Inputs read_pictures(const PictureFlip& flip)
{
    Inputs all;
    all.geometry = geometry_of(flip);
    FrameMetadata& geometry = all.geometry;
    int bits = 8;
    bool transparent = false;
    for (const std::string& path : flip.pictures) {
        stop_if_interrupted();
        Frame frame = read_frame(path);
        SharedPicture picture;
        picture.is_frame = frame.metadata.has_value();
        all.phases.push_back(picture.is_frame && frame.metadata->render
                                 ? frame.metadata->render->phase
                                 : std::nullopt);
        bits = std::max(bits, sample_bits(frame.image));
        if (all.pictures.empty())
            all.form = form_of(frame.image);
        transparent = transparent || (picture.is_frame && frame.image.channels == 4);
        if (picture.is_frame) {
            picture.image = std::move(frame.image);
        } else {
            picture.fit = fitted(double(frame.image.width) / frame.image.height,
                                 shape_of(geometry.film), flip.fit);
            if (picture.fit.differs())
                flip.tell(path + ": " + fit_text(picture.fit, "the film"));
            picture.image = for_lenses(frame.image, picture.fit, geometry, flip.threads);
        }
        all.pictures.push_back(std::move(picture));
    }
    bits = flip.bits.value_or(bits);
    all.form = form_of(bits, geometry.film.width, geometry.film.height, transparent ? 4 : 3,
                       encoding_of_made(bits, all.form));
    remove_scene(geometry);
    geometry.encoding = all.form.encoding;
    return all;
}

/// The pictures' indices from left to right, or from below upwards.
std::vector<int> order_of(const PictureFlip& flip)
{
    const int count = int(flip.pictures.size());
    std::vector<int> order;
    for (int k = 0; k < count; ++k)
        order.push_back(k);
    if (flip.there_and_back)
        for (int k = count - 2; k > 0; --k)
            order.push_back(k);
    if (flip.reverse)
        std::reverse(order.begin(), order.end());
    return order;
}

ZoneShares shares_of(const PictureFlip& flip, const std::vector<int>& order)
{
    if (!flip.shares.empty() && flip.shares.size() != flip.pictures.size())
        throw std::invalid_argument("there are " + std::to_string(flip.shares.size()) +
                                    " shares for " + std::to_string(flip.pictures.size()) +
                                    " pictures");
    ZoneDivision division;
    for (const int picture : order)
        division.shares.push_back(flip.shares.empty() ? 1 : flip.shares[picture]);
    division.transition = flip.transition;
    division.loop = flip.loop;
    return ZoneShares(division);
}

/// The part of the zone that shows a picture, with transitions: from x to y. If it has several
/// shares, the part contains them all.
Vec2 part_of_picture(int picture, const std::vector<int>& order, const ZoneShares& shares)
{
    Vec2 part{1, 0};
    for (int at = 0; at < shares.count(); ++at)
        if (order[at] == picture)
            part = {std::min(part.x, shares.border(at) - shares.half_transition(at)),
                    std::max(part.y, shares.border(at + 1) + shares.half_transition(at + 1))};
    return part;
}

/// Throws std::invalid_argument if a frame was rendered for a part of the zone (Integral_Phase)
/// that does not contain its share. `upwards`: the flip divides the zone upwards, the frames
/// sideways.
void check_phases(const PictureFlip& flip, const Inputs& inputs, const std::vector<int>& order,
                  const ZoneShares& shares, bool upwards)
{
    constexpr double rounding = 1e-3; // less than the pixel by which a part is wider than requested
    for (std::size_t k = 0; k < flip.pictures.size(); ++k) {
        if (!inputs.phases[k])
            continue;
        const Vec2 phase = *inputs.phases[k], part = part_of_picture(int(k), order, shares);
        if (!upwards && phase.x <= part.x + rounding && phase.y >= part.y - rounding)
            continue;
        const auto text = [](Vec2 from_to) {
            return with_digits(from_to.x, 3) + "," + with_digits(from_to.y, 3);
        };
        const std::string shown = flip.pictures[k] + ": it was rendered for the part " +
                                  text(phase) + " of the viewing zone";
        if (upwards)
            throw std::invalid_argument(shown + " from left to right, and --upwards divides the "
                                                "zone upwards; render it without Integral_Phase");
        if (part.x < -rounding || part.y > 1 + rounding)
            throw std::invalid_argument(shown + ", and with --loop its share is at both edges; "
                                                "render it without Integral_Phase");
        // The advice is rounded outwards.
        const auto rounded = [](double place, double up) {
            return std::clamp(std::floor(place * 1000 + up) / 1000, 0.0, 1.0);
        };
        const Vec2 needed{rounded(part.x, 1e-6), rounded(part.y, 1 - 1e-6)};
        throw std::invalid_argument(shown + ", and its share is " + text(needed) +
                                    "; render it with Integral_Phase=" + text(needed));
    }
}

/// The direction in which the zone is divided. Throws std::invalid_argument if `upwards` is set for
/// lenses that show pictures sideways alone.
ZoneAxis axis_of(const PictureFlip& flip, const LensSheet& sheet)
{
    const ZoneAxis own = zone_axis(sheet);
    if (!flip.upwards || own == ZoneAxis::upwards)
        return own;
    if (sheet.arrangement == Arrangement::lenticular)
        throw std::invalid_argument("upright lenticular lenses show pictures sideways alone; a "
                                    "slant of 90 degrees lays them across");
    return ZoneAxis::upwards;
}

/// A frame without ghosts, as write_drawn_rows takes it.
class DeghostedFrame {
public:
    DeghostedFrame(const FrameOfShares& frame, Deghosting deghosting, const Film& film)
        : frame_(frame), deghosting_(std::move(deghosting)), film_(film)
    {
    }

    bool draw(int first, Image& band, int threads, const Progress& progress) const
    {
        const int above = std::min(deghosting_.reach(), first),
                  below = std::min(deghosting_.reach(), film_.height - first - band.height);
        Image light = make_image<float>(band.width, above + band.height + below, band.channels,
                                        Encoding{Encoding::Kind::linear});
        if (!frame_.draw(first - above, light, threads, progress))
            return false;
        deghosting_.apply(light, threads);
        const LinearReader linear(light);
        return for_each_row(band.height, threads, [&](int y) {
            for (int x = 0; x < band.width; ++x)
                store_linear(band, x, y, linear(x, above + y));
        });
    }

private:
    const FrameOfShares& frame_;
    Deghosting deghosting_;
    Film film_;
};

} // namespace

ZoneView write_flip(const PictureFlip& flip, const Progress& progress)
{
    const std::vector<int> order = order_of(flip);
    const ZoneShares shares = shares_of(flip, order);
    const Inputs inputs = read_pictures(flip);
    const FrameMetadata& geometry = inputs.geometry;
    const ZoneAxis axis = axis_of(flip, geometry.sheet);
    check_phases(flip, inputs, order, shares, axis != zone_axis(geometry.sheet));
    Frame form{inputs.form, std::nullopt};
    set_metadata(form, geometry);
    const FrameOfShares frame(inputs.pictures, order, geometry, shares, axis);
    if (flip.deghost > 0)
        write_drawn_rows(
            flip.output,
            DeghostedFrame(frame, Deghosting(geometry, flip.deghost, axis), geometry.film), form,
            flip.threads, progress);
    else
        write_drawn_rows(flip.output, frame, form, flip.threads, progress);
    return zone_view(geometry, shares, order, int(flip.pictures.size()), axis, flip.deghost,
                     flip.threads);
}

} // namespace integral
