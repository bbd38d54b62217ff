// SPDX-License-Identifier: AGPL-3.0-or-later

// frame.h must be the first POV-Ray file included (pulls in platform config)
#include "backend/frame.h"
#include "backend/render/integralsampling.h"
#include "backend/scene/camera.h"
#include "backend/scene/integralcamera.h"
#include "backend/scene/scene.h"
#include "backend/scene/view.h"

#include <algorithm>
#include <numeric>

// this must be the last file included
#include "base/povdebug.h"

namespace pov
{

namespace
{

enum Part
{
    lent_part,    ///< comes first because it needs the greatest alignment
    lenders_part, ///< follows lent_part, as BeamSamples requires
    colours_part,
    first_part,
    reconstruction_part
};

std::vector<std::size_t> Parts(bool reconstructs)
{
    std::vector<std::size_t> parts = {0, 0, sizeof(Colour), integral::LightFieldImage::bytes_a_pixel};
    if (reconstructs)
    {
        parts[lent_part] = integral::BeamSamples::bytes_of_pixels;
        parts[lenders_part] = integral::BeamSamples::bytes_of_lenders;
        parts.push_back(integral::Reconstruction::bytes_a_pixel);
    }
    return parts;
}

}

static integral::PassRows Pass_Rows(const integral::IntegralCamera& camera,
                                    const std::optional<integral::QuiltGeometry>& quilt, int side,
                                    bool reconstructs)
{
    return quilt ? integral::PassRows(*quilt, side, reconstructs)
                 : integral::PassRows(camera.optics.sheet(), camera.film, side, reconstructs);
}

IntegralSampling::IntegralSampling(const integral::IntegralCamera& camera,
                                   const std::optional<integral::QuiltGeometry>& quilt,
                                   const pov_base::IntegralRows& rows, int side, bool reconstructs,
                                   double least_error, bool displayed)
    : rows(rows),
      width(camera.film.width),
      height(camera.film.height),
      side(side),
      reconstructs(reconstructs && (quilt ? integral::ViewReuse::pays(*quilt)
                                          : integral::Reconstruction::possible(camera))),
      displayed(displayed),
      pass_rows(Pass_Rows(camera, quilt, side, this->reconstructs)),
      parts(Parts(this->reconstructs)),
      memory(std::make_shared<pov_base::IntegralMemory>(Begin_Of(parts.size()))),
      first(quilt ? integral::LightFieldImage(width, height, Part(first_part))
                  : integral::LightFieldImage(camera, Part(first_part))),
      colours(static_cast<Colour *>(Part(colours_part).get()))
{
    if (!this->reconstructs)
        return;
    if (quilt)
    {
        const integral::ViewReuse reuse(*quilt);
        lent.reset(new integral::BeamSamples(width, height, reuse.most_tilt(),
                                             reuse.footprint().furthest_depth(), Part(lent_part)));
        reconstructor.reset(new integral::Reconstruction(*quilt, first, *lent, least_error,
                                                         Part(reconstruction_part)));
        filter.reset(new integral::NoiseFilter(first));
        return;
    }
    lent.reset(new integral::BeamSamples(camera, Part(lent_part)));
    reconstructor.reset(
        new integral::Reconstruction(camera, first, *lent, least_error, Part(reconstruction_part)));
    filter.reset(new integral::NoiseFilter(camera, first));
}

/// Returns the first byte of a part of the memory; for the number of parts, the size of the memory.
std::size_t IntegralSampling::Begin_Of(std::size_t part) const
{
    return std::accumulate(parts.begin(), parts.begin() + part, std::size_t(0)) * width * height;
}

std::shared_ptr<void> IntegralSampling::Part(std::size_t number) const
{
    return {memory, memory->Data() + Begin_Of(number)};
}

void IntegralSampling::Release()
{
    std::lock_guard<std::mutex> lock(mutex);
    int lent_from = height, from = height;
    for (int pass = 0; pass <= Last_Pass(); pass++)
    {
        from = std::min(from, schedule->first_needed(pass));
        if (pass <= estimation)
            lent_from = std::min(lent_from, schedule->first_needed(pass));
    }
    for (std::size_t part = 0; part < parts.size(); part++)
    {
        const bool of_samples = part == lent_part || part == lenders_part;
        const std::size_t rows = std::size_t(std::max(0, of_samples ? lent_from : from)),
                          end = Begin_Of(part) + rows * width * parts[part];
        if (end > released[part])
            released[part] = memory->Release(released[part], end);
    }
    if (lent)
        lent->forget_above(lent_from - side); // blocks are at most `side` rows high
}

void IntegralSampling::Begin(ViewData& view)
{
    std::lock_guard<std::mutex> lock(mutex);
    if (schedule)
        return;
    area = view.GetRenderArea();
    POVRect block;
    unsigned int serial;
    while (view.GetNextRectangle(block, serial))
        serials[{block.left, block.top}] = serial;
    Make_Schedule();
}

void IntegralSampling::Make_Schedule()
{
    std::vector<bool> requested(area.GetHeight()), counting(area.GetHeight());
    for (const auto& block : serials)
        for (int y = block.first.second; y < block.first.second + side && y <= int(area.bottom);
             y++)
        {
            requested[y - area.top] = true;
            counting[y - area.top] = rows.Have(y);
        }
    scheduled = pass_rows.passes(requested, counting);
    schedule.reset(new integral::PassSchedule(
        {int(area.left), int(area.top), int(area.right), int(area.bottom)}, side, scheduled));
    for (std::size_t part = 0; part < parts.size(); part++)
        released.push_back(Begin_Of(part));
}

bool IntegralSampling::Is_Wanted(const integral::PictureBlock& block, unsigned int& serial) const
{
    const auto found = serials.find({block.left, block.top});
    if (found == serials.end())
        return false;
    serial = found->second;
    return true;
}

bool IntegralSampling::Reports(const integral::PictureBlock& block) const
{
    return serials.count({block.left, Whole(block).top}) > 0;
}

integral::PictureBlock IntegralSampling::Whole(const integral::PictureBlock& part) const
{
    const int top = int(area.top) + (part.top - int(area.top)) / side * side;
    return {part.left, top, part.right, std::min(top + side - 1, int(area.bottom))};
}

float IntegralSampling::Progress(const integral::PictureBlock& block) const
{
    const auto part = [&](Pass pass)
    {
        const std::vector<bool>& works = scheduled[pass].rows;
        return float(std::count(works.begin() + (block.top - area.top),
                                works.begin() + (block.bottom - area.top) + 1, true)) /
               (block.bottom - block.top + 1);
    };
    return sampling_share * part(sampling) + refinement_share * part(refinement);
}

}
