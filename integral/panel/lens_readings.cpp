// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/panel/lens_readings.h"

#include "integral/base/constants.h"
#include "integral/base/number_text.h"
#include "integral/optics/visual_pitch.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace integral {
namespace {

/// A reading of card 3 whose phase is farther from the others' mean is ambiguous, periods.
constexpr double most_phase_spread = 0.3;

/// The bars selected of one block, counted from its first bar as 0: their mean, which need not be
/// whole, and the mean of their middles on the sheet.
struct BlockReading {
    double index = 0;
    Vec2 place;
};

double wrapped_phase(double phase) { return phase - std::round(phase); }

Vec2 middle_of(const Panel& panel, const LensBar& bar)
{
    return sheet_point_of(
        film_from_pixel(panel.film, {bar.left + bar.width / 2.0, bar.top + bar.height / 2.0}),
        panel.sheet, panel.aperture.distance);
}

/// Takes the selected bars of one block out of `bars`.
BlockReading reading_of(const LensCard& card, const LensBlock& block, const std::vector<int>& bars)
{
    const int first = block.bars.front().number, count = int(block.bars.size());
    std::vector<int> chosen;
    for (const int bar : bars)
        if (bar >= first && bar < first + count)
            chosen.push_back(bar - first);
    const std::string names = std::to_string(first) + " to " + std::to_string(first + count - 1);
    if (chosen.empty())
        throw std::invalid_argument("card " + std::to_string(card.number) + ": a bar of " + names +
                                    " is missing");
    BlockReading reading;
    double least = 0, greatest = 0;
    for (const int k : chosen) {
        // In a circle, counts from the first selected bar in the shorter direction.
        const double from_first = block.is_circle
                                      ? count * wrapped_phase(double(k - chosen[0]) / count)
                                      : k - chosen[0];
        least = std::min(least, from_first);
        greatest = std::max(greatest, from_first);
        reading.index += from_first / double(chosen.size());
        reading.place = reading.place + 1.0 / double(chosen.size()) *
                                            middle_of(card.panel, block.bars[std::size_t(k)]);
    }
    if (greatest - least > double(chosen.size()) - 0.5)
        throw std::invalid_argument("card " + std::to_string(card.number) + ": bars of " + names +
                                    " that look the same must be neighbours");
    reading.index += chosen[0];
    return reading;
}

/// Sets the sheet's pitch and slant from the wave vector of its lenses, and the zone that fills
/// them, unless the description has a zone of its own.
void set_wave(Vec2 wave, Panel& panel)
{
    const double distance = panel.aperture.distance;
    const auto filling = filling_aperture(panel.sheet, distance);
    const bool has_own_zone = !filling || filling->width != panel.aperture.width ||
                              filling->height != panel.aperture.height;
    panel.calibration.reset();
    if (wave.x < 0)
        wave = -1.0 * wave;
    panel.sheet.pitch = 1 / length(wave);
    panel.sheet.slant = std::atan2(wave.y, wave.x) * degrees_per_radian;
    if (!has_own_zone)
        panel = seen_from(panel, distance);
}

/// Readings of card 3 contradict one another if one is farther from the fit, in steps. Four
/// readings that are right to half a step are at most half a step from it, and a little more where
/// bars are not opposite to one another.
constexpr double most_residual = 0.75;

/// The phases phase - d.P at places P.
struct PhasePlane {
    double phase = 0;
    Vec2 d;
    Vec2 d_error; ///< bound, if each reading is right to half a step
};

/// The phases, which are known modulo 1, without jumps. Throws std::invalid_argument if they differ
/// too much.
std::vector<double> without_jumps(const std::vector<double>& phases)
{
    double cosine = 0, sine = 0;
    for (const double phase : phases) {
        cosine += std::cos(2 * pi * phase);
        sine += std::sin(2 * pi * phase);
    }
    const double about = std::atan2(sine, cosine) / (2 * pi);
    std::vector<double> result;
    for (const double phase : phases) {
        const double off = wrapped_phase(phase - about);
        if (std::fabs(off) > most_phase_spread)
            throw std::invalid_argument("card 3: the bars differ too much from side to side; read "
                                        "card 2 again");
        result.push_back(about + off);
    }
    return result;
}

/// The plane that fits the phases of four places best. Throws std::invalid_argument if the phases
/// contradict one another.
PhasePlane plane_through(const std::vector<double>& phases, const std::vector<Vec2>& places,
                         double step)
{
    const double count = double(phases.size());
    double mean = 0;
    Vec2 centre;
    for (std::size_t i = 0; i < phases.size(); ++i) {
        mean += phases[i] / count;
        centre = centre + 1 / count * places[i];
    }
    double xx = 0, xy = 0, yy = 0;
    for (const Vec2 at : places) {
        const Vec2 place = at - centre;
        xx += place.x * place.x;
        xy += place.x * place.y;
        yy += place.y * place.y;
    }
    const double determinant = xx * yy - xy * xy;
    PhasePlane plane;
    for (std::size_t i = 0; i < phases.size(); ++i) {
        const Vec2 place = places[i] - centre;
        const Vec2 weight{(xy * place.y - yy * place.x) / determinant,
                          (xy * place.x - xx * place.y) / determinant};
        plane.d = plane.d + phases[i] * weight;
        plane.d_error = plane.d_error + step / 2 * Vec2{std::fabs(weight.x), std::fabs(weight.y)};
    }
    for (std::size_t i = 0; i < phases.size(); ++i)
        if (std::fabs(phases[i] - mean + dot(plane.d, places[i] - centre)) > most_residual * step)
            throw std::invalid_argument("card 3: the bars contradict one another; read them "
                                        "again, with the eye at rest in front of the middle");
    plane.phase = mean + dot(plane.d, centre);
    return plane;
}

LensCard after_phases(LensCard card, const std::vector<LensBlock>& blocks,
                      const std::vector<int>& bars)
{
    std::vector<double> phases;
    std::vector<Vec2> places;
    for (const LensBlock& block : blocks) {
        const BlockReading reading = reading_of(card, block, bars);
        phases.push_back(reading.index * block.step);
        places.push_back(reading.place);
    }
    const PhasePlane plane = plane_through(without_jumps(phases), places, blocks[0].step);
    const Vec2 wave = wave_vector(card.panel.sheet) + plane.d;
    set_wave(wave, card.panel);
    LensSheet& sheet = card.panel.sheet;
    sheet.offset = wrapped_phase(plane.phase) * sheet.pitch * (1 / length(wave) * wave);
    card.error = plane.d_error;
    return card;
}

} // namespace

