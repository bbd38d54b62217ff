// SPDX-License-Identifier: AGPL-3.0-or-later
// Reads depth frames for the tests of the renderer, with OpenEXR alone.
//
// depths count FILE    prints "WIDTHxHEIGHT, SEEN with a surface, OPEN without, EMPTY"
// depths range FILE    prints the least and the greatest depth of a surface, mm
// depths pixels FILE [CHANNEL]
//                      prints for every pixel, row by row, a line with its depth, "inf" or "empty";
//                      of channel Z if none is given
// depths within FILE MM
//                      prints how many pixels show a surface at most MM mm from the sheet, how many
//                      show none, and how many are imaged
// depths near FILE ORACLE MASK LOW HIGH TOLERANCE FRACTION
//                      compares with the frame ORACLE, whose colours show depths in linear light:
//                      green is 0 at LOW mm and 1 at HIGH; red is 1 where there is no surface. Of
//                      the pixels that MASK calls imaged (1), at least FRACTION must have that
//                      depth in FILE, within TOLERANCE mm. The other pixels must be empty.
// Exit status: 0 yes, 1 no, 2 unreadable or wrong usage.
#include "tests/render/helpers/frames.h"

#include <ImfArray.h>
#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfInputFile.h>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <limits>
#include <stdexcept>

namespace {

struct Depths {
    int width = 0, height = 0;
    std::vector<float> z, alpha;
};

Depths read_depths(const char* name, const char* values)
{
    Imf::InputFile file(name);
    const auto window = file.header().dataWindow();
    Depths d;
    d.width = window.max.x - window.min.x + 1;
    d.height = window.max.y - window.min.y + 1;
    d.z.resize(std::size_t(d.width) * d.height);
    d.alpha = d.z;
    for (const char* channel : {values, "A"})
        if (!file.header().channels().findChannel(channel))
            throw std::runtime_error(std::string(name) + " has no channel " + channel);
    Imf::FrameBuffer buffer;
    buffer.insert(values,
                  Imf::Slice(Imf::FLOAT, reinterpret_cast<char*>(d.z.data()), 4, 4 * d.width));
    buffer.insert("A",
                  Imf::Slice(Imf::FLOAT, reinterpret_cast<char*>(d.alpha.data()), 4, 4 * d.width));
    file.setFrameBuffer(buffer);
    file.readPixels(window.min.y, window.max.y);
    return d;
}

bool near(const Depths& d, const frames::Frame& oracle, const std::string& mask_name, double low,
          double high, double tolerance, double fraction)
{
    const auto imaged = frames::read_imaged(mask_name, d.z.size());
    std::vector<bool> is_imaged(d.z.size());
    long good = 0, open = 0;
    double worst = 0;
    for (const std::size_t k : imaged) {
        is_imaged[k] = true;
        const auto& pixel = oracle.pixels[k];
        const bool surface = pixel[0] < 32768;
        open += !surface;
        const double expected = low + (high - low) * pixel[1] / 65535.0,
                     off = std::fabs(d.z[k] - expected);
        const bool alike = d.alpha[k] == 1 &&
                           (surface ? off <= tolerance
                                    : d.z[k] == std::numeric_limits<float>::infinity());
        good += alike;
        if (alike && surface)
            worst = std::max(worst, off);
    }
    for (std::size_t k = 0; k < d.z.size(); ++k)
        if (!is_imaged[k] && (d.alpha[k] != 0 || d.z[k] != 0)) {
            std::cout << "pixel " << k % d.width << ", " << k / d.width << " should be empty\n";
            return false;
        }
    std::cout << good << " of " << imaged.size() << " depths agree, to " << worst << " mm; " << open
              << " are open\n";
    return !imaged.empty() && good >= fraction * imaged.size();
}

bool run(int argc, char** argv)
{
    const std::string command = argc > 2 ? argv[1] : "";
    if (command != "count" && command != "range" && command != "pixels" &&
        !(command == "within" && argc == 4) && !(command == "near" && argc == 9))
        throw std::runtime_error("usage: see the head of depths.cpp");
    const Depths d = read_depths(argv[2], command == "pixels" && argc > 3 ? argv[3] : "Z");
    if (command == "near")
        return near(d, frames::read_oracle(argv[3], d.height), argv[4], std::stod(argv[5]),
                    std::stod(argv[6]), std::stod(argv[7]), std::stod(argv[8]));
    if (command == "pixels") {
        for (std::size_t k = 0; k < d.z.size(); ++k)
            d.alpha[k] == 1 ? std::cout << d.z[k] << "\n" : std::cout << "empty\n";
        return true;
    }
    const double reach = command == "within" ? std::stod(argv[3]) : 0;
    long seen = 0, open = 0, empty = 0, within = 0;
    float least = std::numeric_limits<float>::infinity(), most = -least;
    for (std::size_t k = 0; k < d.z.size(); ++k) {
        const bool lit = d.alpha[k] == 1, surface = lit && std::isfinite(d.z[k]);
        empty += !lit;
        open += lit && !surface;
        seen += surface;
        within += surface && std::fabs(d.z[k]) <= reach;
        if (surface) {
            least = std::min(least, d.z[k]);
            most = std::max(most, d.z[k]);
        }
    }
    if (command == "count")
        std::cout << d.width << "x" << d.height << ", " << seen << ", " << open << ", " << empty
                  << "\n";
    else if (command == "within")
        std::cout << within << " " << open << " " << seen + open << "\n";
    else
        std::cout << least << " " << most << "\n";
    return true;
}

} // namespace

int main(int argc, char** argv)
try {
    return run(argc, argv) ? 0 : 1;
} catch (int status) {
    return status;
} catch (const std::exception& error) {
    std::cerr << "depths: " << error.what() << "\n";
    return 2;
}
