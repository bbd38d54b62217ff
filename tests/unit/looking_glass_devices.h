// SPDX-License-Identifier: AGPL-3.0-or-later
// The nominal figures of every Looking Glass display, from the maker's list of devices. Cells are
// listed by rows from the bottom.
#ifndef TESTS_UNIT_LOOKING_GLASS_DEVICES_H
#define TESTS_UNIT_LOOKING_GLASS_DEVICES_H

#include <array>
#include <sstream>
#include <string>
#include <vector>

namespace looking_glass_devices {

struct Device {
    std::string name; ///< the panel's name in known_panels
    double pitch, slope, center, view_cone, dpi;
    int width, height, mode;                  ///< CellPatternMode
    std::vector<std::array<double, 6>> cells; ///< each: R x, R y, G x, G y, B x, B y; +y up
};

struct Flips {
    bool x = false, y = false, subpixels = false, inverted = true;
};

inline const std::vector<Device>& devices()
{
    static const std::vector<std::array<double, 6>> lying{{-0.31, 0.25, 0.28, 0.25, 0, -0.25},
                                                          {-0.31, -0.25, 0.28, -0.25, 0, 0.25}},
        standing{{-0.25, -0.31, -0.25, 0.28, 0.25, 0}, {0.25, -0.31, 0.25, 0.28, -0.25, 0}};
    static const std::vector<Device> all{
        {"looking-glass-8-9", 49.79978561401367, 5.48, 0, 40, 338, 2560, 1600, 0, {}},
        {"looking-glass-15-6", 50.07143783569336, -7.7, 0, 40, 283, 3840, 2160, 0, {}},
        {"looking-glass-8k", 38.0545883178711, -7.7, 0, 40, 280, 7680, 4320, 0, {}},
        {"looking-glass-portrait", 52, -7, 0.5, 40, 324, 1536, 2048, 0, {}},
        {"looking-glass-16-gen2", 50, -7, 0.5, 40, 283, 3840, 2160, 0, {}},
        {"looking-glass-32-gen2", 42, -6, 0.3, 40, 280, 7680, 4320, 0, {}},
        {"looking-glass-65", 42, -6, 0.3, 40, 136, 7680, 4320, 0, {}},
        {"looking-glass-go", 80.7, -6.3, -0.3, 54, 491, 1440, 2560, 0, {}},
        {"looking-glass-16-portrait", 44.72, -7.45, 0, 50, 283, 2160, 3840, 4, standing},
        {"looking-glass-16-landscape", 44.72, -6.9, 0.5, 50, 283, 3840, 2160, 2, lying},
        {"looking-glass-32-portrait", 80.7, -6.3, -0.3, 54, 280, 4320, 7680, 2, lying},
        {"looking-glass-32-landscape", 75, -7.2, -0.2, 50, 280, 7680, 4320, 0, {}},
    };
    return all;
}

/// Those displays, and invented ones with every pattern and number of cells and with odd and even
/// widths and heights.
inline std::vector<Device> variants()
{
    std::vector<Device> all = devices();
    for (int mode = 0; mode <= 4; ++mode)
        for (int number = 1; number <= 5; ++number)
            for (int size = 0; size < 4; ++size) {
                Device device{"made up",       44.7,           -6.9, 0.4, 50, 283,
                              1000 + size % 2, 700 + size / 2, mode, {}};
                for (int k = 0; k < number; ++k)
                    device.cells.push_back(
                        {0.1 * k, 0.3 - 0.2 * k, -0.2 * k, 0.1, 0.4 - 0.15 * k, -0.25 + 0.05 * k});
                all.push_back(device);
            }
    return all;
}

/// The calibration file in the form in which the display's memory holds it.
inline std::string file_of(const Device& device, const Flips& flips)
{
    std::ostringstream text;
    text.precision(16);
    const auto field = [&](const char* name, double value) {
        text << ", \"" << name << "\": {\"value\": " << value << "}";
    };
    text << "{\"configVersion\": \"3.0\", \"serial\": \"LKG-" << device.name << "\"";
    field("pitch", device.pitch);
    field("slope", device.slope);
    field("center", device.center);
    field("viewCone", device.view_cone);
    field("DPI", device.dpi);
    field("screenW", device.width);
    field("screenH", device.height);
    field("invView", flips.inverted);
    field("flipImageX", flips.x);
    field("flipImageY", flips.y);
    field("flipSubp", flips.subpixels);
    field("CellPatternMode", device.mode);
    text << ", \"subpixelCells\": [";
    const char* const names[] = {"ROffsetX", "ROffsetY", "GOffsetX",
                                 "GOffsetY", "BOffsetX", "BOffsetY"};
    for (std::size_t cell = 0; cell < device.cells.size(); ++cell)
        for (int k = 0; k < 6; ++k)
            text << (k > 0      ? ", "
                     : cell > 0 ? "}, {"
                                : "{")
                 << "\"" << names[k] << "\": " << device.cells[cell][k];
    text << (device.cells.empty() ? "]}" : "}]}");
    return text.str();
}

} // namespace looking_glass_devices

#endif
