// SPDX-License-Identifier: AGPL-3.0-or-later
// Random pictures and temporary files for the tests of integral/io.
#ifndef TESTS_UNIT_PICTURE_FILES_H
#define TESTS_UNIT_PICTURE_FILES_H

#include "integral/frame/image.h"

#include <boost/test/unit_test.hpp>

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <random>
#include <string>
#include <type_traits>
#include <vector>

namespace picture_files {

using namespace integral;

/// A temporary folder, which the destructor removes.
struct Folder {
    std::string path;
    Folder()
    {
        char name[] = "/tmp/integral-io-XXXXXX";
        BOOST_REQUIRE(mkdtemp(name));
        path = name;
    }
    ~Folder() { std::filesystem::remove_all(path); }
    std::string operator/(const std::string& name) const { return path + "/" + name; }
    std::vector<std::string> names() const
    {
        std::vector<std::string> all;
        for (const auto& entry : std::filesystem::directory_iterator(path))
            all.push_back(entry.path().filename());
        return all;
    }
};

const Encoding linear{Encoding::Kind::linear, 1};

/// A picture of random samples: integers of the whole range, floats of many magnitudes. With a
/// `limit` > 0: whole numbers below it, which the formats can compress.
template <class Sample>
Image noise(int width, int height, int channels, Encoding encoding, unsigned limit = 0,
            unsigned seed = 7)
{
    std::mt19937 random(seed);
    Image image = make_image<Sample>(width, height, channels, encoding);
    for (Sample& s : std::get<std::vector<Sample>>(image.samples))
        s = limit > 0 ? Sample(random() % limit)
            : std::is_integral<Sample>::value
                ? Sample(random())
                : Sample(std::ldexp(double(random()), int(random() % 40) - 36));
    return image;
}

inline std::string bytes_of(const std::string& path)
{
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
}

inline void write_bytes(const std::string& path, const std::string& bytes)
{
    std::ofstream(path, std::ios::binary) << bytes;
}

} // namespace picture_files

#endif
