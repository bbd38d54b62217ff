// SPDX-License-Identifier: AGPL-3.0-or-later
// Draws by live_view.glsl without a browser: live_view.js's LiveView for OpenGL ES 3 through EGL.
#ifndef INTEGRAL_BENCH_LIVE_DRAWING_H
#define INTEGRAL_BENCH_LIVE_DRAWING_H

#include "integral/frame/frame.h"
#include "integral/replay/replay.h"
#include "integral/studio/probe.h"

#include <memory>
#include <string>

namespace integral::bench {

/// The sheet's place in the scene.
struct LivePlacement {
    double sheet_distance = 0; ///< scene units
    double parallax = 1;
    double scene_distance = 0; ///< mm
};

struct LiveOptions {
    int samples = 3; ///< across a pixel
    int steps = 64;  ///< at most, along a line
    double tint = 0; ///< depth budget, mm; 0: none
    bool without_sheet = false;
};

class LiveDrawing {
public:
    /// Opens a context without a window. `shader`: sheet_optics.glsl and live_view.glsl. Throws
    /// std::runtime_error if there is none, or if the driver refuses the shader.
    explicit LiveDrawing(const std::string& shader);
    ~LiveDrawing();

    /// Name and version of the renderer.
    std::string renderer() const;
    void set_probe(const Probe& probe);
    void set_view(int width, int height, const FrameMetadata& geometry);
    /// Draws and waits for the end.
    void draw(Eye eye, const LivePlacement& placement, const LiveOptions& options);
    /// The picture last drawn, sRGB.
    Image picture() const;

private:
    struct Context;
    std::unique_ptr<Context> context_;
};

} // namespace integral::bench

#endif
