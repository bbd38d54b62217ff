// SPDX-License-Identifier: AGPL-3.0-or-later
// Measures the fraction of a quilt's pixels, and of its single samples, that interlacing does not
// use, for each known display with the quilts that its maker recommends, and for each kind of
// interpolation between views and pixels.
#include "integral/panel/interlace.h"
#include "integral/panel/interlace_rows.h"
#include "integral/sheet/panel.h"
#include "integral/sheet/panel_quilt.h"

#include <cstdio>
#include <vector>

using namespace integral;

namespace {

struct Unread {
    double pixels, samples;
};

Unread unread(const PanelMapping& mapping, ViewGrid grid, int width, int height, bool blend_views,
              bool blend_pixels)
{
    const int count = grid.count();
    const auto pixel_step = [&](int place, int places, int pixels) {
        const auto phase = std::uint32_t((place + 0.5) / places * 4294967296.0);
        return step_among(std::uint32_t(pixels), phase, blend_pixels);
    };
    // For each pixel of the quilt, one bit for each channel that interlacing reads.
    std::vector<char> read(std::size_t(count) * width * height);
    for (int row = 0; row < mapping.height; ++row)
        for (int column = 0; column < mapping.width; ++column) {
            const Step x = pixel_step(column, mapping.width, width),
                       y = pixel_step(row, mapping.height, height);
            for (int channel = 0; channel < 3; ++channel) {
                const Step view = step_among(std::uint32_t(count),
                                             mapping.across.row(row)[3 * column + channel],
                                             blend_views);
                for (std::uint32_t v = 0; v <= (weight_of(view) > 0); ++v)
                    for (std::uint32_t j = 0; j <= (weight_of(y) > 0); ++j)
                        for (std::uint32_t i = 0; i <= (weight_of(x) > 0); ++i)
                            read[(std::size_t(index_of(view) + v) * height + index_of(y) + j) *
                                     width +
                                 index_of(x) + i] |= char(1 << channel);
            }
        }
    std::size_t pixels = 0, samples = 0;
    for (const char bits : read) {
        pixels += bits == 0;
        samples += !(bits & 1) + !(bits & 2) + !(bits & 4);
    }
    return {100.0 * pixels / read.size(), 100.0 * samples / (3 * read.size())};
}

} // namespace

int main()
{
    std::printf("| panel | quilt | rays: quilt, native | unread pixels (samples), %%: nearest "
                "views and pixels | linear pixels | linear views | both linear |\n"
                "|---|---|---|---|---|---|---|\n");
    for (const RecommendedQuilt& recommended : recommended_quilts()) {
        const PanelQuilt& r = recommended.quilt;
        const Panel panel = *panel_named(recommended.panel);
        const PanelMapping mapping = mapping_of(*panel.calibration);
        const int width = r.width / r.tiles.columns, height = r.height / r.tiles.rows;
        std::printf("| %s | %d x %d views, %d x %d | %.1f, %.1f million |",
                    recommended.panel.c_str(), r.tiles.columns, r.tiles.rows, r.width, r.height,
                    1e-6 * width * height * r.tiles.count(),
                    3e-6 * panel.film.width * panel.film.height);
        for (const bool views : {false, true})
            for (const bool pixels : {false, true}) {
                const Unread share = unread(mapping, r.tiles, width, height, views, pixels);
                std::printf(" %.1f (%.1f) |", share.pixels, share.samples);
            }
        std::printf("\n");
        std::fflush(stdout);
    }
}
