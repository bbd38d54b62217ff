// SPDX-License-Identifier: AGPL-3.0-or-later
// Writes a frame that is drawn some rows at a time, so that it is never whole in memory.
#ifndef INTEGRAL_IO_FRAME_ROWS_H
#define INTEGRAL_IO_FRAME_ROWS_H

#include "integral/base/interrupt.h"
#include "integral/base/parallel.h"
#include "integral/io/image_file.h"

#include <algorithm>

namespace integral {

/// Draws and writes a frame of the form `form`. `drawing` must have a draw() like FrameOfViews,
/// which is called for consecutive rows from the top. `threads` and `progress` as in for_each_row.
/// Throws OutputError, and Interrupted if `progress` stops the work.
template <class Drawing>
void write_drawn_rows(const std::string& output, Drawing&& drawing, const Frame& form, int threads,
                      const Progress& progress)
{
    const int height = form.image.height, most = rows_of_a_band(form.image);
    PictureWriter file = PictureWriter::of_frame(output, form.image, form.metadata);
    for (int first = 0; first < height; first += most) {
        Image band = blank_like(form.image, form.image.width, std::min(most, height - first));
        const Progress of_all = [&](int done, int) {
            return !progress || progress(first + done, height);
        };
        if (!drawing.draw(first, band, threads, of_all))
            throw Interrupted();
        file.write(band);
    }
    file.finish();
}

} // namespace integral

#endif
