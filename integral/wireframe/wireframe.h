// SPDX-License-Identifier: AGPL-3.0-or-later
// Draws a mesh as a micro-image frame by geometric projection: every point through every lens that
// can image it (thesis 3.4). This is fast, for placing a scene before the scene is traced.
#ifndef INTEGRAL_WIREFRAME_WIREFRAME_H
#define INTEGRAL_WIREFRAME_WIREFRAME_H

#include "integral/base/parallel.h"
#include "integral/frame/frame.h"
#include "integral/wireframe/mesh.h"

#include <optional>

namespace integral {

enum class FaceStyle {
    wire,   ///< all edges of faces
    hidden, ///< edges of faces where no face is in front
    flat    ///< faces filled, each in one shade
};

/// The mesh to draw, in the sheet frame, mm, and how to draw it.
struct WireframeRequest {
    Mesh mesh;
    SheetOptics optics;
    Film film; ///< any subpixels but `cells`
    LensMapping mapping = LensMapping::automatic;
    FaceStyle faces = FaceStyle::wire;
    int samples = 32; ///< of a lens's cell (full), or of its spread (hybrid)
    /// Draws what is behind the sheet, inverted in depth, as a single-stage capture records it.
    bool pseudoscopic = false;
    Colour background{0, 0, 0, 1}; ///< linear light
    Vec3 light{-1, 1, -1};         ///< towards the light that shades flat faces
};

/// Cost of a drawing.
struct WireframeCost {
    double projections = 0; ///< each vertex counted once for each lens that it was projected
                            ///< through
    int lenses = 0;         ///< of the film
};

/// The frame's picture, 8 or 16 bits of sRGB or 32 of linear light (`bits`). Pixels that image
/// nothing are black, as the renderer leaves them. With extended pinholes, points and parts of
/// lines within one focal length (the sheet's thickness) of the sheet cover their lens (3.5.1);
/// through pinholes they vanish (figure 3-13). Returns nothing if `progress` stopped the work.
/// Throws std::invalid_argument for a film whose subpixels are `cells`.
std::optional<Image> draw_wireframe(const WireframeRequest& request, int bits, int threads,
                                    const Progress& progress, WireframeCost& cost);

} // namespace integral

#endif
