// SPDX-License-Identifier: AGPL-3.0-or-later
// Queries an X server's RandR extension for its displays. SDL gives their positions, but not
// whether their pixels are resampled.
#ifdef HAVE_SDL2
#include "integral/screen/screens.h"

#include "integral/io/release.h"

#include <X11/Xlib.h>
#include <X11/extensions/Xrandr.h>

#include <memory>
#include <utility>

namespace integral {
namespace {

void close_display(Display* display) { XCloseDisplay(display); }
void free_transform(XRRCrtcTransformAttributes* transform) { XFree(transform); }

using Connection = std::unique_ptr<Display, Release<Display, close_display>>;
using Resources = std::unique_ptr<XRRScreenResources,
                                  Release<XRRScreenResources, XRRFreeScreenResources>>;
using OutputInfo = std::unique_ptr<XRROutputInfo, Release<XRROutputInfo, XRRFreeOutputInfo>>;
using CrtcInfo = std::unique_ptr<XRRCrtcInfo, Release<XRRCrtcInfo, XRRFreeCrtcInfo>>;
using Transform = std::unique_ptr<XRRCrtcTransformAttributes,
                                  Release<XRRCrtcTransformAttributes, free_transform>>;

const XRRModeInfo* mode_of(const XRRScreenResources& resources, RRMode id)
{
    for (int m = 0; m < resources.nmode; ++m)
        if (resources.modes[m].id == id)
            return &resources.modes[m];
    return nullptr;
}

bool is_identity(const XTransform& t)
{
    for (int row = 0; row < 3; ++row)
        for (int column = 0; column < 3; ++column)
            if (t.matrix[row][column] != (row == column ? 0x10000 : 0))
                return false;
    return true;
}

/// Reads the size of the output's preferred mode, or of its current mode if that is preferred too.
void read_preferred(const XRRScreenResources& resources, const XRROutputInfo& output,
                    const XRRModeInfo& current, XOutput& o)
{
    for (int m = 0; m < output.npreferred && m < output.nmode; ++m)
        if (const XRRModeInfo* preferred = mode_of(resources, output.modes[m])) {
            const bool is_current = preferred->width == current.width &&
                                    preferred->height == current.height;
            if (o.preferred_width == 0 || is_current) {
                o.preferred_width = int(preferred->width);
                o.preferred_height = int(preferred->height);
            }
        }
}

/// Data of an output that shows a mode.
XOutput output_of(const XRRScreenResources& resources, const XRROutputInfo& output,
                  const XRRCrtcInfo& crtc, const XRRModeInfo& mode)
{
    XOutput o;
    o.name = std::string(output.name, std::size_t(output.nameLen));
    o.x = crtc.x;
    o.y = crtc.y;
    o.width = int(crtc.width);
    o.height = int(crtc.height);
    o.mode_width = int(mode.width);
    o.mode_height = int(mode.height);
    if (mode.hTotal && mode.vTotal)
        o.rate = double(mode.dotClock) / (double(mode.hTotal) * mode.vTotal);
    read_preferred(resources, output, mode, o);
    if (crtc.rotation & (RR_Rotate_90 | RR_Rotate_270)) {
        std::swap(o.mode_width, o.mode_height);
        std::swap(o.preferred_width, o.preferred_height);
    }
    return o;
}

} // namespace

std::vector<XOutput> x_outputs(bool& in_wayland)
{
    std::vector<XOutput> outputs;
    in_wayland = false;
    const Connection display(XOpenDisplay(nullptr));
    int event = 0, error = 0, opcode = 0, major = 0, minor = 0;
    if (!display)
        return outputs;
    in_wayland = XQueryExtension(display.get(), "XWAYLAND", &opcode, &event, &error);
    if (!XRRQueryExtension(display.get(), &event, &error) ||
        !XRRQueryVersion(display.get(), &major, &minor) ||
        std::pair(major, minor) < std::pair(1, 3))
        return outputs;
    const Resources resources(
        XRRGetScreenResourcesCurrent(display.get(), DefaultRootWindow(display.get())));
    for (int k = 0; resources && k < resources->noutput; ++k) {
        const OutputInfo output(
            XRRGetOutputInfo(display.get(), resources.get(), resources->outputs[k]));
        if (!output || output->connection == RR_Disconnected || !output->crtc)
            continue;
        const CrtcInfo crtc(XRRGetCrtcInfo(display.get(), resources.get(), output->crtc));
        const XRRModeInfo* mode = crtc ? mode_of(*resources, crtc->mode) : nullptr;
        if (!mode)
            continue;
        XOutput o = output_of(*resources, *output, *crtc, *mode);
        in_wayland = in_wayland ||
                     o.name.rfind("XWAYLAND", 0) == 0; // older XWayland has no such extension
        XRRCrtcTransformAttributes* attributes = nullptr;
        if (XRRGetCrtcTransform(display.get(), output->crtc, &attributes) && attributes)
            o.transformed = !is_identity(Transform(attributes)->currentTransform);
        outputs.push_back(o);
    }
    return outputs;
}

} // namespace integral
#endif
