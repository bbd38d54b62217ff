// SPDX-License-Identifier: AGPL-3.0-or-later
// Compares PNG frames for the tests of the renderer, with libpng alone.
//
// frames info A                      prints "WIDTHxHEIGHT BITS CHANNELS"
// frames same A B                    every pixel is equal (as 16-bit RGBA); prints how many are not
// frames near A B TOLERANCE FRACTION at least FRACTION of the pixels differ by no more than TOLERANCE/255 in any channel
// frames mirror A B                  A's rows, read backwards, are B's
// frames crop A B X Y W H            A and B are equal in the rectangle whose top-left pixel is (X, Y)
// frames shrink A N B TOLERANCE FRACTION  like near, for what +AM1 +A0.0 +RN makes of A's squares of N by N pixels, N odd: their mean, the
//                                    middle one counted twice; needs linear pixels (File_Gamma=1)
// frames alike A B RMSE              root mean square difference over all pixels and channels <= RMSE/255
// frames pixel A X Y                 prints "r g b a" in 0...65535
// frames rerecord A MIRRORED B       writes B: each pixel is A's at the place that its line of MIRRORED (oracle mirrored) names, else
//                                    black; all else, and what A says of itself, is A's
// frames rerecorded A B MIRRORED TOLERANCE FRACTION  like near, for the pixels that MIRRORED gives a place
// frames oracle OURS FAR PART...     a PART is three words: WEIGHT ORACLE MASK. The ORACLEs' mean by their weights, in linear light, over
//                                    those whose MASK calls the pixel imaged (1; 0 is empty, - is not compared) is what OURS ought to be.
//                                    WEIGHT red, green, blue: that channel alone, once. Pixels, and channels, that all MASKs call empty are
//                                    exactly 0 in OURS; of the others writes those that differ by more than 2/255 into FAR, "i j" lines; at
//                                    most 0.5% may
// frames edges OURS FAR PART...      for each pixel of FAR a row of the PARTs' frames, which are of oracle around, holds its neighbourhood:
//                                    OURS has to lie within the means of what is seen there, at most one pixel away, give or take a quarter
//                                    of the range (at a silhouette of glass the range of a few samples is not all); prints the worst radius
// frames masked-alike A ORACLE MASK RMSE  like alike, for the pixels that MASK calls imaged (1)
// frames error A B MASK              prints the root mean square difference (1 = full scale) of red, green and blue over the pixels
//                                    that MASK calls imaged (1)
// frames points-at WHERE A B MASK R  the brightness of WHERE goes with the difference of A from B: over the imaged pixels, the two
//                                    correlate by R or more
// frames unbiased A1 A2 ORACLE1 ORACLE2 MASK [CHANNEL]  pixels are means of random samples, and linear (File_Gamma=1): A's differ from
//                                    the ORACLE's by chance alone. The mean over the imaged pixels of (A1 - ORACLE1)(A2 - ORACLE2) is within
//                                    4 of its own standard errors of 0; empty pixels are black in A1 and A2. CHANNEL (0, 1, 2): that one alone
// Exit status: 0 yes, 1 no, 2 unreadable or wrong usage.
#include <png.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <fstream>
#include <iostream>
#include <stdexcept>
#include <string>
#include <vector>

