// SPDX-License-Identifier: AGPL-3.0-or-later
// Compares PNG frames for the tests of the renderer, with libpng alone. Its command lines:
//
// frames info A            prints "WIDTHxHEIGHT BITS CHANNELS"
// frames same A B          every pixel is equal (as 16-bit RGBA); prints how many are not
// frames near A B TOLERANCE FRACTION
//                          at least FRACTION of the pixels differ by no more than TOLERANCE/255 in
//                          any channel
// frames mirror A B        A's rows, read backwards, are B's
// frames crop A B X Y W H  A and B are equal in the rectangle whose top-left pixel is (X, Y)
// frames shrink A N B TOLERANCE FRACTION
//                          like near, for B and A reduced by N as +AM1 +A0.0 +RN does: a pixel is
//                          the mean of N by N pixels of A, with the middle one counted twice. N is
//                          odd; pixels must be linear (File_Gamma=1)
// frames alike A B RMSE    root mean square difference over all pixels and channels <= RMSE/255
// frames pixel A X Y       prints "r g b a" in 0...65535
// frames pixels A          prints the same for every pixel, row by row, a line each
// frames samples A         prints R, G and B of every pixel, row by row, a byte each
// frames rerecord A MIRRORED B
//                          writes B: each pixel is the pixel of A whose place the pixel's line of
//                          MIRRORED (oracle mirrored) gives, or black if there is none. Everything
//                          else in the file, metadata included, is A's
// frames rerecorded A B MIRRORED TOLERANCE FRACTION
//                          like near, for the pixels that MIRRORED gives a place
// frames oracle OURS FAR PART...
//                          compares OURS with the mean of the PARTs' frames. A PART is three words:
//                          WEIGHT ORACLE MASK. The mean is weighted, in linear light, and taken
//                          over the ORACLEs whose MASK calls the pixel imaged (1; 0 is empty, - is
//                          not compared). If WEIGHT is red, green or blue, that ORACLE gives that
//                          channel alone. Pixels and channels that all MASKs call empty must be
//                          exactly 0 in OURS. Writes the "i j" of the others that differ by more
//                          than 2/255 into FAR; at most 0.5% may
// frames edges OURS FAR PART...
//                          for pixels at the edges of objects. Each pixel of FAR has one row in the
//                          PARTs' frames (made by oracle around), which holds what is seen in the
//                          pixel's neighbourhood. OURS must lie within the range of the means of
//                          what is seen up to one pixel away, widened by a quarter, because a few
//                          samples at a silhouette of glass do not show the whole range. Prints the
//                          worst radius
// frames masked-alike A ORACLE MASK RMSE
//                          like alike, for the pixels that MASK calls imaged (1)
// frames error A B MASK    prints the root mean square difference (1 = full scale) of red, green
//                          and blue over the pixels that MASK calls imaged (1)
// frames points-at WHERE A B MASK R
//                          over the imaged pixels, the brightness of WHERE and the difference of A
//                          from B have a correlation of R or more
// frames unbiased A1 A2 ORACLE1 ORACLE2 MASK [CHANNEL]
//                          the frames A1 and A2, whose pixels are means of random samples, differ
//                          from the ORACLEs by chance alone. The mean over the imaged pixels of
//                          (A1 - ORACLE1)(A2 - ORACLE2) must be within 4 of its own standard errors
//                          of 0; empty pixels must be black in A1 and A2. Pixels must be linear
//                          (File_Gamma=1). CHANNEL (0, 1, 2): only this channel is compared
// frames lit-around A B FRACTION
//                          every pixel that is lit in B is lit in A, and of A's at most FRACTION
//                          are farther than two pixels from any of B's. Prints how many are
// Exit status: 0 yes, 1 no, 2 unreadable or wrong usage.
#include "frames.h"

#include <iostream>
#include <stdexcept>

namespace frames {
namespace {

void print(const Pixel& p) { std::cout << p[0] << ' ' << p[1] << ' ' << p[2] << ' ' << p[3] << '\n'; }

bool run(const std::vector<std::string>& w)
{
    const auto is = [&](const char* name, std::size_t count) {
        return w.size() == count + 1 && w[0] == name;
    };
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
        const int x = std::stoi(w[3]), y = std::stoi(w[4]);
        return all_equal(part(b, x, y, std::stoi(w[5]), std::stoi(w[6])),
                         [&](int i, int j) { return a.at(x + i, y + j); });
    }
    if (is("shrink", 5))
        return near(shrink(frame(1), std::stoi(w[2])), frame(3), std::stod(w[4]), std::stod(w[5]));
    if (is("pixel", 3)) {
        const Frame a = frame(1);
        print(a.at(std::stoi(w[2]), std::stoi(w[3])));
        return true;
    }
    if (is("pixels", 1)) {
        for (const Pixel& p : frame(1).pixels)
            print(p);
        return true;
    }
    if (is("samples", 1)) {
        const Frame a = frame(1);
        for (const Pixel& p : a.pixels)
            for (int channel = 0; channel < 3; ++channel)
                std::cout.put(char(p[channel] / 257));
        return true;
    }
    if (is("rerecord", 3)) {
        rerecord(w[1], read_places(w[2]), w[3]);
        return true;
    }
    if (is("rerecorded", 5)) {
        Frame a = frame(1), b = frame(2);
        const auto places = read_places(w[3]);
        std::vector<Pixel> x, y;
        for (std::size_t n = 0; n < places.size(); n++)
            if (places[n].i >= 0)
                x.push_back(a.pixels.at(n)), y.push_back(b.pixels.at(n));
        a.pixels = x;
        b.pixels = y;
        return near(a, b, std::stod(w[4]), std::stod(w[5]));
    }
    if (is("lit-around", 3))
        return lit_around(frame(1), frame(2), std::stod(w[3]));
    if (is("near", 4))
        return near(frame(1), frame(2), std::stod(w[3]), std::stod(w[4]));
    if (is("alike", 3))
        return alike(frame(1), frame(2), std::stod(w[3]));
    if (is("masked-alike", 4)) {
        const Frame a = frame(1);
        return masked_alike(a, read_oracle(w[2], a.height), w[3], std::stod(w[4]));
    }
    if (is("points-at", 5))
        return points_at(frame(1), frame(2), frame(3), w[4], std::stod(w[5]));
    if (is("error", 3))
        return error(frame(1), frame(2), w[3]);
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
        return unbiased(
            {ours, frame(2), read_oracle(w[3], ours.height), read_oracle(w[4], ours.height)}, w[5],
            w.size() > 6 ? std::stoi(w[6]) : -1);
    }
    throw std::runtime_error("wrong usage; the head of frames.cpp says what there is");
}

} // namespace
} // namespace frames

int main(int argc, char** argv)
{
    try {
        return frames::run({argv + 1, argv + argc}) ? 0 : 1;
    } catch (int status) {
        return status;
    } catch (const std::exception& error) {
        std::cerr << "frames: " << error.what() << '\n';
        return 2;
    }
}
