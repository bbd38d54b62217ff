// SPDX-License-Identifier: AGPL-3.0-or-later
#ifdef HAVE_CUPS
#include "integral/print/spool_document.h"

#include <cmath>
#include <cstdio>
#include <stdexcept>

namespace integral {
namespace {

std::string figures(const char* format, double a, double b)
{
    char text[96];
    std::snprintf(text, sizeof text, format, a, b);
    return text;
}

/// Place of a job's pages: medium, upright or turned, and the driver's name of the resolution.
struct Placed {
    PrintMedium medium;
    bool turned = false;
    std::string resolution;
};

/// Throws std::runtime_error if the printer has no such resolution or medium.
Placed place_pages(const SpoolJob& job, const PrintQueue& queue)
{
    const Image& first = job.pages.front();
    const std::vector<PrintMedium> media = queue.media();
    const SizeMm page = {first.width / job.dpi.x * 25.4, first.height / job.dpi.y * 25.4};
    std::string list, unused;
    const Vec2 across = {job.dpi.y, job.dpi.x}; // for a turned page
    const std::string upright = queue.resolution(job.dpi, list),
                      turned = queue.resolution(across, unused);
    if (upright.empty() && turned.empty())
        throw std::runtime_error("no resolution of " +
                                 figures("%g x %g dpi", job.dpi.x, job.dpi.y) + "; it has " + list +
                                 ", and pixels are never resampled: render for one of these");
    const std::optional<PagePlace> place = place_page(media, page, job.medium);
    if (!place)
        throw std::runtime_error("no medium " + (job.medium.empty() ? "" : job.medium + " ") +
                                 "of " + figures("%.1f x %.1f mm", page.width, page.height) +
                                 "; it has " + media_in_words(media));
    const std::string& resolution = place->turned ? turned : upright;
    if (resolution.empty())
        throw std::runtime_error("a page of " + figures("%.1f x %.1f mm", page.width, page.height) +
                                 " lies across " + media[place->medium].label +
                                 ", which has no resolution of " +
                                 figures("%g x %g dpi", across.x, across.y) + "; it has " + list +
                                 ": render it upright");
    return {media[place->medium], place->turned, resolution};
}

/// The pages in the middle of the medium's printable area, at the resolution of the driver's
/// header. Throws std::runtime_error if colour would be cut off.
std::vector<Image> sheets_of(std::vector<Image> pages, const Placed& placed,
                             const cups_page_header2_t& header)
{
    const PrintMedium& medium = placed.medium;
    const int width = int(std::lround(medium.printable.width / 25.4 * header.HWResolution[0]));
    const int height = int(std::lround(medium.printable.height / 25.4 * header.HWResolution[1]));
    for (Image& page : pages) {
        if (placed.turned)
            page = turned_page(page);
        std::optional<Image> sheet = centred_page(page, width, height);
        if (!sheet)
            throw std::runtime_error(
                "prints " + figures("%g x %g pixels of ", width, height) + medium.label + " (" +
                medium.name + "), and the page has colour outside them; leave its margins white");
        page = std::move(*sheet);
    }
    return pages;
}

} // namespace

SpoolDocument spool_document(SpoolJob job, http_t* server, const std::string& printer)
{
    PrintQueue queue(server, printer);
    const Placed placed = place_pages(job, queue);
    SpoolDocument document;
    document.options = queue.plain_options();
    document.options.emplace_back("PageSize", placed.medium.name);
    document.options.emplace_back("Resolution", placed.resolution);
    document.options.emplace_back("print-scaling", "none");
    document.options.insert(document.options.end(), job.options.begin(), job.options.end());
    document.header = queue.page_header(document.options);
    document.sheets = sheets_of(std::move(job.pages), placed, document.header);
    return document;
}

} // namespace integral
#endif
