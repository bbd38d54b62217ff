// SPDX-License-Identifier: AGPL-3.0-or-later
// What the files of the comparer `frames` share; the head of frames.cpp says what it is told to do.
#ifndef TESTS_RENDER_HELPERS_FRAMES_H
#define TESTS_RENDER_HELPERS_FRAMES_H

#include <array>
#include <cstddef>
#include <functional>
#include <string>
#include <vector>

namespace frames {

using Pixel = std::array<int, 4>; ///< RGBA, 0 to 65535

struct Frame {
    int width = 0, height = 0, bits = 0, channels = 0;
    std::vector<Pixel> pixels;
    const Pixel& at(int i, int j) const { return pixels[std::size_t(j) * width + i]; }
};

/// A pixel's column and row; those of the lines of `oracle mirrored` are -1 where there is none.
struct Place {
    int i, j;
};

/// One of the frames whose mean is compared with.
struct Part {
    std::array<double, 4> weights{}; ///< red, green, blue, alpha
    Frame frame;
    std::vector<std::string> mask;
};

// frames_files.cpp

/// Any PNG, as 16-bit RGBA.
Frame read_frame(const std::string& name);
/// POV-Ray's mesh_camera shows its row of faces j in the frame's row j + 1 (and its row 0 twice):
/// the oracle's frames are one row higher, and lose their first row here.
Frame read_oracle(const std::string& name, int height);
/// Writes `to`: each pixel is that of `from` at its place, and all else is as in `from`.
void rerecord(const std::string& from, const std::vector<Place>& places, const std::string& to);
/// "i j" lines.
std::vector<Place> read_places(const std::string& name);
/// A mask's rows.
std::vector<std::string> read_mask(const std::string& name);
/// Which of so many pixels the mask calls imaged (1), in their order.
std::vector<std::size_t> read_imaged(const std::string& mask_name, std::size_t pixels);

// frames_compare.cpp

/// Between the channels that differ most.
int difference(const Pixel& a, const Pixel& b);
/// Else says so and throws 1, the exit status.
void need_same_size(const Frame& a, const Frame& b);
/// Counts pixels for which `of(i, j)` differs from B's.
bool all_equal(const Frame& b, const std::function<Pixel(int, int)>& of);
/// Whether at least `fraction` of the pixels differ by no more than `within`/255 in any channel.
bool near(const Frame& a, const Frame& b, double within, double fraction);
/// Whether the root mean square difference is at most `limit`/255.
bool alike(const Frame& a, const Frame& b, double limit);
/// The same over the imaged pixels.
bool masked_alike(const Frame& a, const Frame& b, const std::string& mask_name, double limit);
/// Prints the root mean square difference over the imaged pixels.
bool error(const Frame& a, const Frame& b, const std::string& mask_name);
/// Whether, over the imaged pixels, the brightness of `where` correlates with the difference by
/// `least` or more.
bool points_at(const Frame& where, const Frame& a, const Frame& b, const std::string& mask_name,
               double least);
/// The rectangle whose top-left pixel is (x, y).
Frame part(const Frame& a, int x, int y, int width, int height);
/// The means of the squares of n by n pixels, the middle one counted twice.
Frame shrink(const Frame& a, int n);

// frames_oracle.cpp

/// Of the words from `from` on, three a part, whose frames are of this height.
std::vector<Part> read_parts(const std::vector<std::string>& w, std::size_t from, int height);
/// Whether ours is the parts' mean, but for few pixels; writes their places to the file `far_name`.
bool oracle(const Frame& ours, const std::string& far_name, const std::vector<Part>& parts);
/// Whether ours lies, at each place, within what the places' rows of the parts' frames show of its
/// neighbourhood.
bool edges(const Frame& ours, const std::vector<Place>& places, const std::vector<Part>& parts);
/// Whether two of our frames differ from two of the oracle's by chance alone; in the channel
/// `only`, or in all if < 0.
bool unbiased(const std::array<Frame, 4>& frames, const std::string& mask_name, int only);

} // namespace frames

#endif