namespace {

using Pixel = std::array<int, 4>; // RGBA, 0 to 65535
const int tolerance = 2 * 257;    // 2/255

struct Frame {
    int width = 0, height = 0, bits = 0, channels = 0;
    std::vector<Pixel> pixels;
    const Pixel& at(int i, int j) const { return pixels[std::size_t(j) * width + i]; }
};

void complain(png_structp, png_const_charp message) { throw std::runtime_error(message); }

Frame read_frame(const std::string& name)
{
    std::FILE* file = std::fopen(name.c_str(), "rb");
    if (!file) throw std::runtime_error(name + ": cannot be opened");
    Frame f;
    png_structp png = png_create_read_struct(PNG_LIBPNG_VER_STRING, nullptr, complain, complain);
    png_infop info = png_create_info_struct(png);
    try {
        png_init_io(png, file);
        png_read_info(png, info);
        f.width = png_get_image_width(png, info);
        f.height = png_get_image_height(png, info);
        f.bits = png_get_bit_depth(png, info);
        f.channels = png_get_channels(png, info);
        png_set_expand_16(png);
        png_set_gray_to_rgb(png);
        png_set_add_alpha(png, 0xffff, PNG_FILLER_AFTER);
        png_set_interlace_handling(png);
        png_read_update_info(png, info);
        const std::size_t row = png_get_rowbytes(png, info);
        if (row != std::size_t(f.width) * 8) throw std::runtime_error("not 16-bit RGBA after expansion");
        std::vector<png_byte> bytes(row * f.height);
        std::vector<png_bytep> rows;
        for (int j = 0; j < f.height; j++) rows.push_back(bytes.data() + row * j);
        png_read_image(png, rows.data());
        png_read_end(png, nullptr);
        f.pixels.resize(std::size_t(f.width) * f.height);
        for (std::size_t p = 0; p < f.pixels.size(); p++)
            for (int c = 0; c < 4; c++) f.pixels[p][c] = bytes[p * 8 + c * 2] << 8 | bytes[p * 8 + c * 2 + 1];
    } catch (const std::exception& error) {
        std::fclose(file);
        throw std::runtime_error(name + ": " + error.what());
    }
    png_destroy_read_struct(&png, &info, nullptr);
    std::fclose(file);
    return f;
}

struct Place { int i, j; };

/// Of every pixel; -1 where it has none.
std::vector<Place> read_mirrored(const std::string& name)
{
    std::vector<Place> places;
    std::ifstream in(name);
    for (Place place; in >> place.i >> place.j;) places.push_back(place);
    return places;
}

void rerecord(const std::string& from, const std::vector<Place>& places, const std::string& to)
{
    std::FILE* in = std::fopen(from.c_str(), "rb");
    std::FILE* out = std::fopen(to.c_str(), "wb");
    if (!in || !out) throw std::runtime_error(from + " or " + to + ": cannot be opened");
    png_structp reader = png_create_read_struct(PNG_LIBPNG_VER_STRING, nullptr, complain, complain);
    png_infop info = png_create_info_struct(reader), end = png_create_info_struct(reader);
    png_init_io(reader, in);
    png_read_info(reader, info);
    const int width = png_get_image_width(reader, info), height = png_get_image_height(reader, info);
    const std::size_t row = png_get_rowbytes(reader, info), pixel = row / width;
    if (places.size() != std::size_t(width) * height) throw std::runtime_error("not a place for every pixel of " + from);
    std::vector<png_byte> bytes(row * height), moved(bytes.size());
    std::vector<png_bytep> rows, moved_rows;
    for (int j = 0; j < height; j++) rows.push_back(bytes.data() + row * j), moved_rows.push_back(moved.data() + row * j);
    png_read_image(reader, rows.data());
    png_read_end(reader, end);
    for (std::size_t n = 0; n < places.size(); n++)
        if (places[n].i >= 0)
            std::copy_n(rows[places[n].j] + pixel * places[n].i, pixel, moved.begin() + pixel * n);
    png_structp writer = png_create_write_struct(PNG_LIBPNG_VER_STRING, nullptr, complain, complain);
    png_init_io(writer, out);
    png_write_info(writer, info);
    png_write_image(writer, moved_rows.data());
    png_write_end(writer, end);
    png_destroy_write_struct(&writer, nullptr);
    png_destroy_read_struct(&reader, &info, &end);
    std::fclose(in);
    std::fclose(out);
}

int difference(const Pixel& a, const Pixel& b)
{
    int most = 0;
    for (int c = 0; c < 4; c++) most = std::max(most, std::abs(a[c] - b[c]));
    return most;
}

/// POV-Ray's mesh_camera shows its row of faces j in the frame's row j + 1 (and its row 0 twice): the oracle's frames are
/// one row higher, and lose their first row here.
Frame read_oracle(const std::string& name, int height)
{
    Frame f = read_frame(name);
    if (f.height != height + 1) throw std::runtime_error(name + ": not one row more than the frame compared");
    f.pixels.erase(f.pixels.begin(), f.pixels.begin() + f.width);
    f.height--;
    return f;
}

void need_same_size(const Frame& a, const Frame& b)
{
    if (a.width == b.width && a.height == b.height) return;
    std::cout << "sizes differ: " << a.width << 'x' << a.height << " and " << b.width << 'x' << b.height << '\n';
    throw 1;
}

/// Counts pixels for which `of(i, j)` differs from B's.
template <class Of> bool all_equal(const Frame& b, Of of)
{
    long unequal = 0;
    int most = 0;
    for (int j = 0; j < b.height; j++)
        for (int i = 0; i < b.width; i++)
            if (const int d = difference(of(i, j), b.at(i, j))) unequal++, most = std::max(most, d);
    std::cout << unequal << " of " << b.pixels.size() << " pixels differ, at most by " << most / 257.0 << "/255\n";
    return unequal == 0;
}

bool near(const Frame& a, const Frame& b, double within, double fraction)
{
    need_same_size(a, b);
    std::size_t good = 0;
    for (std::size_t p = 0; p < a.pixels.size(); p++) good += difference(a.pixels[p], b.pixels[p]) <= within * 257;
    std::cout << good << " of " << a.pixels.size() << " pixels within " << within << "/255\n";
    return good >= fraction * a.pixels.size();
}

bool alike(const Frame& a, const Frame& b, double limit)
{
    need_same_size(a, b);
    double sum = 0;
    for (std::size_t p = 0; p < a.pixels.size(); p++)
        for (int c = 0; c < 4; c++) sum += std::pow((a.pixels[p][c] - b.pixels[p][c]) / 257.0, 2);
    const double rmse = std::sqrt(sum / a.pixels.size() / 4);
    std::cout << "root mean square difference " << rmse << "/255\n";
    return rmse <= limit;
}

bool masked_alike(const Frame& a, const Frame& b, const std::string& mask_name, double limit)
{
    Frame x = a, y = b;
    std::ifstream mask(mask_name);
    x.pixels.clear();
    y.pixels.clear();
    char imaged;
    for (std::size_t p = 0; p < a.pixels.size() && mask >> imaged; p++)
        if (imaged == '1') x.pixels.push_back(a.pixels[p]), y.pixels.push_back(b.pixels[p]);
    return !x.pixels.empty() && alike(x, y, limit);
}

bool error(const Frame& a, const Frame& b, const std::string& mask_name)
{
    need_same_size(a, b);
    std::ifstream mask(mask_name);
    double sum = 0;
    long count = 0;
    char imaged;
    for (std::size_t p = 0; p < a.pixels.size() && mask >> imaged; p++)
        for (int c = 0; imaged == '1' && c < 3; c++, count++) sum += std::pow((a.pixels[p][c] - b.pixels[p][c]) / 65535.0, 2);
    std::printf("%.9f\n", std::sqrt(sum / count));
    return count > 0;
}

bool points_at(const Frame& where, const Frame& a, const Frame& b, const std::string& mask_name, double least)
{
    need_same_size(where, a);
    need_same_size(a, b);
    std::ifstream mask(mask_name);
    double n = 0, x = 0, y = 0, xx = 0, yy = 0, xy = 0;
    char imaged;
    for (std::size_t p = 0; p < a.pixels.size() && mask >> imaged; p++) {
        if (imaged != '1') continue;
        double squares = 0;
        for (int c = 0; c < 3; c++) squares += std::pow((a.pixels[p][c] - b.pixels[p][c]) / 65535.0, 2) / 3;
        const double bright = where.pixels[p][1] / 65535.0, error = std::sqrt(squares);
        n++, x += bright, y += error, xx += bright * bright, yy += error * error, xy += bright * error;
    }
    const double r = (xy - x * y / n) / std::sqrt((xx - x * x / n) * (yy - y * y / n));
    std::cout << "correlated by " << r << '\n';
    return r >= least;
}

double decoded(double v) // sRGB, 0 to 65535 -> linear
{
    v /= 65535;
    return v <= 0.04045 ? v / 12.92 : std::pow((v + 0.055) / 1.055, 2.4);
}

double encoded(double v) { return 65535 * (v <= 0.0031308 ? v * 12.92 : 1.055 * std::pow(v, 1 / 2.4) - 0.055); }

/// One of the frames whose mean is compared with.
struct Part {
    std::array<double, 4> weights{}; ///< red, green, blue, alpha
    Frame frame;
    std::vector<std::string> mask;
};

std::vector<std::string> read_mask(const std::string& name)
{
    std::ifstream in(name);
    std::vector<std::string> rows;
    for (std::string row; in >> row;) rows.push_back(row);
    return rows;
}

std::vector<Part> read_parts(const std::vector<std::string>& w, std::size_t from, int height)
{
    std::vector<Part> parts;
    if (from >= w.size() || (w.size() - from) % 3 != 0) throw std::runtime_error("parts are WEIGHT ORACLE MASK");
    for (; from < w.size(); from += 3) {
        Part part;
        const std::vector<std::string> colours = {"red", "green", "blue"};
        const auto colour = std::find(colours.begin(), colours.end(), w[from]);
        if (colour != colours.end()) part.weights[colour - colours.begin()] = 1;
        else part.weights.fill(std::stod(w[from]));
        part.frame = read_oracle(w[from + 1], height);
        part.mask = read_mask(w[from + 2]);
        parts.push_back(part);
    }
    return parts;
}

/// The parts' mean of column x and row y in their frames, of those that image pixel (i, j); the channels of which none does
/// are 0. With a single part, its very pixel.
Pixel mean(const std::vector<Part>& parts, int x, int y, int i, int j)
{
    Pixel result{};
    for (int c = 0; c < 4; c++) {
        double sum = 0, weight = 0;
        int last = 0;
        for (const Part& part : parts) {
            const double w = part.mask[j][i] == '1' ? part.weights[c] : 0;
            if (w == 0) continue;
            last = part.frame.at(x, y)[c];
            sum += w * decoded(last);
            weight += w;
        }
        if (weight > 0) result[c] = std::fabs(sum / weight - decoded(last)) < 1e-12 ? last : int(std::lround(encoded(sum / weight)));
    }
    // Nothing of the parts' alpha is compared where they are channels.
    if (parts[0].weights[3] == 0) result[3] = 65535;
    return result;
}

bool oracle(const Frame& ours, const std::string& far_name, const std::vector<Part>& parts)
{
    std::ofstream far(far_name);
    long imaged = 0, empty = 0, differ = 0, not_black = 0, exact = 0;
    int most = 0;
    for (const Part& part : parts) {
        need_same_size(ours, part.frame);
        for (const std::string& row : part.mask)
            if (part.mask.size() != std::size_t(ours.height) || row.size() != std::size_t(ours.width)) throw std::runtime_error("a mask is of the wrong size");
    }
    for (int j = 0; j < ours.height; j++)
        for (int i = 0; i < ours.width; i++) {
            const Pixel& p = ours.at(i, j);
            const auto any = [&](char kind) {
                return std::any_of(parts.begin(), parts.end(), [&](const Part& part) { return part.mask[j][i] == kind; });
            };
            if (any('-')) continue; // not compared
            const Pixel wanted = mean(parts, i, j, i, j);
            for (int c = 0; c < 3; c++) { // a channel that nothing images
                const bool lit = std::any_of(parts.begin(), parts.end(), [&](const Part& part) { return part.mask[j][i] == '1' && part.weights[c] > 0; });
                if (!lit && p[c] != 0 && !not_black++) std::cout << "not empty: " << i << ' ' << j << '\n';
            }
            if (!any('1')) {
                empty++;
                // Transparent, where the frame has an alpha channel.
                if (p[3] != (ours.channels == 4 ? 0 : 65535) && !not_black++) std::cout << "not empty: " << i << ' ' << j << '\n';
                continue;
            }
            imaged++;
            const int d = difference(p, wanted);
            exact += d == 0;
            most = std::max(most, d);
            if (d > tolerance) differ++, far << i << ' ' << j << '\n';
        }
    std::cout << imaged << " imaged, " << exact << " equal, " << differ << " by more than 2/255, at most " << most / 257.0
              << "/255; " << empty << " empty, of which not black: " << not_black << '\n';
    return not_black == 0 && differ <= 0.005 * ours.pixels.size();
}

std::vector<std::array<int, 2>> read_places(const std::string& name)
{
    std::vector<std::array<int, 2>> places;
    std::ifstream far(name);
    for (int i, j; far >> i >> j;) places.push_back({i, j});
    return places;
}

bool edges(const Frame& ours, const std::vector<std::array<int, 2>>& places, const std::vector<Part>& parts)
{
    int row = 0, bad = 0;
    double worst = 0;
    const std::array<double, 4> radii{1e-5, 0.02, 0.2, 1}; // the first stands for the oracle's own precision
    for (const auto [i, j] : places) {
        const Pixel p = ours.at(i, j);
        std::vector<Part> low = parts, high = parts; // each part's range so far, in the row's first column
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
            if (within) radius = radii[ring];
        }
        if (radius == 0) { bad++; std::cout << "not at an edge: " << i << ' ' << j << '\n'; }
        worst = std::max(worst, radius);
        row++;
    }
    std::cout << row << " differing pixels, " << bad << " of them not at an edge; the others within " << worst << " pixel of one\n";
    return bad == 0;
}

