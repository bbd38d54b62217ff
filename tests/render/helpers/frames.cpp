// SPDX-License-Identifier: AGPL-3.0-or-later
// Compares PNG frames for the tests of the renderer, with libpng alone. Here is what it is told to
// do:
//
// frames info A            prints "WIDTHxHEIGHT BITS CHANNELS"
// frames same A B          every pixel is equal (as 16-bit RGBA); prints how many are not
// frames near A B TOLERANCE FRACTION
//                          at least FRACTION of the pixels differ by no more than TOLERANCE/255 in
//                          any channel
// frames mirror A B        A's rows, read backwards, are B's
// frames crop A B X Y W H  A and B are equal in the rectangle whose top-left pixel is (X, Y)
// frames shrink A N B TOLERANCE FRACTION
//                          like near, for what +AM1 +A0.0 +RN makes of A's squares of N by N
//                          pixels, N odd: their mean, the middle one counted twice; needs linear
//                          pixels (File_Gamma=1)
// frames alike A B RMSE    root mean square difference over all pixels and channels <= RMSE/255
// frames pixel A X Y       prints "r g b a" in 0...65535
// frames samples A         prints R, G and B of every pixel, row by row, a byte each
// frames rerecord A MIRRORED B
//                          writes B: each pixel is A's at the place that its line of MIRRORED
//                          (oracle mirrored) names, else black; all else, and what A says of
//                          itself, is A's
// frames rerecorded A B MIRRORED TOLERANCE FRACTION
//                          like near, for the pixels that MIRRORED gives a place
// frames oracle OURS FAR PART...
//                          a PART is three words: WEIGHT ORACLE MASK. The ORACLEs' mean by their
//                          weights, in linear light, over those whose MASK calls the pixel imaged
//                          (1; 0 is empty, - is not compared) is what OURS ought to be. WEIGHT red,
//                          green, blue: that channel alone, once. Pixels, and channels, that all
//                          MASKs call empty are exactly 0 in OURS; of the others writes those that
//                          differ by more than 2/255 into FAR, "i j" lines; at most 0.5% may
// frames edges OURS FAR PART...
//                          for each pixel of FAR a row of the PARTs' frames, which are of oracle
//                          around, holds its neighbourhood: OURS has to lie within the means of
//                          what is seen there, at most one pixel away, give or take a quarter of
//                          the range (at a silhouette of glass the range of a few samples is not
//                          all); prints the worst radius
// frames masked-alike A ORACLE MASK RMSE
//                          like alike, for the pixels that MASK calls imaged (1)
// frames error A B MASK    prints the root mean square difference (1 = full scale) of red, green
// and blue over the
//                          pixels that MASK calls imaged (1)
// frames points-at WHERE A B MASK R
//                          the brightness of WHERE goes with the difference of A from B: over the
//                          imaged pixels, the two correlate by R or more
// frames unbiased A1 A2 ORACLE1 ORACLE2 MASK [CHANNEL]
//                          pixels are means of random samples, and linear (File_Gamma=1): A's
//                          differ from the ORACLE's by chance alone. The mean over the imaged
//                          pixels of (A1 - ORACLE1)(A2 - ORACLE2) is within 4 of its own standard
//                          errors of 0; empty pixels are black in A1 and A2. CHANNEL (0, 1, 2):
//                          that one alone
// Exit status: 0 yes, 1 no, 2 unreadable or wrong usage.
#include "frames.h"

#include <iostream>
#include <stdexcept>

namespace frames {
namespace {

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
        const Pixel p = a.at(std::stoi(w[2]), std::stoi(w[3]));
        std::cout << p[0] << ' ' << p[1] << ' ' << p[2] << ' ' << p[3] << '\n';
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
