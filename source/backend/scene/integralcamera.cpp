// SPDX-License-Identifier: AGPL-3.0-or-later

// frame.h must be the first POV-Ray file included (pulls in platform config)
#include "backend/frame.h"
#include "backend/scene/integralcamera.h"
#include "backend/render/integralaudit.h"
#include "backend/render/integraldepth.h"
#include "backend/render/integralsampling.h"
#include "backend/render/integralsurfaces.h"
#include "backend/scene/camera.h"
#include "backend/scene/view.h"
#include "base/integralframe.h"
#include "base/integralmsgid.h"
#include "base/integraloptions.h"
#include "base/povmscpp.h"

#include <algorithm>
#include <stdexcept>

// this must be the last file included
#include "base/povdebug.h"

namespace pov
{

std::shared_ptr<const integral::IntegralCamera> Make_Integral_Optics(const Camera& camera, int width, int height)
{
    const IntegralBlock& block = *camera.Integral;
    const integral::ViewFrame view = {From_POV(camera.Location), From_POV(camera.Direction),
                                      From_POV(camera.Right), From_POV(camera.Up),
                                      block.sheet_distance_ratio};
    return std::make_shared<integral::IntegralCamera>(integral::make_camera(block.parameters, view, width, height));
}

/// Patches enough that what they leave out is little against what so many samples miss. Of the samples at the sharpest edges a quarter will do:
/// few pixels have as many. Behind cylinders, whose beams are narrow and have small patches, fewer do.
static double Patches_In_Beam(const integral::IntegralCamera& optics, const pov_base::IntegralRenderOptions& given)
{
    const double least = optics.optics.sheet().arrangement == integral::Arrangement::lenticular ? 12 : 24, at_edges = 0.25;
    const double samples = std::max(double(optics.pixel_samples) * optics.beam_samples, at_edges * given.edge_samples);
    return given.patches_in_beam > 0 ? given.patches_in_beam : std::max(least, samples);
}

void Start_Integral_View(Camera& camera, int width, int height, POVMS_Object& options)
{
    if (!camera.Integral || !camera.Integral->integral)
    {
        pov_base::IntegralFrame::Forget();
        return;
    }
    auto block = std::make_shared<IntegralBlock>(*camera.Integral);
    try
    {
        block->optics = Make_Integral_Optics(camera, width, height);
        const pov_base::IntegralRenderOptions given = pov_base::Read_Integral_Options(options);
        block->sampler = std::make_shared<integral::PixelSampler>(*block->optics, given.seed);
        block->rows = given.rows;
        block->error = {given.audit, given.audit_share, given.output, given.error_picture};
        block->patches.reset();
        block->shares_dear_shading_only = given.sharing == pov_base::IntegralSharing::automatic;
        if (given.sharing == pov_base::IntegralSharing::on || (block->shares_dear_shading_only && given.antialias))
            block->patches = std::make_shared<IntegralPatches>(*block->optics, Patches_In_Beam(*block->optics, given));
        block->sampling.reset();
        if (given.antialias && given.light_field)
            block->sampling = std::make_shared<IntegralSampling>(*block->optics, given.rows, given.block_side, given.most_memory);
        block->depth.reset();
        if (!given.depth_picture.empty())
            block->depth = std::make_shared<IntegralDepth>(*block, given.depth_picture);
        // the halves know nothing of the samples that anti-aliasing adds, and make no picture
        block->audit.reset();
        if (given.audit && (given.antialias || !given.error_picture.empty() || !block->sampler->halves_tell_error()))
            block->audit = std::make_shared<IntegralAudit>(*block, given.seed);
    }
    catch (const std::invalid_argument& problem)
    {
        throw POV_EXCEPTION(kParamErr, problem.what());
    }
    block->counts = std::make_shared<IntegralCounts>();
    camera.Integral = block;
    pov_base::IntegralFrame::Begin(*block->optics);
}

/// The error of the frame, as far as it was asked for and there is a picture to tell it by.
static std::optional<integral::ErrorEstimate> Error_Of(const IntegralBlock& block)
{
    if (block.audit)
        return block.audit->Result();
    integral::ErrorSums sums;
    for (const IntegralTally& tally : block.counts->tallies)
        sums.add(tally.errors);
    auto error = integral::estimate(sums, integral::ErrorMethod::split_halves);
    if (error)
    {
        error->lit_pixels = sums.pixels;
        error->samples = block.optics->pixel_samples * block.optics->beam_samples;
    }
    return error;
}

int Integral_Final_Tasks(const Camera& camera, int threads)
{
    return camera.Integral ? threads * ((camera.Integral->depth ? 1 : 0) + (camera.Integral->audit ? 1 : 0)) : 0;
}

RenderTask *New_Integral_Final_Task(ViewData *view, int index)
{
    const IntegralBlock& block = *view->GetCamera().Integral;
    // every other one, if there are both kinds
    if (block.depth && (index % 2 == 0 || !block.audit))
        return new IntegralDepthTask(view);
    return new IntegralAuditTask(view);
}

void Get_Integral_Statistics(const Camera& camera, POVMS_Object& statistics)
{
    if (!camera.Integral || !camera.Integral->counts)
        return;
    IntegralCounts& counts = *camera.Integral->counts;
    std::lock_guard<std::mutex> lock(counts.mutex);
    const auto set_total = [&](POVMSType key, OwnCount IntegralTally::*count) {
        long long sum = 0;
        for (const IntegralTally& tally : counts.tallies)
            sum += (tally.*count).Get();
        statistics.SetLong(key, sum);
    };
    set_total(kIntegralAttrib_FilmPoints, &IntegralTally::film_points);
    set_total(kIntegralAttrib_Imaged, &IntegralTally::imaged);
    set_total(kIntegralAttrib_Searched, &IntegralTally::searched);
    set_total(kIntegralAttrib_OutsideAperture, &IntegralTally::outside_aperture);
    set_total(kIntegralAttrib_TotalReflection, &IntegralTally::total_reflection);
    set_total(kIntegralAttrib_Rays, &IntegralTally::rays);
    set_total(kIntegralAttrib_ContainerSearches, &IntegralTally::container_searches);
    set_total(kIntegralAttrib_SharedShadings, &IntegralTally::shared_shadings);
    set_total(kIntegralAttrib_PatchShadings, &IntegralTally::patch_shadings);
    statistics.SetInt(kIntegralAttrib_Containers, counts.containers);
    statistics.SetInt(kIntegralAttrib_Objects, counts.objects);

    const auto error = Error_Of(*camera.Integral);
    pov_base::IntegralFrame::End(error);
    statistics.SetFloat(kIntegralAttrib_Seconds, pov_base::IntegralFrame::Seconds());
    if (camera.Integral->audit && camera.Integral->audit->Picture_Failed())
        statistics.SetString(kIntegralAttrib_ErrorPicture, camera.Integral->error.picture.c_str());
    if (camera.Integral->depth && !camera.Integral->depth->Write())
        statistics.SetString(kIntegralAttrib_DepthPicture, camera.Integral->depth->File().c_str());
    if (error)
    {
        statistics.SetFloat(kIntegralAttrib_Error, error->rms);
        statistics.SetFloat(kIntegralAttrib_ErrorLow, error->low);
        statistics.SetFloat(kIntegralAttrib_ErrorHigh, error->high);
        statistics.SetFloat(kIntegralAttrib_ErrorSeconds, error->seconds);
        statistics.SetLong(kIntegralAttrib_ErrorPixels, error->pixels);
        statistics.SetLong(kIntegralAttrib_ErrorLitPixels, error->lit_pixels);
        statistics.SetInt(kIntegralAttrib_ErrorSamples, error->samples);
        statistics.SetInt(kIntegralAttrib_ErrorMethod, int(error->method));
    }
}

}
