// SPDX-License-Identifier: AGPL-3.0-or-later
// Functions that the files of the program `frames` share; the head of frames.cpp has its usage.
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

/// A pixel's column and row; both are -1 where `oracle mirrored` has found no pixel.
struct Place {
    int i, j;
};

/// One of the frames whose mean our frame should be.
struct Part {
    std::array<double, 4> weights{}; ///< red, green, blue, alpha
    Frame frame;
    std::vector<std::string> mask;
};

// frames_files.cpp

/// Reads any PNG as 16-bit RGBA.
Frame read_frame(const std::string& name);
/// POV-Ray's mesh_camera shows its row of faces j in the frame's row j + 1 (and its row 0 twice):
/// the oracle's frames are one row higher, and lose their first row here.
Frame read_oracle(const std::string& name, int height);
/// Writes `to`: each pixel is the pixel of `from` at its place; everything else in the file is as
/// in `from`.
void rerecord(const std::string& from, const std::vector<Place>& places, const std::string& to);
/// Reads a file of "i j" lines.
std::vector<Place> read_places(const std::string& name);
/// Reads the rows of a mask.
std::vector<std::string> read_mask(const std::string& name);
/// For each pixel, row by row, whether the mask calls it imaged (1).
std::vector<std::size_t> read_imaged(const std::string& mask_name, std::size_t pixels);

// frames_compare.cpp

/// The difference of the channel that differs most.
int difference(const Pixel& a, const Pixel& b);
/// Checks that both frames have the same size. If not, says so and throws 1, the exit status.
void need_same_size(const Frame& a, const Frame& b);
/// Counts pixels for which `of(i, j)` differs from B's.
bool all_equal(const Frame& b, const std::function<Pixel(int, int)>& of);
/// Whether at least `fraction` of the pixels differ by no more than `within`/255 in any channel.
bool near(const Frame& a, const Frame& b, double within, double fraction);
/// Whether B's lit pixels are lit in A, and at most `fraction` of A's are farther than two pixels
/// from any of B's.
bool lit_around(const Frame& a, const Frame& b, double fraction);
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

/// Reads the parts that are named by the words from `from` on, three words a part. Their frames
/// have this height.
std::vector<Part> read_parts(const std::vector<std::string>& w, std::size_t from, int height);
/// Whether our frame is the parts' mean except in a few pixels; writes the places of these pixels
/// to the file `far_name`.
bool oracle(const Frame& ours, const std::string& far_name, const std::vector<Part>& parts);
/// Whether our frame is, at each place, within the range of colours in the neighbourhood, which the
/// place's row of the parts' frames shows.
bool edges(const Frame& ours, const std::vector<Place>& places, const std::vector<Part>& parts);
/// Whether two of our frames differ from two of the oracle's by chance alone; in the channel
/// `only`, or in all if < 0.
bool unbiased(const std::array<Frame, 4>& frames, const std::string& mask_name, int only);

} // namespace frames

#endif
