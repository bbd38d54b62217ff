// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/compare/figures_json.h"

#include "integral/compare/seen.h"
#include "integral/frame/names.h"

namespace integral {

Json figures_json(const Comparison& c)
{
    Json json = {{"rmse", c.rmse}, // NaN is written as null, too
                 {"psnr", c.psnr}, // infinity is written as null
                 {"ssim", c.ssim},
                 {"largest_difference", c.largest_difference},
                 {"within_two", c.within_two},
                 {"differing", c.differing},
                 {"channel_tolerance", c.channel_tolerance},
                 {"flip", nullptr},
                 {"encoding", name_of(c.encoding.kind)},
                 {"worst_micro_image", nullptr},
                 {"not_finite",
                  {{"equal_pixels", c.not_finite.equal},
                   {"unequal_pixels", c.not_finite.unequal},
                   {"first_unequal", nullptr}}}};
    if (c.flip) {
        const FlipFigures& flip = *c.flip;
        json["flip"] = {
            {"mean", flip.mean},
            {"weighted_quartiles", {flip.quartiles[0], flip.quartiles[1], flip.quartiles[2]}},
            {"greatest", flip.greatest},
            {"greatest_at", {flip.x, flip.y}},
            {"ppd", flip.settings.ppd},
            {"exposures", nullptr}};
        if (const auto& exposures = flip.settings.exposures)
            json["flip"]["exposures"] = {{"start", exposures->start},
                                         {"stop", exposures->stop},
                                         {"count", exposures->count}};
    }
    if (c.not_finite.unequal > 0)
        json["not_finite"]["first_unequal"] = {c.not_finite.x, c.not_finite.y};
    if (c.worst)
        json["worst_micro_image"] = {{"lens", {c.worst->lens.i, c.worst->lens.j}},
                                     {"pole_mm", {c.worst->pole.x, c.worst->pole.y}},
                                     {"rmse", c.worst->rmse}};
    if (c.seen) {
        const SeenFigures& seen = *c.seen;
        Json eyes = Json::array();
        for (const SeenByEye& eye : seen.eyes)
            eyes.push_back({{"eye_mm", {eye.eye.x, eye.eye.y, eye.eye.z}},
                            {"figures", figures_json(eye.figures)}});
        json["seen"] = {{"figures", figures_json(seen.overall)},
                        {"worst_eye", seen.worst},
                        {"worst_place_mm", {seen.place.x, seen.place.y}},
                        {"parallax", nullptr},
                        {"eyes", eyes}};
        if (const auto& parallax = seen.parallax)
            json["seen"]["parallax"] = {{"greatest_mm", parallax->greatest},
                                        {"place_mm", {parallax->place.x, parallax->place.y}},
                                        {"median_mm", parallax->median},
                                        {"greatest_depth_mm", parallax->greatest_depth},
                                        {"median_depth_mm", parallax->median_depth},
                                        {"details", parallax->details}};
    }
    return json;
}

} // namespace integral
