// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/views/view_files.h"

#include "integral/base/interrupt.h"
#include "integral/io/image_file.h"
#include "integral/replay/arrange.h"

#include <algorithm>

namespace integral {

std::vector<Image> upright_views(const Frame& frame, ViewGrid grid, const View& view, int threads,
                                 const Progress& progress)
{
    std::vector<Image> views;
    for (const auto& eye : far_eyes(*frame.metadata, grid)) {
        auto picture = eye ? replay_each(frame, view, {*eye}, threads,
                                         piece_of(progress, int(views.size()), grid.count()))
                           : std::vector<Image>{blank_like(frame.image, view.width, view.height)};
        if (!picture)
            throw Interrupted();
        views.push_back(std::move(picture->front()));
    }
    return views;
}

void write_quilt(const std::string& path, const Frame& frame, const ParallelViews& views,
                 ViewGrid grid, const FrameMetadata& metadata, int threads,
                 const Progress& progress)
{
    Image form = form_of(frame.image);
    form.width = grid.columns * views.width();
    form.height = grid.rows * views.height();
    PictureWriter file = PictureWriter::of_frame(path, form, metadata);
    const int most = rows_of_a_band(form);
    for (int first = 0; first < form.height; first += most) {
        Image band = blank_like(form, form.width, std::min(most, form.height - first));
        stop_if_interrupted();
        for_each_row(band.height, threads, [&](int y) {
            const int row = grid.rows - 1 - (first + y) / views.height(); // view 0 is at the bottom
            for (int column = 0; column < grid.columns; ++column)
                views.draw(row * grid.columns + column, (first + y) % views.height(), band,
                           column * views.width(), y);
        });
        file.write(band);
        if (progress)
            progress(first + band.height, form.height);
    }
    stop_if_interrupted();
    file.finish();
}

void write_views(PictureSeries& series, const Frame& frame, const ParallelViews& views,
                 ViewGrid grid, FrameMetadata metadata, int threads, const Progress& progress)
{
    for (int k = 0; k < grid.count(); ++k) {
        Image view = blank_like(frame.image, views.width(), views.height());
        stop_if_interrupted();
        for_each_row(view.height, threads, [&](int y) { views.draw(k, y, view, 0, y); });
        metadata.quilt->view = k;
        series.add(std::move(view), metadata);
        if (progress)
            progress(k + 1, grid.count());
    }
}

void write_animation(PictureSeries& series, const std::vector<Image>& views, ViewGrid grid)
{
    for (int row = 0; row < grid.rows; ++row)
        for (int i = 0; i < grid.columns; ++i) {
            stop_if_interrupted();
            series.add(views[row * grid.columns + (row % 2 ? grid.columns - 1 - i : i)]);
        }
    series.finish();
}

} // namespace integral
