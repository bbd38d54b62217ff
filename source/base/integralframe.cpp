// SPDX-License-Identifier: AGPL-3.0-or-later

// configbase.h must be the first POV-Ray file included within base
#include "configbase.h"
#include "base/integralframe.h"
#include "integral/frame/quilt_name.h"
#include "integral/sampling/quilt_sampler.h"

#include <chrono>
#include <cstdint>
#include <cstdio>
#include <mutex>
#include <optional>
#include <utility>

// this must be the last file included
#include "base/povdebug.h"

namespace pov_base
{

namespace
{

typedef std::chrono::steady_clock Clock;

struct State
{
    std::mutex mutex;
    std::string scene;
    std::string fingerprint;
    std::optional<integral::PixelSize> size;
    std::optional<integral::ViewGrid> quilt;
    std::optional<integral::Vec2> phase;
    bool repeatable = false;
    std::optional<integral::FrameMetadata> metadata;
    Clock::time_point begun;
    std::optional<Clock::time_point> ended;
    std::string problem;
};

State& The_State()
{
    static State state;
    return state;
}

/// The 64-bit FNV-1a hash of a text.
std::string Hash(const std::string& text)
{
    std::uint64_t hash = 0xcbf29ce484222325u;
    for (unsigned char byte : text)
        hash = (hash ^ byte) * 0x100000001b3u;
    char digits[17];
    std::snprintf(digits, sizeof(digits), "%016llx", (unsigned long long)hash);
    return digits;
}

}

integral::FrameMetadata Integral_Geometry(const integral::IntegralCamera& camera)
{
    integral::FrameMetadata metadata;
    metadata.sheet = camera.optics.sheet();
    metadata.film = camera.film;
    metadata.aperture = camera.optics.aperture();
    metadata.placement = camera.placement;
    metadata.projection = camera.projection;
    metadata.parallax = camera.parallax;
    return metadata;
}

void IntegralFrame::Set_Scene(const std::string& file)
{
    State& state = The_State();
    std::lock_guard<std::mutex> lock(state.mutex);
    state.scene = file.substr(file.find_last_of("/\\") + 1);
}

void IntegralFrame::Set_Part(const std::optional<integral::ViewGrid>& quilt,
                             const std::optional<integral::Vec2>& phase)
{
    State& state = The_State();
    std::lock_guard<std::mutex> lock(state.mutex);
    state.quilt = quilt;
    state.phase = phase;
}

void IntegralFrame::Set_Repeatable(bool repeatable)
{
    State& state = The_State();
    std::lock_guard<std::mutex> lock(state.mutex);
    state.repeatable = repeatable;
}

bool IntegralFrame::Repeatable()
{
    State& state = The_State();
    std::lock_guard<std::mutex> lock(state.mutex);
    return state.repeatable;
}

void IntegralFrame::Set_Expected_Camera(const integral::IntegralCamera *camera)
{
    State& state = The_State();
    std::lock_guard<std::mutex> lock(state.mutex);
    state.fingerprint.clear();
    state.size.reset();
    if (camera)
    {
        state.size = integral::PixelSize{camera->film.width, camera->film.height};
        std::string text = integral::to_json(Integral_Geometry(*camera));
        for (const int choice :
             {int(camera->optics.model()), int(camera->mapping), camera->pixel_samples,
              camera->beam_samples, int(camera->pseudoscopic), int(camera->display_prefilter)})
            text += std::to_string(choice) + ' ';
        if (camera->depth_range)
            text += std::to_string(camera->depth_range->x) + ' ' +
                    std::to_string(camera->depth_range->y);
        if (state.quilt)
            text += "quilt " + std::to_string(state.quilt->columns) + 'x' +
                    std::to_string(state.quilt->rows);
        if (state.phase)
            text += "phase " + std::to_string(state.phase->x) + ',' +
                    std::to_string(state.phase->y);
        state.fingerprint = Hash(text);
    }
}

std::optional<integral::PixelSize> IntegralFrame::Expected_Size()
{
    State& state = The_State();
    std::lock_guard<std::mutex> lock(state.mutex);
    return state.size;
}

void IntegralFrame::Begin(const integral::IntegralCamera& camera, int draft,
                          const std::string& fit)
{
    State& state = The_State();
    std::lock_guard<std::mutex> lock(state.mutex);
    state.metadata = Integral_Geometry(camera);
    state.metadata->render = integral::RenderRecord();
    state.metadata->render->program = "povray-integral 3.7.0.10";
    state.metadata->render->scene = state.scene;
    state.metadata->render->draft = draft;
    state.metadata->render->fit = fit;
    state.metadata->render->phase = state.phase;
    state.metadata->render->model = camera.optics.model();
    state.metadata->render->mapping = camera.mapping;
    state.metadata->render->pixel_samples = camera.pixel_samples;
    state.metadata->render->beam_samples = camera.beam_samples;
    state.metadata->render->pseudoscopic = camera.pseudoscopic;
    state.metadata->render->display_prefilter = camera.display_prefilter;
    if (state.quilt)
        state.metadata->quilt = integral::QuiltSampler(camera, *state.quilt, camera.film.width,
                                                       camera.film.height)
                                    .record();
    state.problem.clear();
    state.begun = Clock::now();
    state.ended.reset();
}

void IntegralFrame::End(const std::optional<integral::ErrorEstimate>& error)
{
    State& state = The_State();
    std::lock_guard<std::mutex> lock(state.mutex);
    if (!state.metadata)
        return;
    state.metadata->render->error = error;
    const std::chrono::duration<double> of_the_error(error ? error->seconds : 0);
    state.ended = Clock::now() - std::chrono::duration_cast<Clock::duration>(of_the_error);
}

void IntegralFrame::Add_Problem(const std::string& keyword, const std::string& problem)
{
    State& state = The_State();
    std::lock_guard<std::mutex> lock(state.mutex);
    state.problem += keyword + ": " + problem + ". The picture itself is complete. ";
}

std::string IntegralFrame::Take_Problem()
{
    State& state = The_State();
    std::lock_guard<std::mutex> lock(state.mutex);
    return std::exchange(state.problem, std::string());
}

void IntegralFrame::Clear()
{
    State& state = The_State();
    std::lock_guard<std::mutex> lock(state.mutex);
    state.metadata.reset();
}

bool IntegralFrame::Is_Active()
{
    State& state = The_State();
    std::lock_guard<std::mutex> lock(state.mutex);
    return state.metadata.has_value();
}

std::string IntegralFrame::Named(const std::string& file)
{
    State& state = The_State();
    std::lock_guard<std::mutex> lock(state.mutex);
    const auto dot = file.find_last_of('.'), slash = file.find_last_of('/');
    if (!state.metadata || !state.metadata->quilt || dot == std::string::npos ||
        (slash != std::string::npos && slash > dot))
        return file;
    const integral::Film& film = state.metadata->film;
    return integral::quilt_name(file, state.metadata->quilt->grid,
                                film.width * film.pixel_pitch.x /
                                    (film.height * film.pixel_pitch.y));
}

std::optional<integral::Vec2> IntegralFrame::Pixel_Pitch()
{
    State& state = The_State();
    std::lock_guard<std::mutex> lock(state.mutex);
    if (state.quilt)
        return std::nullopt;
    return state.metadata->film.pixel_pitch;
}

std::string IntegralFrame::Document(const integral::Encoding& encoding)
{
    const double seconds = Seconds();
    State& state = The_State();
    std::lock_guard<std::mutex> lock(state.mutex);
    integral::FrameMetadata metadata = *state.metadata;
    metadata.encoding = encoding;
    metadata.render->seconds = state.repeatable ? 0 : seconds;
    if (state.repeatable && metadata.render->error)
        metadata.render->error->seconds = 0;
    return integral::to_json(metadata);
}

double IntegralFrame::Seconds()
{
    State& state = The_State();
    std::lock_guard<std::mutex> lock(state.mutex);
    return state.metadata
               ? std::chrono::duration<double>(state.ended.value_or(Clock::now()) - state.begun)
                     .count()
               : 0;
}

std::string IntegralFrame::Fingerprint()
{
    State& state = The_State();
    std::lock_guard<std::mutex> lock(state.mutex);
    return state.fingerprint;
}

}
