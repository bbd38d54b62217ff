// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/cli/print_options.h"

#include "integral/cli/choices.h"
#include "integral/cli/values.h"
#include "integral/print/gang.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace integral {
namespace {

constexpr double largest_paper = 5000; // mm
constexpr int most_repeats = 500;

/// Reads a length in mm, if given.
void read_length(const char* option, const std::optional<std::string>& text, double& value)
{
    if (text)
        value = parse_number_between(option, *text, "a number of mm", 0, largest_paper,
                                     "0 to 5000 mm");
}

/// The paper, turned as --orientation requires.
std::optional<Paper> parse_paper(const PrintOptions& o, const Film& film)
{
    const Orientation way = meaning_of("orientation", o.orientation.value_or("auto"),
                                       orientation_choices);
    if (!o.paper) {
        if (way != Orientation::automatic)
            throw UsageError("--orientation needs --paper");
        return std::nullopt;
    }
    const std::string text = *o.paper;
    Paper paper = parse_paper_size(text);
    if (way == Orientation::automatic)
        return paper_named(text) ? paper_for(paper, film) : paper;
    if (is_roll(paper))
        throw UsageError("--orientation is for cut paper, not for a roll");
    if ((way == Orientation::landscape) != (paper.width > paper.height))
        std::swap(paper.width, paper.height);
    return paper;
}

void declare_chart(options::options_description& chart, PrintOptions& o)
{
    add(chart, "chart", o.chart,
        "make a pitch chart instead: bars of lines, one of which is even under the sheet");
    add(chart, "calibration", o.calibration,
        "make a calibration page instead: one photograph of it under the sheet measures pitch, "
        "turn, phase, thickness / index and leak (integral rectify --calibration)");
    add(chart, "pitch-range", o.pitch_range, "A,B",
        "pitches of its first and last bar, mm on the film (default: about the sheet's, as seen "
        "from --distance)");
    add(chart, "distance", o.distance, "MM",
        "from which the chart's middle bar is to be even: the viewing distance (default 400)");
    add(chart, "pitch-step", o.pitch_step, "MM",
        "from bar to bar (default: an eighth of a band along a bar)");
    add(chart, "bars", o.bars, "N",
        "how many in each direction (default 25; 15 where lenses are not lenticular)");
    add(chart, "page", o.page, "WxH",
        "the chart's page, mm (default 152.4x101.6; 203.2x152.4 where lenses are not lenticular; "
        "210x297 for --calibration)");
    add(chart, "even", o.even, "BARS@MM",
        "read a chart instead: which bars are even, from which distance, as 12,13@400; again for "
        "each distance. Prints the sheet's mechanical pitch and index; -o FILE.json writes the "
        "sheet corrected");
    add(chart, "keep-index", o.keep_index,
        "with --even: take the index as given and measure the pitch alone");
    declare(chart, o.sheet);
    declare(chart, o.film);
}

} // namespace

void declare(options::options_description& all, PrintOptions& o)
{
    add(all, "output,o", o.output, "FILE",
        "the page: .pdf (several tiles: several pages), .tiff or .png (several tiles: files with "
        "numbers)");
    add(all, "paper", o.paper, "NAME|WxH",
        ("the paper: " + paper_names() +
         "; its width and height in mm; or a roll's width, as 610xroll (default: as large as "
         "picture and marks)")
            .c_str());
    add(all, "orientation", o.orientation, "WAY",
        "portrait, landscape or auto: as the picture is (default auto; WxH: as given)");
    add(all, "dpi", o.film.dpi, "D[,D]",
        "the printer's pixels per inch, across and down (default: the frame's)");
    add(all, "feed", o.feed, "X[,Y]",
        "how long the printer makes what should be 1, measured across and down (default 1)");
    add(all, "centre", o.centre, "WHAT",
        "what comes to the paper's middle: lens, the axis nearest to it (default), or picture");
    add(all, "bleed", o.bleed, "MM",
        "how much of the picture's edge is cut off afterwards (default: the bleed of the frame's "
        "film, 0 if it has none)");
    add(all, "marks", o.marks, "KIND,...",
        "crop, registration, axis (where lenses' axes run) or all, outside the picture (default "
        "none)");
    add(all, "strip", o.strip, "below the picture: scene, sheet, film, date and error figure");
    add(all, "mirror", o.mirror,
        "turned left to right, for printing on the back of the lens sheet");
    add(all, "tile", o.tile, "on several pages, where one is too small");
    add(all, "overlap", o.overlap, "MM", "of neighbouring tiles (default 10)");
    add(all, "repeat", o.repeat, "N",
        "each frame N times on the page, or as often as there is room: fill (default 1)");
    add(all, "gap", o.gap, "MM",
        "between frames on one page, or up to a lens's width more (default 8)");
    add(all, "bits", o.bits, "N", "8 or 16 bits for each colour (default: the frame's)");
    add(all, "icc", o.icc, "FILE",
        "the printer's ICC profile, to whose colours the page is converted (default: sRGB); of a "
        "CMYK press: TIFF in inks, or PDF/X-4");
    add(all, "intent", o.intent, "INTENT",
        "perceptual, relative (default), saturation or absolute");
    add(all, "white", o.white, "WHERE",
        "white as a fifth ink, for a CMYK profile: full, on the whole page, or picture, under it "
        "as "
        "far as it is opaque");
    add(all, "halftone", o.halftone, "INK",
        "dots that follow the lenses, for printers of two tones or of few levels: black, in one "
        "ink; or colour, of red, green and blue each");
    add(all, "levels", o.levels, "N",
        "with --halftone: the levels that a dot can have, 2 to 16 (default 2: a dot or none)");
    add(all, "printer", o.printer, "NAME",
        "print it, to a queue of CUPS; ? lists them. -o is then not needed");
    add(all, "copies", o.copies, "N", "how many, 1 to 1000 (default 1)");
    add(all, "medium", o.medium, "NAME",
        "the printer's name for the paper (default: chosen by the page's size)");
    add(all, "printer-option", o.printer_options, "NAME=VALUE",
        "of the printer's driver, as StpLaminate=Matte; may be given again");
    declare_frame_geometry(all, o.start);
    add(all, "json", o.json, "with --even: print figures as JSON");
    options::options_description chart;
    declare_chart(chart, o);
    for (const auto& option : chart.options()) // --dpi exists already
        if (!all.find_nothrow(option->long_name(), false))
            all.add(option);
}

