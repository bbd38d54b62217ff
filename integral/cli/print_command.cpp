// SPDX-License-Identifier: AGPL-3.0-or-later
// integral print: a frame on paper, pixel for pixel.
#include "integral/cli/print_chart.h"
#include "integral/cli/print_gang.h"
#include "integral/cli/print_options.h"
#include "integral/cli/progress.h"
#include "integral/cli/values.h"
#include "integral/print/spool.h"

#include <iostream>

namespace integral {
namespace {

/// The line's job for the printer, without its pages.
SpoolJob job_of(const PrintOptions& o, Vec2 pixel_pitch, const std::string& title)
{
    SpoolJob job;
    job.printer = *o.printer;
    job.title = title;
    job.dpi = {mm_per_inch / pixel_pitch.x, mm_per_inch / pixel_pitch.y};
    job.medium = o.medium.value_or("");
    if (o.copies)
        job.copies = in_range("copies", *o.copies, 1, 1000);
    for (const std::string& option : o.printer_options.value_or(Arguments())) {
        const std::size_t middle = option.find('=');
        if (middle == std::string::npos || middle == 0)
            throw_usage("printer-option", option, "NAME=VALUE");
        job.options.emplace_back(option.substr(0, middle), option.substr(middle + 1));
    }
    return job;
}

/// Prints pages and waits for them.
void send(SpoolJob job, std::vector<Image> pages)
{
    for (Image& page : pages)
        job.pages.push_back(over_white(std::move(page), 8));
    const std::string printer = job.printer;
    const auto number = spool(std::move(job), progress_bar("printing"));
    if (!number)
        throw Interrupted();
    std::cout << printer << ": job " << *number << " is printed\n";
}

/// The line's settings, for a frame with known geometry.
PrintSettings settings_of(const PrintOptions& o, FrameReader& frame)
{
    PrintSettings settings;
    settings.halftone = halftone_of(o);
    settings.intent = intent_of(o);
    settings.bits = bits_given(o.bits, 0);
    frame.require_metadata();
    const FrameMetadata& metadata = *frame.frame().metadata;
    settings.title = print_title(o.inputs[0], metadata);
    settings.pixel_pitch = pitch_of_printer(o, metadata.film);
    settings.page = page_request(o, metadata.film);
    if (o.strip)
        settings.page.strip = settings.title;
    settings.profile = o.icc;
    return settings;
}

/// Writes the pages to the output, the printer, or both.
int deliver(const PrintOptions& o, FramePrint& print, const PrintSettings& settings)
{
    const std::string output = o.output.value_or("");
    if (o.printer && !print.inks().empty())
        throw UsageError("--printer takes no CMYK profile; write a .pdf or .tiff for the press");
    stop_if_interrupted();
    if (output == "-" && print.page_count() > 1)
        throw UsageError("-o -: " + std::to_string(print.page_count()) +
                         " pages go to a .pdf or to files with numbers");
    std::optional<SpoolJob> job; // its options are checked before anything is written
    if (o.printer)
        job = job_of(o, settings.pixel_pitch, settings.title);
    if (!output.empty())
        print.write(output, progress_bar("print"));
    if (job)
        send(std::move(*job), print.pictures());
    return exit_done;
}

int print_frames(const PrintOptions& o)
{
    const std::string output = o.output.value_or("");
    if (o.inputs.empty())
        throw UsageError("FRAME is missing; --chart makes a chart without one");
    if (output.empty() && !o.printer)
        throw UsageError("-o FILE is missing, or --printer NAME");
    if (!output.empty()) {
        page_format(output);
        check_writable(output);
    }
    if (!holds_several(o))
        throw_if_given({{"gap", o.gap}}, "is for several frames on one page");
    Readers frames = open_frames(o);
    PrintSettings settings = settings_of(o, *frames[0]);
    std::vector<FrameReader*> readers{frames[0].get()};
    const FrameMetadata geometry = holds_several(o) ? arrange(o, frames, settings, readers)
                                                    : *frames[0]->frame().metadata;
    FramePrint print = usage_checked(o.inputs[0] + ": ",
                                     [&] { return FramePrint(readers, geometry, settings); });
    return deliver(o, print, settings);
}

int print_chart(const PrintOptions& o)
{
    throw_if_given({{"paper", o.paper},
                    {"orientation", o.orientation},
                    {"feed", o.feed},
                    {"centre", o.centre},
                    {"bleed", o.bleed},
                    {"marks", o.marks},
                    {"strip", o.strip},
                    {"mirror", o.mirror},
                    {"tile", o.tile},
                    {"overlap", o.overlap},
                    {"repeat", o.repeat},
                    {"gap", o.gap},
                    {"white", o.white},
                    {"bits", o.bits},
                    {"icc", o.icc},
                    {"intent", o.intent},
                    {"halftone", o.halftone},
                    {"levels", o.levels}},
                   "is for frames, not for charts");
    if (o.even && o.printer)
        throw UsageError("--printer does not work with --even");
    if (!o.inputs.empty())
        throw UsageError("a chart takes no FRAME; --sheet FRAME gives it a frame's geometry");
    if (!o.printer)
        return make_chart(o);
    const Frame chart = chart_of(o).frame;
    SpoolJob job = job_of(o, chart.metadata->film.pixel_pitch,
                          o.calibration ? "calibration page" : "pitch chart");
    if (o.output)
        make_chart(o);
    send(std::move(job), {chart.image});
    return exit_done;
}

int run(const PrintOptions& o)
{
    if (o.printer == "?") {
        for (const std::string& printer : printers())
            std::cout << printer << '\n';
        return exit_done;
    }
    if (!o.printer)
        throw_if_given(
            {{"copies", o.copies}, {"medium", o.medium}, {"printer-option", o.printer_options}},
            "is for --printer");
    if (o.chart || o.calibration || o.even)
        return print_chart(o);
    constexpr char for_charts[] = "is for --chart, --calibration and --even";
    if (const char* option = first_given(o.sheet))
        throw_if_given({{option, true}}, for_charts);
    throw_if_given({{"pixel-pitch", o.film.pixel_pitch},
                    {"size", o.film.size},
                    {"pitch-range", o.pitch_range},
                    {"pitch-step", o.pitch_step},
                    {"bars", o.bars},
                    {"page", o.page},
                    {"distance", o.distance},
                    {"keep-index", o.keep_index},
                    {"json", o.json}},
                   for_charts);
    return print_frames(o);
}

} // namespace

const Command print_command = {
    "print",
    "a frame on paper, pixel for pixel: PDF, TIFF, PNG or a printer; and pitch charts",
    "FRAME... (-o PAGE.pdf | --printer NAME) [--paper 4x6] ... | --chart -o FILE | --even BARS@MM "
    "...",
    R"(Lays a frame out on paper at its own size. Its pixels are the printer's: they are never
resampled, and a printer of another resolution is refused. A lens's axis comes to the middle of
the paper; marks to cut and to lay the lens sheet by stand outside the picture. Several frames
share one page and one lens sheet, which lies on the lenses of all.

--chart makes a chart of pitches in fine steps, to be looked at through a lens sheet: its bar that
is even tells the sheet's pitch as it is seen from there. --even works out from one such reading
the sheet's mechanical pitch, and from readings at several distances its index as well.
--calibration makes a page from whose photograph, under the sheet, integral rectify --calibration
measures the sheet: pitch, turn, phase, thickness / index, leak and dot gain.
)",
    0,
    500,
    described<PrintOptions>,
    run_with<PrintOptions, run>};

} // namespace integral
