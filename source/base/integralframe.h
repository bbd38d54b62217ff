// SPDX-License-Identifier: AGPL-3.0-or-later
// The micro-image frame that is being rendered: what its file is to say about itself.
// POV-Ray renders one picture at a time in a process; this is that picture's, or nothing.
#ifndef POVRAY_BASE_INTEGRALFRAME_H
#define POVRAY_BASE_INTEGRALFRAME_H

#include <optional>
#include <string>

#include "integral/lightfield/frame_metadata.h"

namespace pov_base
{

class IntegralFrame
{
public:
    /// Names the scene, for the frame's record; at the start of parsing.
    static void Set_Scene(const std::string& file);

    /// The geometry of the scene's last camera, once it has been parsed, so that an
    /// interrupted render is continued only with the same; nothing = not an integral one.
    static void Expect(const integral::IntegralCamera *camera);

    /// From here on, pictures are frames of this camera; seconds count from here.
    static void Begin(const integral::IntegralCamera& camera);

    /// The picture is rendered, with this error if it is known: seconds end here, less those that
    /// the error took.
    static void End(const std::optional<integral::ErrorEstimate>& error);

    /// From here on, pictures are POV-Ray's own.
    static void Forget();

    /// Whether the picture is an integral frame.
    static bool Current();

    /// Film pixel pitch, mm. Only where Current().
    static integral::Vec2 Pixel_Pitch();

    /// The JSON document, stating the encoding of the file's samples. Only where Current().
    static std::string Document(const integral::Encoding& encoding);

    /// Seconds from Begin to End, or to now; 0 without a Begin.
    static double Seconds();

    /// A hash (16 hexadecimal digits) of the expected camera's geometry; empty for POV-Ray's
    /// own cameras.
    static std::string Fingerprint();
};

}

#endif
