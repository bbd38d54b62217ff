// SPDX-License-Identifier: AGPL-3.0-or-later
// Reads the render options of the integral camera.
#ifndef POVRAY_BASE_INTEGRALOPTIONS_H
#define POVRAY_BASE_INTEGRALOPTIONS_H

#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <string>

#include "integral/frame/error_estimate.h"
#include "integral/frame/view_grid.h"

class POVMS_Object;

namespace pov_base
{

/// Whether rays share shading. automatic: with anti-aliasing, if shading is expensive; of a reconstructed
/// frame, only radiosity's ambient light.
enum class IntegralSharing
{
    automatic,
    on,
    off
};

/// The rows of a frame that count, from 0 at the top. Other rows that are rendered serve only as
/// neighbours for anti-aliasing: they are not refined, not audited, and not counted as lit pixels.
struct IntegralRows
{
    int first = 0, last = std::numeric_limits<int>::max();
    bool Have(int y) const { return Meet(y, y); }
    bool Meet(int top, int bottom) const { return top <= last && bottom >= first; }
};

/// The options that apply while the scene is parsed.
struct IntegralSceneOptions
{
    std::string camera;       ///< the words of Integral_Camera=; empty: none
    std::string sheet;        ///< Integral_Sheet=: a file; empty: none
    int draft = 1;            ///< Integral_Draft=: pixels of the final across a pixel of the draft
    std::optional<double> fit; ///< Integral_Fit=: depth budgets on either side; 0: off
    bool quilt = false;        ///< Integral_Quilt= is given
    bool free_width = false;  ///< the width is a default, which print_size may replace
    bool free_height = false; ///< the same for the height
    std::string problem;      ///< what is wrong with the options, for the user; empty: nothing
    std::string problem_with_any_camera; ///< the same, for options that apply to every camera
};

/// Reads the options; problems that Read_Integral_Options would report are in `problem`.
std::shared_ptr<const IntegralSceneOptions> Read_Integral_Scene_Options(POVMS_Object& options);

struct IntegralRenderOptions
{
    bool audit = true;      ///< false with Integral_Audit=off: no error estimate
    double audit_share = 0; ///< Integral_Audit=PERCENT as a fraction; 0: not given
    std::uint64_t seed = 0; ///< Integral_Seed=
    IntegralSharing sharing = IntegralSharing::automatic; ///< Integral_Sharing=
    double patches_in_beam = 0; ///< Integral_Sharing=NUMBER; 0: chosen by the number of samples
    double edge_samples = 1;    ///< approximate number of samples in a pixel with an edge
    std::string error_picture;  ///< Integral_Error_Image=; empty: none
    std::string depth_picture;  ///< Integral_Depth_Image=; empty: none
    IntegralRows rows;          ///< Integral_Rows=
    std::optional<integral::ViewGrid> quilt; ///< Integral_Quilt=; nothing: a frame
    std::optional<integral::Vec2> phase; ///< Integral_Phase=, from x to y; nothing: the whole zone
    bool continued = false;                  ///< +C: some pixels come from an earlier run
    bool antialias = false;                  ///< +A with a method other than 0
    int method = 1;                          ///< +AM
    bool light_field = true;                 ///< Integral_Antialiasing=light_field; false: pixels
    bool reconstruct = true;                 ///< Integral_Reconstruction=
    double threshold = 0.3;                  ///< +A's threshold
    int block_side = 32;                     ///< width and height of a block, pixels
    bool displayed = true;                   ///< +D: unfinished pixels are shown
    integral::OutputCurve output; ///< from the renderer's values to the picture file's
};

/// Reads the options. Throws std::invalid_argument with a message for the user. `height`: height of
/// the picture, pixels; 0 if not known yet.
IntegralRenderOptions Read_Integral_Options(POVMS_Object& options, int height);

/// The bounding method: `method` (POV-Ray's value) if the options specify one, else
/// integral_bounding_open, which means that it is chosen after the scene is parsed.
unsigned int Integral_Bounding(POVMS_Object& options, unsigned int method);
constexpr unsigned int integral_bounding_open = 3;

}

#endif
