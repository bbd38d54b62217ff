// SPDX-License-Identifier: AGPL-3.0-or-later
// Compares frames with frames made from the oracle's rays.
#include "frames.h"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iostream>
#include <stdexcept>

namespace frames {
namespace {

const int tolerance = 2 * 257; // 2/255

double decoded(double v) // sRGB, 0 to 65535 -> linear
{
    v /= 65535;
    return v <= 0.04045 ? v / 12.92 : std::pow((v + 0.055) / 1.055, 2.4);
}

double encoded(double v)
{
    return 65535 * (v <= 0.0031308 ? v * 12.92 : 1.055 * std::pow(v, 1 / 2.4) - 0.055);
}

/// The mean colour at column x and row y of the parts' frames, over the parts that image pixel
/// (i, j). Channels that no part images are 0. With a single part it is that part's pixel, exactly.
Pixel mean(const std::vector<Part>& parts, int x, int y, int i, int j)
{
    Pixel result{};
    for (int c = 0; c < 4; c++) {
        double sum = 0, weight = 0;
        int last = 0;
        for (const Part& part : parts) {
            const double w = part.mask[j][i] == '1' ? part.weights[c] : 0;
            if (w == 0)
                continue;
            last = part.frame.at(x, y)[c];
            sum += w * decoded(last);
            weight += w;
        }
        if (weight > 0) {
            const double value = sum / weight;
            result[c] = std::fabs(value - decoded(last)) < 1e-12 ? last
                                                                 : int(std::lround(encoded(value)));
        }
    }
    // If the parts are single channels, alpha is not compared.
    if (parts[0].weights[3] == 0)
        result[3] = 65535;
    return result;
}

} // namespace

std::vector<Part> read_parts(const std::vector<std::string>& w, std::size_t from, int height)
{
    std::vector<Part> parts;
    if (from >= w.size() || (w.size() - from) % 3 != 0)
        throw std::runtime_error("parts are WEIGHT ORACLE MASK");
    for (; from < w.size(); from += 3) {
        Part part;
        const std::vector<std::string> colours = {"red", "green", "blue"};
        const auto colour = std::find(colours.begin(), colours.end(), w[from]);
        if (colour != colours.end())
            part.weights[colour - colours.begin()] = 1;
        else
            part.weights.fill(std::stod(w[from]));
        part.frame = read_oracle(w[from + 1], height);
        part.mask = read_mask(w[from + 2]);
        parts.push_back(part);
    }
    return parts;
}

bool oracle(const Frame& ours, const std::string& far_name, const std::vector<Part>& parts)
{
    std::ofstream far(far_name);
    long imaged = 0, empty = 0, differ = 0, not_black = 0, exact = 0;
    int most = 0;
    for (const Part& part : parts) {
        need_same_size(ours, part.frame);
        for (const std::string& row : part.mask)
            if (part.mask.size() != std::size_t(ours.height) ||
                row.size() != std::size_t(ours.width))
                throw std::runtime_error("a mask is of the wrong size");
    }
    for (int j = 0; j < ours.height; j++)
        for (int i = 0; i < ours.width; i++) {
            const Pixel& p = ours.at(i, j);
            const auto any = [&](char kind) {
                return std::any_of(parts.begin(), parts.end(),
                                   [&](const Part& part) { return part.mask[j][i] == kind; });
            };
            if (any('-'))
                continue; // not compared
            const Pixel wanted = mean(parts, i, j, i, j);
            for (int c = 0; c < 3; c++) { // a channel that nothing images
                const bool lit = std::any_of(parts.begin(), parts.end(), [&](const Part& part) {
                    return part.mask[j][i] == '1' && part.weights[c] > 0;
                });
                if (!lit && p[c] != 0 && !not_black++)
                    std::cout << "not empty: " << i << ' ' << j << '\n';
            }
            if (!any('1')) {
                empty++;
                // Transparent, where the frame has an alpha channel.
                if (p[3] != (ours.channels == 4 ? 0 : 65535) && !not_black++)
                    std::cout << "not empty: " << i << ' ' << j << '\n';
                continue;
            }
            imaged++;
            const int d = difference(p, wanted);
            exact += d == 0;
            most = std::max(most, d);
            if (d > tolerance)
                differ++, far << i << ' ' << j << '\n';
        }
    std::cout << imaged << " imaged, " << exact << " equal, " << differ
              << " by more than 2/255, at most " << most / 257.0 << "/255; " << empty
              << " empty, of which not black: " << not_black << '\n';
    return not_black == 0 && differ <= 0.005 * ours.pixels.size();
}

bool edges(const Frame& ours, const std::vector<Place>& places, const std::vector<Part>& parts)
{
    int row = 0, bad = 0;
    double worst = 0;
    const std::array<double, 4> radii{1e-5, 0.02, 0.2, 1}; // the first: the oracle's own precision
    for (const auto [i, j] : places) {
        const Pixel p = ours.at(i, j);
        std::vector<Part> low = parts,
                          high = parts; // each part's range so far, in the row's first column
        double radius = 0;
        for (int ring = 0; ring < int(radii.size()) && radius == 0; ring++) {
            bool within = true;
            for (std::size_t k = 0; k < parts.size(); k++)
                for (int n = 0; n < 8; n++)
                    for (int c = 0; c < 4; c++) {
                        int& least = low[k].frame.pixels[std::size_t(row) * 33][c];
                        int& most = high[k].frame.pixels[std::size_t(row) * 33][c];
                        least = std::min(least, parts[k].frame.at(1 + ring * 8 + n, row)[c]);
                        most = std::max(most, parts[k].frame.at(1 + ring * 8 + n, row)[c]);
                    }
            const Pixel below = mean(low, 0, row, i, j), above = mean(high, 0, row, i, j);
            for (int c = 0; c < 4; c++) {
                const int slack = tolerance + (above[c] - below[c]) / 4;
                within = within && p[c] >= below[c] - slack && p[c] <= above[c] + slack;
            }
            if (within)
                radius = radii[ring];
        }
        if (radius == 0) {
            bad++;
            std::cout << "not at an edge: " << i << ' ' << j << '\n';
        }
        worst = std::max(worst, radius);
        row++;
    }
    std::cout << row << " differing pixels, " << bad
              << " of them not at an edge; the others within " << worst << " pixel of one\n";
    return bad == 0;
}

bool unbiased(const std::array<Frame, 4>& frames, const std::string& mask_name, int only)
{
    const int first = only < 0 ? 0 : only, last = only < 0 ? 2 : only;
    const auto mask = read_mask(mask_name);
    double sum = 0, squares = 0;
    long count = 0, not_black = 0;
    for (const Frame& frame : frames)
        need_same_size(frames[0], frame);
    for (int j = 0; j < frames[0].height; j++)
        for (int i = 0; i < frames[0].width; i++) {
            if (mask.at(j).at(i) == '0')
                for (int c = first; c <= last; c++)
                    not_black += frames[0].at(i, j)[c] != 0 || frames[1].at(i, j)[c] != 0;
            if (mask[j][i] != '1')
                continue;
            // The channels count together, because they share the pixel's rays.
            double product = 0;
            for (int c = first; c <= last; c++)
                product += double(frames[0].at(i, j)[c] - frames[2].at(i, j)[c]) *
                           (frames[1].at(i, j)[c] - frames[3].at(i, j)[c]) / (257. * 257);
            product /= last - first + 1;
            sum += product;
            squares += product * product;
            count++;
        }
    const double mean = sum / count, error = std::sqrt((squares / count - mean * mean) / count);
    std::cout << count << " pixels, bias^2 " << mean << " +- " << error << " (1/255)^2, "
              << mean / error << " standard errors; not empty: " << not_black << '\n';
    return not_black == 0 && std::fabs(mean) <= 4 * error;
}

} // namespace frames
