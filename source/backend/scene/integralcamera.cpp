// SPDX-License-Identifier: AGPL-3.0-or-later

// frame.h must be the first POV-Ray file included (pulls in platform config)
#include "backend/frame.h"
#include "backend/scene/integralcamera.h"
#include "backend/render/integralaudit.h"
#include "backend/render/integraldepth.h"
#include "backend/render/integralsampling.h"
#include "backend/render/integralstripes.h"
#include "backend/lighting/integralsharedambient.h"
#include "backend/render/integralshading.h"
#include "backend/scene/camera.h"
#include "backend/scene/objects.h"
#include "backend/scene/scene.h"
#include "backend/scene/view.h"
#include "base/integralframe.h"
#include "base/integralmsgid.h"
#include "base/integraloptions.h"
#include "base/povmscpp.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

// this must be the last file included
#include "base/povdebug.h"

namespace pov
{

/// The perspective camera that the integral one starts from. An orthographic camera is replaced by
/// a perspective one with the same window in the sheet's plane.
static integral::ViewFrame View_Of(const Camera& camera)
{
    const IntegralStatement& statement = *camera.Integral;
    const double window = statement.orthographic ? 1 / statement.sheet_distance_ratio : 1;
    return {From_POV(camera.Location), From_POV(camera.Direction), window * From_POV(camera.Right),
            window * From_POV(camera.Up), statement.sheet_distance_ratio};
}

std::shared_ptr<const integral::IntegralCamera> Make_Integral_Optics(const Camera& camera,
                                                                     int width, int height)
{
    integral::CameraParameters parameters = camera.Integral->parameters;
    if (camera.Integral->draft_pitch)
        parameters.film.pixel_pitch = *camera.Integral->draft_pitch;
    return std::make_shared<integral::IntegralCamera>(
        integral::make_camera(parameters, View_Of(camera), width, height));
}

double Integral_Scene_Distance(const Camera& camera)
{
    return integral::scene_viewing_distance(View_Of(camera),
                                            camera.Integral->optics->placement.units_per_mm);
}

void IntegralColours::Add(const std::vector<Colour>& colours)
{
    pixels += colours.size();
    for (const Colour& colour : colours)
        if (colour.red() != 0 || colour.green() != 0 || colour.blue() != 0 || colour.transm() < 1)
            for (int channel = 0; channel < 3; channel++)
            {
                least[channel] = std::min(least[channel], float(colour[channel]));
                most[channel] = std::max(most[channel], float(colour[channel]));
            }
}

bool IntegralColours::Are_One(double all, const integral::OutputCurve& output) const
{
    bool one = pixels >= all;
    for (int channel = 0; channel < 3; channel++)
        one = one && (most[channel] < least[channel] ||
                      output(most[channel]) - output(least[channel]) < 1 / 255.0);
    return one;
}

/// The number of patches in a beam, chosen so that the error of the patches is small compared with
/// the sampling error. A quarter of the number of samples at the sharpest edges is enough, since
/// few pixels have so many samples; lenticular sheets, whose beams are narrow, need fewer.
static double Patches_In_Beam(const integral::IntegralCamera& optics,
                              const pov_base::IntegralRenderOptions& given)
{
    const double least = optics.optics.sheet().arrangement == integral::Arrangement::lenticular
                             ? 12
                             : 24,
                 at_edges = 0.25;
    const double samples = std::max(double(optics.pixel_samples) * optics.beam_samples,
                                    at_edges * given.edge_samples);
    return given.patches_in_beam > 0 ? given.patches_in_beam : std::max(least, samples);
}

void Choose_Integral_Bounding(SceneData& scene)
{
    constexpr double least_objects = 200, rays_an_object = 60;
    if (scene.boundingMethod != pov_base::integral_bounding_open)
        return;
    scene.boundingMethod = 1;
    const IntegralStatement *const statement = scene.parsedCamera.Integral.get();
    if (!statement || !statement->integral || !statement->optics)
        return;
    const integral::IntegralCamera& optics = *statement->optics;
    const auto is_finite = [](const ObjectPtr object) { return !Test_Flag(object, INFINITE_FLAG); };
    const double finite = std::count_if(scene.objects.begin(), scene.objects.end(), is_finite);
    const double rays = double(optics.film.width) * optics.film.height * optics.pixel_samples *
                        optics.beam_samples;
    if (finite >= least_objects && rays >= rays_an_object * finite)
        scene.boundingMethod = 2;
}

/// Puts the camera where the scene's eye is, for radiosity and other code that uses its location.
static void Move_To_Eye(Camera& camera, const integral::IntegralCamera& optics)
{
    const integral::Vec3 eye = *scene_from_seen(optics, {0, 0, -viewer_distance(optics)});
    Make_Vector(camera.Location, eye.x, eye.y, eye.z);
}

/// Error of a colour component, relative to +A's threshold, below which reducing it does not pay.
static constexpr double least_error_of_threshold = 0.01;

static void Begin(Camera& camera, const std::shared_ptr<const IntegralView>& view)
{
    camera.Integral_View = view;
    if (camera.Integral->parameters.move_eye)
        Move_To_Eye(camera, *view->optics);
    pov_base::IntegralFrame::Begin(*view->optics, camera.Integral->draft,
                                   camera.Integral->fit_words);
}

/// A camera that images only the pixels that a part of the viewing zone sees, from phase.x to
/// phase.y, and those beside them.
static std::shared_ptr<const integral::IntegralCamera> Restricted(
    const integral::IntegralCamera& camera, const integral::Vec2& phase)
{
    if (camera.projection)
        throw std::invalid_argument("Integral_Phase does not work with projection_lens; render the "
                                    "whole frame");
    if (camera.mapping != integral::LensMapping::automatic &&
        camera.mapping != integral::LensMapping::closest)
        throw std::invalid_argument("Integral_Phase works with lens_mapping auto and closest only; "
                                    "give one of these, or render the whole frame");
    const integral::LensSheet& sheet = camera.optics.sheet();
    const bool upwards = lenses_lie_across(sheet);
    const integral::Vec2 cell = cell_extent(sheet), pixel = camera.film.pixel_pitch;
    // A pixel's extent across the lenses, as a part of a lens: samples are up to half of it away from
    // the pixel's centre, and a pixel off the axis covers a somewhat larger part of the zone.
    const integral::Vec2 across = camera.optics.lattice().across();
    const double margin = sheet.arrangement == integral::Arrangement::lenticular
                              ? (std::fabs(pixel.x * across.x) + std::fabs(pixel.y * across.y)) /
                                    sheet.pitch
                          : upwards ? pixel.y / cell.y
                                    : pixel.x / cell.x;
    const auto restricted = std::make_shared<integral::IntegralCamera>(camera);
    restricted->optics.restrict_to({phase.x, phase.y, upwards}, 1.25 * margin);
    return restricted;
}

/// Sets the camera and the sampler of anti-aliasing's pixels.
static void Set_Sampled(IntegralView& view, const pov_base::IntegralRenderOptions& given)
{
    view.sampled_optics = view.optics;
    view.sampled_sampler = view.sampler;
    if (!given.reconstruct || given.quilt)
        return;
    const auto stripes = IntegralStripes(view.optics->film.subpixels).Camera_Of(*view.optics);
    if (!stripes || !integral::Reconstruction::possible(*stripes))
        return;
    view.sampled_optics = stripes;
    view.sampled_sampler = std::make_shared<integral::PixelSampler>(*stripes, given.seed);
}

void Start_Integral_View(Camera& camera, const SceneData& scene, int width, int height,
                         POVMS_Object& options)
{
    camera.Integral_View.reset();
    if (!camera.Integral || !camera.Integral->integral)
    {
        pov_base::IntegralFrame::Clear();
        return;
    }
    const auto view = std::make_shared<IntegralView>();
    view->counts = std::make_shared<IntegralCounts>();
    try
    {
        const pov_base::IntegralRenderOptions given = pov_base::Read_Integral_Options(options,
                                                                                      height);
        view->optics = Make_Integral_Optics(camera, width, height);
        if (given.phase)
            view->optics = Restricted(*view->optics, *given.phase);
        view->sampler = std::make_shared<integral::PixelSampler>(*view->optics, given.seed);
        view->clipping = pov_base::Read_Integral_Clipping(options);
        const bool projects = view->optics->projection.has_value();
        if (given.quilt && projects)
            throw std::invalid_argument("Integral_Quilt and projection_lens do not go together: "
                                        "render the views without the lens");
        if (given.quilt)
            view->quilt = std::make_shared<integral::QuiltSampler>(*view->optics, *given.quilt,
                                                                   width, height, given.seed);
        if (!given.depth_picture.empty())
            view->depth = std::make_shared<IntegralDepth>(*view, given.depth_picture,
                                                          camera.Integral->distances);
        view->rows = given.rows;
        view->seed = given.seed;
        // The two halves do not include anti-aliasing's samples and cannot make an error picture.
        const bool by_halves = given.audit && !given.quilt && !given.antialias &&
                               given.error_picture.empty() && view->sampler->halves_tell_error();
        view->error = {by_halves, scene.radiositySettings.radiosityEnabled, given.audit_share,
                       given.output, given.error_picture, given.continued};
        // Shading and radiosity's light are shared by beams of lenses, which a quilt's pixels do
        // not have. They and reconstruction assume that the eyes are in the aperture.
        const bool shares = !projects && !given.quilt;
        if (given.antialias && given.light_field && !projects)
        {
            const auto quilt = view->quilt ? std::optional(view->quilt->geometry()) : std::nullopt;
            Set_Sampled(*view, given);
            view->sampling = std::make_shared<IntegralSampling>(
                *view->sampled_optics, quilt, given.rows, given.block_side, given.reconstruct,
                least_error_of_threshold * given.threshold, given.displayed);
        }
        // Reconstruction gains more than sharing, and its own error is smaller.
        view->cache_expensive_shading_only = given.sharing == pov_base::IntegralSharing::automatic;
        const bool reconstructs = view->sampling && view->sampling->Reconstruction();
        if (shares && (given.sharing == pov_base::IntegralSharing::on ||
                       (view->cache_expensive_shading_only && given.antialias && !reconstructs)))
            view->shading_cache = std::make_shared<IntegralShadingCache>(
                *view->optics, Patches_In_Beam(*view->optics, given));
        if (shares && reconstructs && scene.radiositySettings.radiosityEnabled &&
            view->cache_expensive_shading_only)
            view->ambient_cells = std::make_shared<IntegralShadingCache>(
                *view->optics, IntegralSharedAmbient::cells_in_beam,
                IntegralSharedAmbient::cells_a_pixel);
        // Both halves contain the same noise of radiosity's points.
        if (given.audit && (!by_halves || view->error.radiosity))
            view->audit = std::make_shared<IntegralAudit>(*view, given.seed);
    }
    catch (const std::invalid_argument& problem)
    {
        throw POV_EXCEPTION(kParamErr, problem.what());
    }
    Begin(camera, view);
}

/// The error estimate of the frame; nothing if none was requested or none is possible.
static std::optional<integral::ErrorEstimate> Error_Of(const IntegralView& view)
{
    if (!view.error.by_halves)
        return view.audit ? view.audit->Result() : std::nullopt;
    integral::ErrorSums sums;
    for (const ThreadCounters& tally : view.counts->tallies)
        sums.add(tally.errors);
    auto error = integral::estimate(sums, integral::ErrorMethod::split_halves);
    if (error)
    {
        error->lit_pixels = sums.pixels;
        error->samples = view.optics->pixel_samples * view.optics->beam_samples;
    }
    if (const auto ambient = error && view.audit ? view.audit->Result() : std::nullopt)
        integral::add_independent(*error, *ambient);
    return error;
}

int Integral_Final_Tasks(const Camera& camera, int threads)
{
    const IntegralView *const view = camera.Integral_View.get();
    return view ? threads * ((view->depth ? 1 : 0) + (view->audit ? 1 : 0)) : 0;
}

RenderTask *New_Integral_Final_Task(ViewData *view, int index)
{
    const IntegralView& settings = *view->GetCamera().Integral_View;
    // Alternate between the kinds if there are both.
    if (settings.depth && (index % 2 == 0 || !settings.audit))
        return new IntegralDepthTask(view);
    return new IntegralAuditTask(view);
}

void Get_Integral_Statistics(const Camera& camera, POVMS_Object& statistics)
{
    if (!camera.Integral_View)
        return;
    const IntegralView& view = *camera.Integral_View;
    IntegralCounts& counts = *view.counts;
    std::lock_guard<std::mutex> lock(counts.mutex);
    const auto set_total = [&](POVMSType key, SingleWriterCounter ThreadCounters::*count)
    {
        long long sum = 0;
        for (const ThreadCounters& tally : counts.tallies)
            sum += (tally.*count).Get();
        statistics.SetLong(key, sum);
    };
    set_total(kIntegralAttrib_FilmPoints, &ThreadCounters::film_points);
    set_total(kIntegralAttrib_Imaged, &ThreadCounters::imaged);
    set_total(kIntegralAttrib_Searched, &ThreadCounters::searched);
    set_total(kIntegralAttrib_OutsideAperture, &ThreadCounters::outside_aperture);
    set_total(kIntegralAttrib_TotalReflection, &ThreadCounters::total_reflection);
    set_total(kIntegralAttrib_Rays, &ThreadCounters::rays);
    set_total(kIntegralAttrib_ContainerSearches, &ThreadCounters::container_searches);
    set_total(kIntegralAttrib_SharedShadings, &ThreadCounters::shared_shadings);
    set_total(kIntegralAttrib_PatchShadings, &ThreadCounters::patch_shadings);
    statistics.SetInt(kIntegralAttrib_Containers, counts.containers);
    statistics.SetInt(kIntegralAttrib_Objects, counts.objects);

    const integral::Vec2 size = trimmed_size(view.optics->film);
    statistics.SetFloat(kIntegralAttrib_PrintWidth, size.x);
    statistics.SetFloat(kIntegralAttrib_PrintHeight, size.y);
    statistics.SetInt(kIntegralAttrib_Draft, camera.Integral->draft);
    statistics.SetFloat(kIntegralAttrib_ViewingDistance, viewer_distance(*view.optics));
    if (!camera.Integral->fit_words.empty())
        statistics.SetString(kIntegralAttrib_FitWords, camera.Integral->fit_words.c_str());
    if (const auto& parallax = view.optics->parallax)
    {
        statistics.SetFloat(kIntegralAttrib_Parallax, parallax->factor);
        statistics.SetFloat(kIntegralAttrib_SceneDistance, parallax->scene_distance);
    }
    else if (camera.Integral->parameters.move_eye)
        statistics.SetFloat(kIntegralAttrib_SceneDistance, Integral_Scene_Distance(camera));
    const double area = double(view.optics->film.width) * view.optics->film.height;
    statistics.SetBool(kIntegralAttrib_OneColour, counts.colours.Are_One(area, view.error.output));

    const auto error = Error_Of(view);
    // The error of some pixels is not the frame's.
    pov_base::IntegralFrame::End(view.error.continued ? std::nullopt : error);
    statistics.SetFloat(kIntegralAttrib_Seconds, pov_base::IntegralFrame::Seconds());
    statistics.SetBool(kIntegralAttrib_Continued, view.error.continued);
    if (view.depth)
        view.depth->Write();
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
