// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/views/flip.h"

#include "integral/base/number_text.h"
#include "integral/frame/geometry_difference.h"
#include "integral/io/frame_rows.h"
#include "integral/io/image_file.h"
#include "integral/replay/arrange.h"
#include "integral/views/made_frame.h"

#include <algorithm>
#include <stdexcept>

namespace integral {
namespace {

struct Inputs {
    std::vector<SharedPicture> pictures;
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

/// Throws std::invalid_argument if a frame was rendered for a part of the zone (Integral_Phase)
/// that does not contain its share.
void check_phases(const PictureFlip& flip, const std::vector<int>& order, const ZoneShares& shares,
                  bool upwards)
{
    for (std::size_t k = 0; k < flip.pictures.size(); ++k) {
        const FrameReader file(flip.pictures[k]);
        const auto& metadata = file.frame().metadata;
        if (!metadata || !metadata->render || !metadata->render->phase)
            continue;
        const Vec2 phase = *metadata->render->phase;
        for (int at = 0; at < shares.count(); ++at) {
            if (order[at] != int(k))
                continue;
            const double first = shares.border(at) - shares.half_transition(at),
                         last = shares.border(at + 1) + shares.half_transition(at + 1);
            constexpr double rounding = 1e-6;
            if (!upwards && phase.x <= first + rounding && phase.y >= last - rounding)
                continue;
            const auto text = [](double from, double to) {
                return with_digits(from, 4) + "," + with_digits(to, 4);
            };
            const bool whole = upwards || first < -rounding || last > 1 + rounding;
            throw std::invalid_argument(
                flip.pictures[k] + ": it shows the part " + text(phase.x, phase.y) +
                " of the viewing zone, and its share with the transitions is " +
                (whole
                     ? std::string("another one; render it without Integral_Phase")
                     : text(first, last) + "; render it with Integral_Phase=" + text(first, last)));
        }
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

} // namespace

ZoneView write_flip(const PictureFlip& flip, const Progress& progress)
{
    const std::vector<int> order = order_of(flip);
    const ZoneShares shares = shares_of(flip, order);
    const Inputs inputs = read_pictures(flip);
    const FrameMetadata& geometry = inputs.geometry;
    const ZoneAxis axis = axis_of(flip, geometry.sheet);
    check_phases(flip, order, shares, axis != zone_axis(geometry.sheet));
    Frame form{inputs.form, std::nullopt};
    set_metadata(form, geometry);
    write_drawn_rows(flip.output, FrameOfShares(inputs.pictures, order, geometry, shares, axis),
                     form, flip.threads, progress);
    return zone_view(geometry, shares, order, int(flip.pictures.size()), axis, flip.threads);
}

} // namespace integral
