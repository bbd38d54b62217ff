// SPDX-License-Identifier: AGPL-3.0-or-later
#ifdef HAVE_CUPS
#include "integral/print/print_queue.h"

#include <cups/cups.h>
#include <cups/ppd.h>
#include <cups/pwg.h>

#include <cmath>
#include <cstdio>
#include <cstring>
#include <stdexcept>
#include <unistd.h>

// libcups has marked the PPD functions deprecated since 1.6, but has no others that distinguish
// media of the same size.
#pragma GCC diagnostic ignored "-Wdeprecated-declarations"

namespace integral {

namespace {

constexpr double mm_per_point = 25.4 / 72;

bool has_choice(ppd_file_t* ppd, const char* option, const char* choice)
{
    ppd_option_t* found = ppdFindOption(ppd, option);
    return found && ppdFindChoice(found, choice);
}

/// Reads a resolution's name: "300dpi" or "300x600dpi".
bool read_resolution(const char* name, Vec2& dpi)
{
    if (std::sscanf(name, "%lfx%lf", &dpi.x, &dpi.y) == 2)
        return true;
    dpi.y = dpi.x;
    if (std::sscanf(name, "%lf", &dpi.x) != 1)
        return false;
    dpi.y = dpi.x;
    return true;
}

} // namespace

struct PrintQueue::File {
    ppd_file_t* ppd = nullptr;
    ~File()
    {
        if (ppd)
            ppdClose(ppd);
    }
};

PrintQueue::PrintQueue(http_t* server, const std::string& printer) : file_(new File)
{
    const char* path = cupsGetPPD2(server, printer.c_str()); // a temporary copy, which libcups
                                                             // names
    if (!path)
        throw std::runtime_error(std::string("the server has no PPD of it (") +
                                 cupsLastErrorString() + "); raw queues cannot be printed to");
    const std::string copy = path;
    file_->ppd = ppdOpenFile(copy.c_str());
    unlink(copy.c_str());
    if (!file_->ppd)
        throw std::runtime_error("its PPD is malformed");
    ppdMarkDefaults(file_->ppd);
}

PrintQueue::~PrintQueue() = default;

std::vector<PrintMedium> PrintQueue::media() const
{
    std::vector<PrintMedium> media;
    ppd_option_t* labels = ppdFindOption(file_->ppd, "PageSize");
    for (int i = 0; i < file_->ppd->num_sizes; ++i) {
        const ppd_size_t& size = file_->ppd->sizes[i];
        if (!size.width || !size.length || !std::strcmp(size.name, "Custom"))
            continue;
        const ppd_choice_t* choice = labels ? ppdFindChoice(labels, size.name) : nullptr;
        const pwg_media_t* standard = pwgMediaForPPD(size.name); // in 1/100 mm
        media.push_back(
            {size.name,
             choice ? choice->text : size.name,
             {size.width * mm_per_point, size.length * mm_per_point},
             {(size.right - size.left) * mm_per_point, (size.top - size.bottom) * mm_per_point},
             {standard ? standard->width / 100.0 : 0, standard ? standard->length / 100.0 : 0}});
    }
    return media;
}

std::string PrintQueue::resolution(Vec2 dpi, std::string& list) const
{
    std::string found;
    ppd_option_t* option = ppdFindOption(file_->ppd, "Resolution");
    for (int i = 0; option && i < option->num_choices; ++i) {
        const char* name = option->choices[i].choice;
        list += (list.empty() ? "" : ", ") + std::string(name);
        Vec2 offered;
        if (found.empty() && read_resolution(name, offered) && std::abs(offered.x - dpi.x) <= 0.5 &&
            std::abs(offered.y - dpi.y) <= 0.5)
            found = name;
    }
    if (option && option->num_choices)
        return found;
    // A printer with a single resolution may not have this option.
    const ppd_attr_t* only = ppdFindAttr(file_->ppd, "DefaultResolution", nullptr);
    Vec2 offered;
    if (!only || !only->value || !read_resolution(only->value, offered))
        return "";
    list = only->value;
    return std::abs(offered.x - dpi.x) <= 0.5 && std::abs(offered.y - dpi.y) <= 0.5 ? list : "";
}

DriverOptions PrintQueue::plain_options() const
{
    DriverOptions options;
    for (const auto& [option, choice] :
         {std::pair("ColorModel", "RGB"), std::pair("StpiShrinkOutput", "Crop")}) // Gutenprint's
        if (has_choice(file_->ppd, option, choice))
            options.emplace_back(option, choice);
    return options;
}

cups_page_header2_t PrintQueue::page_header(const DriverOptions& options)
{
    cups_option_t* list = nullptr;
    int count = 0;
    for (const auto& [name, value] : options)
        count = cupsAddOption(name.c_str(), value.c_str(), count, &list);
    cupsMarkOptions(file_->ppd, count, list);
    cups_page_header2_t header = {};
    const bool good = cupsRasterInterpretPPD(&header, file_->ppd, count, list, nullptr) == 0;
    cupsFreeOptions(count, list);
    if (!good)
        throw std::runtime_error("its PPD makes no page header");
    const cups_cspace_t space = header.cupsColorSpace;
    const bool rgb = space == CUPS_CSPACE_RGB || space == CUPS_CSPACE_SRGB ||
                     space == CUPS_CSPACE_ADOBERGB;
    if (!rgb || header.cupsColorOrder != CUPS_ORDER_CHUNKED ||
        (header.cupsBitsPerColor && header.cupsBitsPerColor != 8))
        throw std::runtime_error("its driver does not take 8-bit RGB pixels");
    return header;
}

} // namespace integral
#endif
