// SPDX-License-Identifier: AGPL-3.0-or-later
// Compares frame with frame: all pixels, or those that a mask calls imaged.
#include "frames.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <iostream>
#include <stdexcept>

namespace frames {

int difference(const Pixel& a, const Pixel& b)
{
    int most = 0;
    for (int c = 0; c < 4; c++)
        most = std::max(most, std::abs(a[c] - b[c]));
    return most;
}

void need_same_size(const Frame& a, const Frame& b)
{
    if (a.width == b.width && a.height == b.height)
        return;
    std::cout << "sizes differ: " << a.width << 'x' << a.height << " and " << b.width << 'x'
              << b.height << '\n';
    throw 1;
}

bool all_equal(const Frame& b, const std::function<Pixel(int, int)>& of)
{
    long unequal = 0;
    int most = 0;
    for (int j = 0; j < b.height; j++)
        for (int i = 0; i < b.width; i++)
            if (const int d = difference(of(i, j), b.at(i, j)))
                unequal++, most = std::max(most, d);
    std::cout << unequal << " of " << b.pixels.size() << " pixels differ, at most by "
              << most / 257.0 << "/255\n";
    return unequal == 0;
}

bool near(const Frame& a, const Frame& b, double within, double fraction)
{
    need_same_size(a, b);
    std::size_t good = 0;
    for (std::size_t p = 0; p < a.pixels.size(); p++)
        good += difference(a.pixels[p], b.pixels[p]) <= within * 257;
    std::cout << good << " of " << a.pixels.size() << " pixels within " << within << "/255\n";
    return good >= fraction * a.pixels.size();
}

bool lit_around(const Frame& a, const Frame& b, double fraction)
{
    need_same_size(a, b);
    const auto lit = [](const Frame& f, int i, int j) {
        return i >= 0 && j >= 0 && i < f.width && j < f.height && f.at(i, j)[0] > 0;
    };
    int points = 0, dark = 0, all = 0, alone = 0;
    for (int j = 0; j < a.height; ++j)
        for (int i = 0; i < a.width; ++i) {
            points += lit(b, i, j);
            all += lit(a, i, j);
            dark += lit(b, i, j) && !lit(a, i, j);
            bool found = !lit(a, i, j);
            for (int n = 0; n < 25 && !found; ++n)
                found = lit(b, i + n % 5 - 2, j + n / 5 - 2);
            alone += !found;
        }
    std::cout << points << " lit, " << dark << " dark in the other, " << alone << " of its "
              << all << " alone\n";
    return points > 0 && dark == 0 && alone <= fraction * all;
}

bool alike(const Frame& a, const Frame& b, double limit)
{
    need_same_size(a, b);
    double sum = 0;
    for (std::size_t p = 0; p < a.pixels.size(); p++)
        for (int c = 0; c < 4; c++)
            sum += std::pow((a.pixels[p][c] - b.pixels[p][c]) / 257.0, 2);
    const double rmse = std::sqrt(sum / a.pixels.size() / 4);
    std::cout << "root mean square difference " << rmse << "/255\n";
    return rmse <= limit;
}

bool masked_alike(const Frame& a, const Frame& b, const std::string& mask_name, double limit)
{
    Frame x = a, y = b;
    x.pixels.clear();
    y.pixels.clear();
    for (const std::size_t p : read_imaged(mask_name, a.pixels.size()))
        x.pixels.push_back(a.pixels[p]), y.pixels.push_back(b.pixels[p]);
    return !x.pixels.empty() && alike(x, y, limit);
}

bool error(const Frame& a, const Frame& b, const std::string& mask_name)
{
    need_same_size(a, b);
    double sum = 0;
    long count = 0;
    for (const std::size_t p : read_imaged(mask_name, a.pixels.size()))
        for (int c = 0; c < 3; c++, count++)
            sum += std::pow((a.pixels[p][c] - b.pixels[p][c]) / 65535.0, 2);
    std::printf("%.9f\n", std::sqrt(sum / count));
    return count > 0;
}

bool points_at(const Frame& where, const Frame& a, const Frame& b, const std::string& mask_name,
               double least)
{
    need_same_size(where, a);
    need_same_size(a, b);
    double n = 0, x = 0, y = 0, xx = 0, yy = 0, xy = 0;
    for (const std::size_t p : read_imaged(mask_name, a.pixels.size())) {
        double squares = 0;
        for (int c = 0; c < 3; c++)
            squares += std::pow((a.pixels[p][c] - b.pixels[p][c]) / 65535.0, 2) / 3;
        const double bright = where.pixels[p][1] / 65535.0, error = std::sqrt(squares);
        n++, x += bright, y += error, xx += bright * bright, yy += error * error,
            xy += bright * error;
    }
    const double r = (xy - x * y / n) / std::sqrt((xx - x * x / n) * (yy - y * y / n));
    std::cout << "correlated by " << r << '\n';
    return r >= least;
}

Frame part(const Frame& a, int x, int y, int width, int height)
{
    Frame b = a;
    b.width = width;
    b.height = height;
    if (x + b.width > a.width || y + b.height > a.height)
        throw std::runtime_error("the part is larger than the whole");
    b.pixels.clear();
    for (int j = 0; j < b.height; j++)
        for (int i = 0; i < b.width; i++)
            b.pixels.push_back(a.at(x + i, y + j));
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
                b.pixels[std::size_t(j / n) * b.width + i / n][c] += a.at(i, j)[c] *
                                                                     (i % n == n / 2 &&
                                                                              j % n == n / 2
                                                                          ? 2
                                                                          : 1);
    for (Pixel& p : b.pixels)
        for (int& c : p)
            c = (c + n * n / 2) / (n * n + 1);
    return b;
}

} // namespace frames
