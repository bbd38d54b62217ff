// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/laboratory/view_switching.h"

#include "integral/base/constants.h"
#include "integral/panel/interlace.h"
#include "integral/replay/arrange.h"

#include <algorithm>
#include <cmath>
#include <complex>

namespace integral {
namespace {

constexpr double infinity_distance = 1e7; // mm
constexpr int places_a_lens = 8, looked_at_rows = 8;
constexpr int number_step = 128; // between stored values of neighbouring views' numbers

Image even_picture(std::uint16_t value)
{
    Image image = make_image<std::uint16_t>(1, 1, 3, {Encoding::Kind::linear, 1});
    image.samples = std::vector<std::uint16_t>(3, value);
    return image;
}

/// The number of the view that an eye sees at each place of its picture; -1 where there is none.
std::vector<int> numbers_seen(const Frame& numbered, const View& view, int threads)
{
    const Image seen = *replay(numbered, view, threads);
    const auto& samples = std::get<std::vector<std::uint16_t>>(seen.samples);
    std::vector<int> numbers;
    for (std::size_t k = 1; k < samples.size(); k += std::size_t(seen.channels)) // green
        numbers.push_back(int(std::lround(double(samples[k]) / number_step)) - 1);
    return numbers;
}

/// A view with one sample to a pixel and several pixels to a lens.
View view_of_lenses(const FrameMetadata& geometry, int rows)
{
    View view;
    view.samples = 1;
    view.width = std::clamp(int(places_a_lens * size_of(geometry.film).x / geometry.sheet.pitch), 8,
                            8000);
    view.height = rows;
    return view;
}

/// The slope of b over a, by least squares.
double slope(const std::vector<double>& a, const std::vector<double>& b)
{
    double sa = 0, sb = 0, saa = 0, sab = 0;
    for (std::size_t k = 0; k < a.size(); ++k) {
        sa += a[k];
        sb += b[k];
        saa += a[k] * a[k];
        sab += a[k] * b[k];
    }
    const double n = double(a.size());
    return (n * sab - sa * sb) / (n * saa - sa * sa);
}

} // namespace

struct Interleaver::State {
    FrameMetadata geometry;
    PanelMapping mapping;
    int threads;
};

Interleaver::Interleaver(const FrameMetadata& geometry, Interleaving kind, int threads)
    : state_(new State{geometry, {}, threads})
{
    state_->geometry.render.reset();
    FrameMetadata lenses;
    lenses.sheet = geometry.sheet;
    lenses.film = geometry.film;
    lenses.aperture = geometry.aperture;
    if (kind == Interleaving::to_infinity) {
        lenses.aperture.width *= infinity_distance / lenses.aperture.distance;
        lenses.aperture.distance = infinity_distance;
        if (const auto filling = filling_aperture(lenses.sheet, infinity_distance))
            lenses.aperture = *filling;
    }
    const double distance = lenses.aperture.distance;
    state_->mapping = *mapping_of(lenses, {viewing_zone(lenses, distance), distance}, threads);
}

Interleaver::~Interleaver() = default;

Frame Interleaver::frame(const std::vector<Image>& views) const
{
    const ViewRaster pictures(views, {int(views.size()), 1});
    const Film& film = state_->geometry.film;
    Frame frame{panel_image(pictures, film.width, film.height), std::nullopt};
    interlace(frame.image, pictures, state_->mapping, {Neighbours::nearest, Neighbours::nearest},
              state_->threads);
    FrameMetadata geometry = state_->geometry;
    geometry.encoding = frame.image.encoding;
    set_metadata(frame, geometry);
    return frame;
}

ViewSwitching view_switching(const Interleaver& interleaver, const FrameMetadata& geometry,
                             int views, const std::vector<Eye>& eyes, int threads)
{
    std::vector<Image> numbers;
    for (int k = 0; k < views; ++k)
        numbers.push_back(even_picture(std::uint16_t((k + 1) * number_step)));
    const Frame numbered = interleaver.frame(numbers);
    const double zone = viewing_zone(geometry, eyes[0].distance).x;
    ViewSwitching found{0, 0, 0};
    View view = view_of_lenses(geometry, looked_at_rows);
    std::vector<int> before;
    std::vector<double> at, mean;
    for (const Eye& eye : eyes) {
        view.eye = eye;
        const std::vector<int> seen = numbers_seen(numbered, view, threads);
        const int own = int(std::floor((eye.x / zone + 0.5) * views));
        double others = 0, changed = 0, sum = 0;
        for (std::size_t k = 0; k < seen.size(); ++k) {
            others += seen[k] != own;
            changed += !before.empty() && seen[k] != before[k];
            sum += seen[k];
        }
        const double all = double(seen.size());
        found.crosstalk += others / all / double(eyes.size());
        found.at_once = std::max(found.at_once, changed / all);
        if (std::fabs(eye.x) <= zone / 4) { // farther out, parts of the sheet show side lobes
            at.push_back(eye.x);
            mean.push_back(sum / all);
        }
        before = seen;
    }
    found.step = 1 / slope(at, mean);
    return found;
}

Image moire_picture(const Interleaver& interleaver, const FrameMetadata& geometry, int views,
                    int threads)
{
    std::vector<Image> fields;
    for (int k = 0; k < views; ++k)
        fields.push_back(even_picture(k % 2 == 0 ? 0xffff : 0));
    View view = view_of_lenses(geometry, 60);
    view.eye.distance = geometry.aperture.distance;
    if (views % 2 == 1)
        view.eye.x = viewing_zone(geometry, view.eye.distance).x / views / 2;
    return *replay(interleaver.frame(fields), view, threads);
}

std::optional<double> stripes_period(const Image& moire, const FrameMetadata& geometry)
{
    const LinearReader light(moire);
    const double width = size_of(geometry.film).x;
    double mean = 0;
    for (int x = 0; x < moire.width; ++x)
        mean += light(x, moire.height / 2).g / moire.width;
    double strongest = 0, found = 0;
    for (double f = 1.5 / width; f < 1 / (2.5 * geometry.sheet.pitch); f += 0.02 / width) {
        std::complex<double> sum = 0;
        for (int x = 0; x < moire.width; ++x) {
            const double place = (x + 0.5) / moire.width;
            const double window = 1 - std::cos(2 * pi * place); // Hann, with weak side lobes
            sum += window * (light(x, moire.height / 2).g - mean) *
                   std::polar(1.0, 2 * pi * f * width * place);
        }
        if (std::abs(sum) > strongest) {
            strongest = std::abs(sum);
            found = f;
        }
    }
    if (strongest < 0.1 * moire.width)
        return std::nullopt;
    return 1 / found;
}

} // namespace integral