bool unbiased(const std::array<Frame, 4>& frames, const std::string& mask_name, int only)
{
    const int first = only < 0 ? 0 : only, last = only < 0 ? 2 : only;
    const auto mask = read_mask(mask_name);
    double sum = 0, squares = 0;
    long count = 0, not_black = 0;
    for (const Frame& frame : frames) need_same_size(frames[0], frame);
    for (int j = 0; j < frames[0].height; j++)
        for (int i = 0; i < frames[0].width; i++) {
            if (mask.at(j).at(i) == '0')
                for (int c = first; c <= last; c++) not_black += frames[0].at(i, j)[c] != 0 || frames[1].at(i, j)[c] != 0;
            if (mask[j][i] != '1') continue;
            // The channels go together: they share the pixel's rays.
            double product = 0;
            for (int c = first; c <= last; c++)
                product += double(frames[0].at(i, j)[c] - frames[2].at(i, j)[c]) * (frames[1].at(i, j)[c] - frames[3].at(i, j)[c]) / (257. * 257);
            product /= last - first + 1;
            sum += product;
            squares += product * product;
            count++;
        }
    const double mean = sum / count, error = std::sqrt((squares / count - mean * mean) / count);
    std::cout << count << " pixels, bias^2 " << mean << " +- " << error << " (1/255)^2, " << mean / error << " standard errors; not empty: "
              << not_black << '\n';
    return not_black == 0 && std::fabs(mean) <= 4 * error;
}

