// SPDX-License-Identifier: AGPL-3.0-or-later
// The metadata of the micro-image frame that is being rendered. A process renders one picture at a
// time, so there is at most one such frame.
#ifndef POVRAY_BASE_INTEGRALFRAME_H
#define POVRAY_BASE_INTEGRALFRAME_H

#include <optional>
#include <string>

#include "integral/frame/frame_metadata.h"

namespace pov_base
{

/// The camera's geometry, without `render`.
integral::FrameMetadata Integral_Geometry(const integral::IntegralCamera& camera);

class IntegralFrame
{
public:
    /// Sets the scene's name for the frame's metadata, at the start of parsing.
    static void Set_Scene(const std::string& file);

    /// Sets the view grid of quilts (nothing: pictures are frames), and the part of the viewing
    /// zone that frames show (nothing: all of it), at the start of parsing.
    static void Set_Part(const std::optional<integral::ViewGrid>& quilt,
                         const std::optional<integral::Vec2>& phase);

    /// Sets whether pictures are written without date, machine and run time, so that the same
    /// pixels give the same file; at the start of parsing, for every camera.
    static void Set_Repeatable(bool repeatable);
    static bool Repeatable();

    /// Sets the scene's camera after parsing (null for a camera that is not integral), so that an
    /// interrupted render is continued only with the same geometry.
    static void Set_Expected_Camera(const integral::IntegralCamera *camera);

    /// The picture size of the camera passed to Set_Expected_Camera; nothing if it was null.
    static std::optional<integral::PixelSize> Expected_Size();

    /// Makes pictures frames of this camera from now on, and starts the measurement of time.
    /// `draft`: the number of Integral_Draft=. `fit`: the words that the fit chose; empty: no fit.
    static void Begin(const integral::IntegralCamera& camera, int draft, const std::string& fit);

    /// Call it when the picture is rendered, with its error if known. Ends the measurement of time,
    /// which excludes the error estimate.
    static void End(const std::optional<integral::ErrorEstimate>& error);

    /// Records why the additional file that `keyword` requests is missing.
    static void Add_Problem(const std::string& keyword, const std::string& problem);

    /// Returns the recorded problems as a message, and clears them; empty if there are none.
    static std::string Take_Problem();

    /// Clears the frame: from now on pictures are not integral frames.
    static void Clear();

    /// Whether the picture is an integral frame, or a quilt of an integral camera's views.
    static bool Is_Active();

    /// The name of the picture's file: `file`, for a quilt with the suffix that states its views.
    static std::string Named(const std::string& file);

    /// Film pixel pitch, mm; none for a quilt, whose pixels lie on no film. Call it only if
    /// Is_Active().
    static std::optional<integral::Vec2> Pixel_Pitch();

    /// The JSON document for a file whose samples have the given encoding. Call it only if
    /// Is_Active().
    static std::string Document(const integral::Encoding& encoding);

    /// Seconds from Begin to End, or to now; 0 without a Begin.
    static double Seconds();

    /// A hash (16 hexadecimal digits) of the geometry of the camera passed to Set_Expected_Camera;
    /// empty if it was null.
    static std::string Fingerprint();
};

}

#endif
