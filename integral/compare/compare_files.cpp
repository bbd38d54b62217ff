// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/compare/compare_files.h"

#include "integral/base/interrupt.h"
#include "integral/compare/flip_map.h"

#include <algorithm>
#include <optional>
#include <stdexcept>

namespace integral {
namespace {

/// Calls take(band) for all rows of a picture, and then sets the reader back to the first row.
template <class Take> void read_all(FrameReader& reader, const Take& take)
{
    const Image& form = reader.frame().image;
    const int most = rows_of_a_band(form);
    Image band;
    for (int y = 0; y < form.height; y += most) {
        stop_if_interrupted();
        const int rows = std::min(most, form.height - y);
        if (band.height != rows)
            band = blank_like(form, form.width, rows);
        reader.read(band);
        take(band);
    }
    reader.restart();
}

} // namespace

Comparison compare_files(FrameReader& a, FrameReader& b, const std::string& name_of_b,
                         const ComparisonRules& rules, const ComparisonOutputs& outputs)
{
    const Image &form_a = a.frame().image, &form_b = b.frame().image;
    try {
        require_same_size(form_a, form_b);
    } catch (const std::invalid_argument& error) {
        throw InputError(name_of_b + ": " + error.what());
    }
    ComparisonSettings settings = settings_of(rules, a.frame(), b.frame());
    if (settings.flip && needs_exposures(form_a, form_b)) {
        FlipExposureMeter meter;
        read_all(a, [&](const Image& rows) { meter_rows(meter, rows); });
        settings.flip->exposures = meter.exposures();
    }
    std::optional<PictureWriter> writer, map_writer;
    if (!outputs.difference.empty())
        writer.emplace(PictureWriter::of_frame(outputs.difference, difference_form(form_a, form_b),
                                               std::nullopt));
    if (!outputs.flip_map.empty()) {
        const bool as_values = format_for(outputs.flip_map) == ImageFormat::exr;
        map_writer.emplace(PictureWriter::of_frame(
            outputs.flip_map, flip_map_form(form_a.width, form_a.height, as_values), std::nullopt));
        settings.take_map = [&, as_values](int, int rows, const float* map) {
            map_writer->write(flip_map_rows(map, form_a.width, rows, as_values));
        };
    }
    Comparer comparer(a.frame(), b.frame(), settings);
    const int most = std::min(rows_of_a_band(form_a), rows_of_a_band(form_b));
    Image rows_a, rows_b;
    for (int y = 0; y < form_a.height; y += most) {
        stop_if_interrupted();
        const int rows = std::min(most, form_a.height - y);
        if (rows_a.height != rows) {
            rows_a = blank_like(form_a, form_a.width, rows);
            rows_b = blank_like(form_b, form_b.width, rows);
        }
        a.read(rows_a);
        b.read(rows_b);
        comparer.add(rows_a, rows_b);
        if (writer)
            writer->write(
                difference_picture(rows_a, rows_b, outputs.gain, settings.weights.get(), y));
    }
    stop_if_interrupted();
    if (writer)
        writer->finish();
    if (map_writer)
        map_writer->finish();
    return comparer.result();
}

} // namespace integral
