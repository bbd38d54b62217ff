// SPDX-License-Identifier: AGPL-3.0-or-later

// frame.h must be the first POV-Ray file included (pulls in platform config)
#include "backend/frame.h"
#include "backend/scene/integralcamera.h"
#include "backend/scene/camera.h"
#include "base/integralframe.h"
#include "base/integralmsgid.h"
#include "base/povmscpp.h"

#include <stdexcept>

// this must be the last file included
#include "base/povdebug.h"

namespace pov
{

static integral::Vec3 From_POV(const VECTOR v)
{
    return {v[X], v[Y], v[Z]};
}

std::shared_ptr<const integral::IntegralCamera> Make_Integral_Optics(const Camera& camera, int width, int height)
{
    const IntegralBlock& block = *camera.Integral;
    const integral::ViewFrame view = {From_POV(camera.Location), From_POV(camera.Direction),
                                      From_POV(camera.Right), From_POV(camera.Up),
                                      block.sheet_distance_ratio};
    return std::make_shared<integral::IntegralCamera>(integral::make_camera(block.parameters, view, width, height));
}

void Start_Integral_View(Camera& camera, int width, int height)
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
    }
    catch (const std::invalid_argument& problem)
    {
        throw POV_EXCEPTION(kParamErr, problem.what());
    }
    block->counts = std::make_shared<IntegralCounts>();
    camera.Integral = block;
    pov_base::IntegralFrame::Begin(*block->optics);
}

void Get_Integral_Statistics(const Camera& camera, POVMS_Object& statistics)
{
    if (!camera.Integral || !camera.Integral->counts)
        return;
    IntegralCounts& counts = *camera.Integral->counts;
    std::lock_guard<std::mutex> lock(counts.mutex);
    const auto total = [&](std::atomic<long long> IntegralTally::*count) {
        long long sum = 0;
        for (const IntegralTally& tally : counts.tallies)
            sum += tally.*count;
        return sum;
    };
    statistics.SetLong(kIntegralAttrib_FilmPoints, total(&IntegralTally::film_points));
    statistics.SetLong(kIntegralAttrib_Rays, total(&IntegralTally::rays));
    statistics.SetLong(kIntegralAttrib_Searched, total(&IntegralTally::searched));
    statistics.SetLong(kIntegralAttrib_OutsideAperture, total(&IntegralTally::outside_aperture));
    statistics.SetLong(kIntegralAttrib_TotalReflection, total(&IntegralTally::total_reflection));
    statistics.SetFloat(kIntegralAttrib_Seconds, pov_base::IntegralFrame::Seconds());
}

}
