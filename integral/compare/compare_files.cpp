// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/compare/compare_files.h"

#include "integral/base/interrupt.h"

#include <algorithm>
#include <optional>
#include <stdexcept>

namespace integral {

Comparison compare_files(FrameReader& a, FrameReader& b, const std::string& name_of_b,
                         const std::string& difference, double gain)
{
    const Image &form_a = a.frame().image, &form_b = b.frame().image;
    std::optional<Comparer> comparer;
    try {
        comparer.emplace(a.frame(), b.frame());
    } catch (const std::invalid_argument& error) {
        throw InputError(name_of_b + ": " + error.what());
    }
    std::optional<PictureWriter> writer;
    if (!difference.empty())
        writer.emplace(
            PictureWriter::of_frame(difference, difference_form(form_a, form_b), std::nullopt));
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
        comparer->add(rows_a, rows_b);
        if (writer)
            writer->write(difference_picture(rows_a, rows_b, gain));
    }
    stop_if_interrupted();
    if (writer)
        writer->finish();
    return comparer->result();
}

} // namespace integral
