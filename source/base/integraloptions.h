// SPDX-License-Identifier: AGPL-3.0-or-later
// A render's options that concern the integral camera.
#ifndef POVRAY_BASE_INTEGRALOPTIONS_H
#define POVRAY_BASE_INTEGRALOPTIONS_H

#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>

#include "integral/lightfield/error_estimate.h"

class POVMS_Object;

namespace pov_base
{

/// Whether rays share their shading. automatic: where there is anti-aliasing and shading is dear.
enum class IntegralSharing
{
    automatic,
    on,
    off
};

/// The rows of a frame, 0 at the top, that are the picture. Others that are rendered are there for
/// anti-aliasing to look at from these: they are neither refined nor audited nor counted among the
/// lit pixels.
struct IntegralRows
{
    int first = 0, last = std::numeric_limits<int>::max();
    bool Have(int y) const { return Meet(y, y); }
    bool Meet(int top, int bottom) const { return top <= last && bottom >= first; }
};

struct IntegralRenderOptions
{
    bool audit = true;      ///< Integral_Audit=off: no error estimate at all
    double audit_share = 0; ///< Integral_Audit=PERCENT as a fraction; 0: not given
    std::uint64_t seed = 0; ///< Integral_Seed=
    IntegralSharing sharing = IntegralSharing::automatic; ///< Integral_Sharing=
    double patches_in_beam = 0; ///< Integral_Sharing=NUMBER; 0: as the samples ask for
    double edge_samples = 1;    ///< that anti-aliasing gives to a pixel with an edge, about
    std::string error_picture;  ///< Integral_Error_Image=; empty: none
    std::string depth_picture;  ///< Integral_Depth_Image=; empty: none
    IntegralRows rows;          ///< Integral_Rows=
    bool antialias = false;     ///< +A, by a method other than 0
    bool light_field = true;    ///< Integral_Antialiasing=: not by pixels, as POV-Ray's own does
    int block_side = 32;        ///< pixels, of the blocks that are refined
    std::size_t most_memory = std::numeric_limits<std::size_t>::max(); ///< bytes of an image in
                                                                       ///< main memory; +MI
    integral::OutputCurve output; ///< from the renderer's values to those of the picture file
};

/// Throws std::invalid_argument with a sentence for the user.
IntegralRenderOptions Read_Integral_Options(POVMS_Object& options);

/// The sentence with which Read_Integral_Options would refuse the options; empty: it would not.
std::string Problem_Of_Integral_Options(POVMS_Object& options);

/// The way of bounding that the options ask for, `method` by POV-Ray's default;
/// integral_bounding_open if they leave it open, to be chosen once the scene is parsed.
unsigned int Integral_Bounding(POVMS_Object& options, unsigned int method);
constexpr unsigned int integral_bounding_open = 3;

}

#endif
