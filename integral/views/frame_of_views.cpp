// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/views/frame_of_views.h"

#include "integral/io/frame_rows.h"
#include "integral/views/parallel_views.h"
#include "integral/views/perspective_views.h"

namespace integral {

void write_frame_of_views(const std::string& output, const ViewInput& given,
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
        write_drawn_rows(output, FrameOfPerspectives(given.views, geometry, directions, *eyes, picture),
                   form, threads, progress);
    else
        write_drawn_rows(output, FrameOfViews(given.views, geometry, directions), form, threads,
                   progress);
}

} // namespace integral