/// The rectangle that the words 3 to 6 give.
Frame part(const Frame& a, const std::vector<std::string>& w)
{
    Frame b = a;
    const int x = std::stoi(w[3]), y = std::stoi(w[4]);
    b.width = std::stoi(w[5]);
    b.height = std::stoi(w[6]);
    if (x + b.width > a.width || y + b.height > a.height) throw std::runtime_error("the part is larger than the whole");
    b.pixels.clear();
    for (int j = 0; j < b.height; j++)
        for (int i = 0; i < b.width; i++) b.pixels.push_back(a.at(x + i, y + j));
    return b;
}

Frame shrink(const Frame& a, int n)
{
    Frame b = a;
    b.width = a.width / n;
    b.height = a.height / n;
    b.pixels.assign(std::size_t(b.width) * b.height, Pixel{});
    for (int j = 0; j < b.height * n; j++)
        for (int i = 0; i < b.width * n; i++)
            for (int c = 0; c < 4; c++)
                b.pixels[std::size_t(j / n) * b.width + i / n][c] += a.at(i, j)[c] * (i % n == n / 2 && j % n == n / 2 ? 2 : 1);
    for (Pixel& p : b.pixels)
        for (int& c : p) c = (c + n * n / 2) / (n * n + 1);
    return b;
}

