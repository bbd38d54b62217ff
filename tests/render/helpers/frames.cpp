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
// frames oracle OURS ORACLE MASK FAR pixels that MASK calls empty (0; - is not compared) are exactly 0 in OURS; of the others
//                                    writes those that differ by more than 2/255 into FAR, "i j" lines; at most 0.5% may
// frames masked-alike A ORACLE MASK RMSE  like alike, for the pixels that MASK calls imaged (1)
// frames edges OURS AROUND FAR       for each pixel of FAR the row of AROUND (oracle around) holds its neighbourhood: OURS has
//                                    to lie within what is seen there, at most one pixel away, give or take a quarter of the range
//                                    (at a silhouette of glass the range of a few samples is not all); prints the worst radius
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

bool oracle(const Frame& ours, const Frame& theirs, const std::string& mask_name, const std::string& far_name)
{
    need_same_size(ours, theirs);
    std::ifstream mask(mask_name);
    std::ofstream far(far_name);
    long imaged = 0, empty = 0, differ = 0, not_black = 0, exact = 0;
    int most = 0;
    for (int j = 0; j < ours.height; j++) {
        std::string row;
        mask >> row;
        if (row.size() != std::size_t(ours.width)) throw std::runtime_error(mask_name + ": wrong size");
        for (int i = 0; i < ours.width; i++) {
            const Pixel& p = ours.at(i, j);
            if (row[i] == '-') continue; // not compared
            if (row[i] == '0') {
                empty++;
                // Black, and transparent where the frame has an alpha channel.
                const bool black = p[0] == 0 && p[1] == 0 && p[2] == 0 && p[3] == (ours.channels == 4 ? 0 : 65535);
                if (!black && !not_black++) std::cout << "not empty: " << i << ' ' << j << '\n';
                continue;
            }
            imaged++;
            const int d = difference(p, theirs.at(i, j));
            exact += d == 0;
            most = std::max(most, d);
            if (d > tolerance) differ++, far << i << ' ' << j << '\n';
        }
    }
    std::cout << imaged << " imaged, " << exact << " equal, " << differ << " by more than 2/255, at most " << most / 257.0
              << "/255; " << empty << " empty, of which not black: " << not_black << '\n';
    return not_black == 0 && differ <= 0.005 * ours.pixels.size();
}

bool edges(const Frame& ours, const std::string& around_name, const std::string& far_name)
{
    std::vector<std::array<int, 2>> places;
    std::ifstream far(far_name);
    for (int i, j; far >> i >> j;) places.push_back({i, j});
    const Frame around = read_oracle(around_name, int(places.size()));
    int row = 0, bad = 0;
    double worst = 0;
    for (const auto [i, j] : places) {
        const Pixel p = ours.at(i, j);
        Pixel low = around.at(0, row), high = low;
        double radius = 0;
        for (int ring = 0; ring < 3 && radius == 0; ring++) {
            for (int n = 0; n < 8; n++)
                for (int c = 0; c < 4; c++) {
                    low[c] = std::min(low[c], around.at(1 + ring * 8 + n, row)[c]);
                    high[c] = std::max(high[c], around.at(1 + ring * 8 + n, row)[c]);
                }
            bool within = true;
            for (int c = 0; c < 4; c++) {
                const int slack = tolerance + (high[c] - low[c]) / 4;
                within = within && p[c] >= low[c] - slack && p[c] <= high[c] + slack;
            }
            if (within) radius = std::array<double, 3>{0.02, 0.2, 1}[ring];
        }
        if (radius == 0) { bad++; std::cout << "not at an edge: " << i << ' ' << j << '\n'; }
        worst = std::max(worst, radius);
        row++;
    }
    std::cout << row << " differing pixels, " << bad << " of them not at an edge; the others within " << worst << " pixel of one\n";
    return bad == 0;
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
    if (is("near", 4)) return near(frame(1), frame(2), std::stod(w[3]), std::stod(w[4]));
    if (is("alike", 3)) return alike(frame(1), frame(2), std::stod(w[3]));
    if (is("masked-alike", 4)) {
        const Frame a = frame(1);
        return masked_alike(a, read_oracle(w[2], a.height), w[3], std::stod(w[4]));
    }
    if (is("oracle", 4)) {
        const Frame ours = frame(1);
        return oracle(ours, read_oracle(w[2], ours.height), w[3], w[4]);
    }
    if (is("edges", 3)) return edges(frame(1), w[2], w[3]);
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
