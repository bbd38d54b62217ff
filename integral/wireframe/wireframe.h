// SPDX-License-Identifier: AGPL-3.0-or-later
// Draws a mesh as a micro-image frame by geometric projection: every point through every lens that
// can image it (thesis 3.4). It is fast, for placing a scene before it is traced.
#ifndef INTEGRAL_WIREFRAME_WIREFRAME_H
#define INTEGRAL_WIREFRAME_WIREFRAME_H

#include "integral/base/parallel.h"
#include "integral/lightfield/frame.h"
#include "integral/wireframe/mesh.h"

#include <optional>

namespace integral {

enum class FaceStyle {
    wire,   ///< their edges, all of them
    hidden, ///< their edges where no face is in front
    flat    ///< filled, each in one shade
};

/// What is drawn, and how; the mesh's coordinates are those of the sheet frame, mm.
struct WireframeRequest {
    Mesh mesh;
    SheetOptics optics;
    Film film; ///< its colours at the pixels' centres or in stripes
    LensMapping mapping = LensMapping::automatic;
    FaceStyle faces = FaceStyle::wire;
    int samples = 32; ///< of a lens's cell (full), or of its spread (hybrid)
    /// As a single-stage capture records: what is behind the sheet, inverted in depth.
    bool pseudoscopic = false;
    Colour background{0, 0, 0, 1}; ///< linear light
    Vec3 light{-1, 1, -1};         ///< towards the light that shades flat faces
};

/// What the work was.
struct WireframeCost {
    double projections = 0; ///< vertices times the lenses that each was projected through
    int lenses = 0;         ///< of the film
};

/// The frame's picture, 8 or 16 bits of sRGB or 32 of linear light (`bits`). Pixels that image
/// nothing are black, as the renderer leaves them. Points and the parts of lines within one focal
/// length (the sheet's thickness) of an extended pinhole's sheet cover their lens (3.5.1); through
/// pinholes they vanish (figure 3-13). Nothing if `progress` stopped the work. Throws
/// std::invalid_argument for a film whose colours are neither at the centres nor in stripes.
std::optional<Image> draw_wireframe(const WireframeRequest& request, int bits, int threads,
                                    const Progress& progress, WireframeCost& cost);

} // namespace integral

#endif