bool run(const std::vector<std::string>& w)
{
    const auto is = [&](const char* name, std::size_t count) { return w.size() == count + 1 && w[0] == name; };
    const auto frame = [&](int n) { return read_frame(w[n]); };
    if (is("info", 1)) {
        const Frame a = frame(1);
        std::cout << a.width << 'x' << a.height << ' ' << a.bits << ' ' << a.channels << '\n';
        return true;
    }
    if (is("same", 2)) {
        const Frame a = frame(1), b = frame(2);
        need_same_size(a, b);
        return all_equal(b, [&](int i, int j) { return a.at(i, j); });
    }
    if (is("mirror", 2)) {
        const Frame a = frame(1), b = frame(2);
        need_same_size(a, b);
        return all_equal(b, [&](int i, int j) { return a.at(a.width - 1 - i, j); });
    }
    if (is("crop", 6)) {
        const Frame a = frame(1), b = frame(2);
        need_same_size(a, b);
        return all_equal(part(b, w), [&](int i, int j) { return a.at(std::stoi(w[3]) + i, std::stoi(w[4]) + j); });
    }
    if (is("shrink", 5)) return near(shrink(frame(1), std::stoi(w[2])), frame(3), std::stod(w[4]), std::stod(w[5]));
    if (is("pixel", 3)) {
        const Frame a = frame(1);
        const Pixel p = a.at(std::stoi(w[2]), std::stoi(w[3]));
        std::cout << p[0] << ' ' << p[1] << ' ' << p[2] << ' ' << p[3] << '\n';
        return true;
    }
    if (is("rerecord", 3)) {
        rerecord(w[1], read_mirrored(w[2]), w[3]);
        return true;
    }
    if (is("rerecorded", 5)) {
        Frame a = frame(1), b = frame(2);
        const auto places = read_mirrored(w[3]);
        std::vector<Pixel> x, y;
        for (std::size_t n = 0; n < places.size(); n++)
            if (places[n].i >= 0) x.push_back(a.pixels.at(n)), y.push_back(b.pixels.at(n));
        a.pixels = x;
        b.pixels = y;
        return near(a, b, std::stod(w[4]), std::stod(w[5]));
    }
    if (is("near", 4)) return near(frame(1), frame(2), std::stod(w[3]), std::stod(w[4]));
    if (is("alike", 3)) return alike(frame(1), frame(2), std::stod(w[3]));
    if (is("masked-alike", 4)) {
        const Frame a = frame(1);
        return masked_alike(a, read_oracle(w[2], a.height), w[3], std::stod(w[4]));
    }
    if (is("points-at", 5)) return points_at(frame(1), frame(2), frame(3), w[4], std::stod(w[5]));
    if (is("error", 3)) return error(frame(1), frame(2), w[3]);
    if (w.size() > 2 && w[0] == "oracle") {
        const Frame ours = frame(1);
        return oracle(ours, w[2], read_parts(w, 3, ours.height));
    }
    if (w.size() > 2 && w[0] == "edges") {
        const auto places = read_places(w[2]);
        return edges(frame(1), places, read_parts(w, 3, int(places.size())));
    }
    if (is("unbiased", 5) || is("unbiased", 6)) {
        const Frame ours = frame(1);
        return unbiased({ours, frame(2), read_oracle(w[3], ours.height), read_oracle(w[4], ours.height)}, w[5],
                        w.size() > 6 ? std::stoi(w[6]) : -1);
    }
    throw std::runtime_error("wrong usage; the head of frames.cpp says what there is");
}

} // namespace

int main(int argc, char** argv)
{
    try {
        return run({argv + 1, argv + argc}) ? 0 : 1;
    } catch (int status) {
        return status;
    } catch (const std::exception& error) {
        std::cerr << "frames: " << error.what() << '\n';
        return 2;
    }
}
