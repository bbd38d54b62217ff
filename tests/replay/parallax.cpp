// SPDX-License-Identifier: AGPL-3.0-or-later
// parallax FRAME Z: measures how far a thing at depth Z (mm behind the sheet, on its axis) moves
// between the views of 25 eyes, and compares with theory: it is seen through the sheet at eye * Z /
// (distance + Z). Prints the number of pairs of eyes that are at least 60 mm apart, and their
// greatest deviation in per cent of the theoretical value. The eyes stand all over the viewing
// zone: 5 x 5, or 25 in a row for cylinder lenses. Each view is the mean over 8 eyes, which are
// spread over the beam from which a pixel is seen, n distance/thickness pixels wide
// (parallax.test).
#include "integral/io/image_file.h"
#include "integral/replay/arrange.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <exception>

namespace {

using namespace integral;

constexpr double apart = 60; // mm
constexpr int spread = 8;    // eyes averaged for a view: (k, 3k mod 8), every eighth of the beam

bool is_row(const Frame& frame)
{
    return frame.metadata->sheet.arrangement == Arrangement::lenticular;
}

/// The part of the aperture from which an eye sees all lenses without light of the next lens.
/// Hexagonal lenses' images do not fill the aperture's corners; lenses at the sheet's edge, which
/// see the aperture at an angle, fill it even less.
double zone(const Frame& frame)
{
    return frame.metadata->sheet.arrangement == Arrangement::hexagonal ? 0.5 : 0.8;
}

/// Centre of the bright area, mm.
Vec2 centroid(const Image& view, const Film& window)
{
    const LinearReader read(view);
    double sum = 0;
    Vec2 moment{0, 0};
    for (int y = 0; y < view.height; ++y)
        for (int x = 0; x < view.width; ++x) {
            const double light = read(x, y).g;
            sum += light;
            moment = moment + light * film_from_pixel(window, {x + 0.5, y + 0.5});
        }
    return (1 / sum) * moment;
}

Vec2 seen_at(const Frame& frame, Eye eye)
{
    const FrameMetadata& metadata = *frame.metadata;
    const Film& film = metadata.film;
    const Vec2 beam = (metadata.sheet.ior * metadata.aperture.distance / metadata.sheet.thickness) *
                      film.pixel_pitch;
    const int wide = is_row(frame) ? 2 : 3,
              high = is_row(frame) ? 12 : 3; // of the film's pixels, to one of the view's
    const Film window{film.width / wide,
                      film.height / high,
                      {wide * film.pixel_pitch.x, high * film.pixel_pitch.y}};
    Vec2 sum{0, 0};
    for (int k = 0; k < spread; ++k) {
        View view;
        view.eye = {eye.x + beam.x * ((k + 0.5) / spread - 0.5),
                    eye.y + beam.y * ((3 * k % spread + 0.5) / spread - 0.5), eye.distance};
        view.width = window.width;
        view.height = window.height;
        view.samples = 1;
        sum = sum + centroid(*replay(frame, view), window);
    }
    return (1.0 / spread) * sum;
}

void measure(const char* path, double z)
{
    const Frame frame = read_frame_with_metadata(path);
    const Aperture& aperture = frame.metadata->aperture;
    const bool row = is_row(frame);
    const double part = zone(frame);
    const std::vector<Eye> eyes = eye_grid(
        centre_eye(*frame.metadata), row ? 25 : 5, row ? 1 : 5,
        {part * aperture.width, row ? 0 : part * aperture.height});
    std::vector<Vec2> seen;
    for (const Eye& eye : eyes)
        seen.push_back(seen_at(frame, eye));
    double greatest = 0;
    int pairs = 0;
    for (std::size_t i = 0; i < eyes.size(); ++i)
        for (std::size_t j = 0; j < i; ++j) {
            const Vec2 moved{eyes[i].x - eyes[j].x, eyes[i].y - eyes[j].y};
            if (length(moved) < apart)
                continue;
            const Vec2 theory = (z / (aperture.distance + z)) * moved;
            Vec2 away = seen[i] - seen[j] - theory;
            if (row)
                away.y = 0;
            greatest = std::max(greatest, length(away) / length(theory));
            ++pairs;
        }
    std::printf("%d %.3f\n", pairs, 100 * greatest);
}

} // namespace

int main(int argc, char** argv)
{
    if (argc != 3) {
        std::fprintf(stderr, "usage: parallax FRAME Z\n");
        return 2;
    }
    try {
        measure(argv[1], std::atof(argv[2]));
        return 0;
    } catch (const std::exception& error) {
        std::fprintf(stderr, "parallax: %s\n", error.what());
        return 1;
    }
}