LensCard card_after(const LensCard& card, const std::vector<int>& bars)
{
    if (card.number > lens_cards)
        throw std::invalid_argument("there are " + std::to_string(lens_cards) + " cards");
    const std::vector<LensBlock> blocks = lens_blocks(card);
    const int most = blocks.back().bars.back().number;
    for (const int bar : bars)
        if (bar < 1 || bar > most)
            throw std::invalid_argument("card " + std::to_string(card.number) + " has bars 1 to " +
                                        std::to_string(most) + ", not " + std::to_string(bar));
    LensCard next = card;
    if (card.number == lens_cards) {
        next = after_phases(card, blocks, bars);
    } else {
        const auto off = [&](const LensBlock& block) {
            return (reading_of(card, block, bars).index - double(block.bars.size() - 1) / 2) *
                   block.step;
        };
        set_wave(wave_vector(card.panel.sheet) + Vec2{off(blocks[0]), off(blocks[1])}, next.panel);
        next.error = {blocks[0].step / 2, blocks[1].step / 2};
    }
    next.number = card.number + 1;
    return next;
}

std::string lens_report(const LensCard& card)
{
    const LensSheet& sheet = card.panel.sheet;
    const double distance = card.panel.aperture.distance;
    const Vec2 across = Lattice(sheet).across();
    const double along_wave = std::fabs(across.x) * card.error.x +
                              std::fabs(across.y) * card.error.y,
                 turning = std::fabs(across.y) * card.error.x + std::fabs(across.x) * card.error.y;
    const double micro_image = visual_pitch(sheet.pitch, sheet, distance);
    std::string text = "pitch               " + with_decimals(sheet.pitch, 5) + " +- " +
                       with_decimals(sheet.pitch * sheet.pitch * along_wave, 5) + " mm, " +
                       with_decimals(mm_per_inch / sheet.pitch, 4) + " lenses per inch\n" +
                       "micro-images        " + with_decimals(micro_image, 5) + " mm from " +
                       with_digits(distance, 4) + " mm, " +
                       with_decimals(mm_per_inch / micro_image, 4) + " per inch\n" +
                       "slant               " + with_decimals(sheet.slant, 3) + " +- " +
                       with_decimals(sheet.pitch * turning * degrees_per_radian, 3) + " degrees\n";
    if (card.number > lens_cards)
        text += "a lens's axis       " + with_decimals(dot(across, sheet.offset), 4) +
                " mm from the middle\n";
    return text;
}

} // namespace integral
