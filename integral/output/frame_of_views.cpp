// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/output/frame_of_views.h"

#include "integral/base/interrupt.h"
#include "integral/io/image_file.h"
#include "integral/replay/parallel_views.h"
#include "integral/replay/perspective_views.h"

#include <algorithm>

namespace integral {
namespace {

/// Draws and writes a frame, some rows at a time.
template <class Drawing>
void write_rows(const std::string& output, const Drawing& drawing, const Frame& form, int threads,
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

} // namespace

void write_frame_of_views(const std::string& output, const GivenViews& given,
                          const FrameMetadata& geometry, const std::optional<EyeGrid>& eyes,
                          const FittedPicture& picture, int threads, const Progress& progress)
{
    const ViewGrid directions = directions_of(given.grid, geometry.sheet);
    Frame form{form_of(given.views.at(0)), std::nullopt};
    form.image.width = geometry.film.width;
    form.image.height = geometry.film.height;
    FrameMetadata metadata = geometry;
    metadata.quilt.reset();
    set_metadata(form, metadata);
    if (eyes)
        write_rows(output, FrameOfPerspectives(given.views, geometry, directions, *eyes, picture),
                   form, threads, progress);
    else
        write_rows(output, FrameOfViews(given.views, geometry, directions), form, threads,
                   progress);
}

} // namespace integral