Paper parse_paper_size(const std::string& text)
{
    if (const std::optional<Paper> paper = paper_named(text))
        return *paper;
    constexpr char legal[] = ", or WIDTHxHEIGHT of 5 to 5000 mm, or WIDTHxroll,";
    const std::size_t times = std::min(text.find('x'), text.size());
    const std::string second = text.substr(std::min(times + 1, text.size()));
    const auto is_length = [](double mm) { return mm >= 5 && mm <= largest_paper; };
    const double width = number_in(text.substr(0, times)).value_or(0);
    if (is_length(width) && second == "roll")
        return {width, 0};
    const double height = number_in(second).value_or(0);
    if (!is_length(width) || !is_length(height))
        throw_usage("paper", text, paper_names() + legal);
    return {width, height};
}

Vec2 pitch_of_printer(const PrintOptions& o, const Film& film)
{
    Vec2 feed{1, 1};
    if (o.feed)
        feed = parse_one_or_two("feed", *o.feed, "X or X,Y");
    if (!(feed.x > 0.5 && feed.y > 0.5 && feed.x < 2 && feed.y < 2))
        throw_usage("feed", *o.feed, "0.5 to 2");
    if (!o.film.dpi)
        return printer_pitch(film, feed, std::nullopt);
    const Vec2 dpi = parse_one_or_two("dpi", *o.film.dpi, "D or D,D");
    if (!(dpi.x >= 1 && dpi.y >= 1 && dpi.x <= 100000 && dpi.y <= 100000))
        throw_usage("dpi", *o.film.dpi, "1 to 100000");
    return printer_pitch(film, feed, dpi);
}

PageRequest page_request(const PrintOptions& o, const Film& film)
{
    PageRequest request;
    request.paper = parse_paper(o, film);
    request.centre_on_lens = meaning_of("centre", o.centre.value_or("lens"), centre_choices);
    request.trim = film.bleed;
    read_length("bleed", o.bleed, request.trim);
    read_length("overlap", o.overlap, request.overlap);
    request.tiles = o.tile;
    if (o.overlap && !request.tiles)
        throw UsageError("--overlap is for --tile");
    if (request.tiles && !request.paper)
        throw UsageError("--tile needs --paper");
    request.mirrored = o.mirror;
    if (o.white && !o.icc)
        throw UsageError("--white needs --icc with the profile of a CMYK press");
    if (o.white)
        request.white = meaning_of("white", *o.white, white_choices);
    std::string kinds = o.marks.value_or("");
    while (!kinds.empty()) {
        const std::string kind = kinds.substr(0, kinds.find(','));
        kinds.erase(0, kind.size() + 1);
        const PageMarks marks = meaning_of("marks", kind, marks_choices);
        request.crop_marks |= marks.crop;
        request.registration_marks |= marks.registration;
        request.axis_marks |= marks.axis;
    }
    return request;
}

bool holds_several(const PrintOptions& o) { return o.inputs.size() > 1 || o.repeat; }

int repeats_of(const PrintOptions& o)
{
    if (!o.repeat)
        return 1;
    if (*o.repeat == "fill") {
        if (o.inputs.size() > 1)
            throw UsageError("--repeat fill is for one FRAME");
        return 0;
    }
    const double times = parse_number_between("repeat", *o.repeat, "a number, or fill", 1,
                                              most_repeats, "1 to 500");
    if (times != std::floor(times))
        throw_usage("repeat", *o.repeat, "a whole number, or fill");
    return int(times);
}

double gap_of(const PrintOptions& o)
{
    double gap = GangRequest().gap;
    read_length("gap", o.gap, gap);
    return gap;
}

Intent intent_of(const PrintOptions& o)
{
    if (o.intent && !o.icc)
        throw UsageError("--intent needs --icc");
    return meaning_of("intent", o.intent.value_or("relative"), intent_choices);
}

std::optional<HalftoneSettings> halftone_of(const PrintOptions& o)
{
    if (!o.halftone) {
        throw_if_given({{"levels", o.levels}}, "is for --halftone; give both");
        return std::nullopt;
    }
    throw_if_given({{"bits", o.bits}, {"icc", o.icc}, {"intent", o.intent}, {"white", o.white}},
                   "does not work with --halftone; leave one of them out");
    HalftoneSettings settings;
    settings.grey = meaning_of("halftone", *o.halftone, halftone_choices);
    settings.levels = in_range("levels", o.levels.value_or(2), 2, most_levels);
    return settings;
}

} // namespace integral
