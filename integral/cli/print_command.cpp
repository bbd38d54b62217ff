// SPDX-License-Identifier: AGPL-3.0-or-later
// integral print: a frame on paper, pixel for pixel.
#include "integral/cli/command.h"
#include "integral/cli/picture_series.h"
#include "integral/cli/progress.h"
#include "integral/cli/values.h"
#include "integral/io/image_file.h"
#include "integral/lightfield/names.h"
#include "integral/output/colour_profile.h"
#include "integral/output/page_pdf.h"
#include "integral/output/page_raster.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>

namespace integral {
namespace {

constexpr double largest_paper = 5000; // mm

options::options_description make_options()
{
    options::options_description all("Options");
    const auto value = [](const char* name) { return options::value<std::string>()->value_name(name); };
    all.add_options()
        ("output,o", value("FILE"), "the page: .pdf (several tiles: several pages), .tiff or .png (several tiles: files with numbers)")
        ("paper", value("NAME|WxH"), "the paper: 4x6, 6x8, 5x7, 8x10, A4, A6, letter, postcard and others, or its width and height in mm "
                                     "(default: as large as picture and marks)")
        ("orientation", value("WAY"), "portrait, landscape or auto: as the picture is (default auto; WxH: as given)")
        ("dpi", value("D[,D]"), "the printer's pixels per inch, across and down (default: the frame's)")
        ("feed", value("X[,Y]"), "how long the printer makes what should be 1, measured across and down (default 1)")
        ("centre", value("WHAT"), "what comes to the paper's middle: lens, the axis nearest to it (default), or picture")
        ("bleed", value("MM"), "how much of the picture's edge is cut off afterwards (default 0)")
        ("marks", value("KIND,..."), "crop, registration, axis (where lenses' axes run) or all, outside the picture (default none)")
        ("strip", options::bool_switch(), "below the picture: scene, sheet, film, date and error figure")
        ("mirror", options::bool_switch(), "turned left to right, for printing on the back of the lens sheet")
        ("tile", options::bool_switch(), "on several pages, where one is too small")
        ("overlap", value("MM"), "of neighbouring tiles (default 10)")
        ("bits", options::value<int>()->value_name("N"), "8 or 16 bits for each colour (default: the frame's)")
        ("icc", value("FILE"), "the printer's ICC profile, to whose colours the page is converted (default: sRGB)")
        ("intent", value("INTENT"), "perceptual, relative (default), saturation or absolute")
        ("sheet", value("FILE.json"), "geometry for a frame that carries none, or instead of its own")
        ("help", "print this");
    return all;
}

double parse_length(const options::variables_map& arguments, const char* option, double fallback)
{
    if (!given(arguments, option))
        return fallback;
    const double value = parse_number(option, text_of(arguments, option), "a number of mm");
    if (!(value >= 0 && value <= largest_paper))
        throw UsageError(std::string("--") + option + " " + text_of(arguments, option) + ": 0 to 5000 mm is expected");
    return value;
}

/// The paper as it is fed.
std::optional<Paper> parse_paper(const options::variables_map& arguments, const Film& film)
{
    const std::string way = given(arguments, "orientation") ? text_of(arguments, "orientation") : "auto";
    if (way != "auto" && way != "portrait" && way != "landscape")
        throw UsageError("--orientation " + way + ": portrait, landscape or auto is expected");
    if (!given(arguments, "paper")) {
        if (way != "auto")
            throw UsageError("--orientation needs --paper");
        return std::nullopt;
    }
    const std::string text = text_of(arguments, "paper");
    std::optional<Paper> paper = paper_named(text);
    const bool named = paper.has_value();
    if (!named) {
        double width = 0, height = 0;
        int read = 0;
        if (std::sscanf(text.c_str(), "%lfx%lf%n", &width, &height, &read) != 2 || read != int(text.size()) || !(width >= 5 && height >= 5)
            || !(width <= largest_paper && height <= largest_paper))
            throw UsageError("--paper " + text + ": " + paper_names() + ", or WIDTHxHEIGHT of 5 to 5000 mm, is expected");
        paper = Paper{width, height};
    }
    const bool wide = film.width * film.pixel_pitch.x > film.height * film.pixel_pitch.y;
    const bool turn = way == "auto" ? named && wide : (way == "landscape") != (paper->width > paper->height);
    if (turn)
        std::swap(paper->width, paper->height);
    return paper;
}

std::string shown(double value)
{
    char text[40];
    std::snprintf(text, sizeof text, "%.6g", value);
    return text;
}

/// The printer's own pixel pitch, mm. Refuses to print a frame of other pixels than the printer's.
Vec2 printer_pitch(const options::variables_map& arguments, const Film& film)
{
    Vec2 feed{1, 1};
    if (given(arguments, "feed"))
        feed = parse_one_or_two("feed", text_of(arguments, "feed"), "X or X,Y");
    if (!(feed.x > 0.5 && feed.y > 0.5 && feed.x < 2 && feed.y < 2))
        throw UsageError("--feed " + text_of(arguments, "feed") + ": 0.5 to 2 is expected");
    const Vec2 made{film.pixel_pitch.x / feed.x, film.pixel_pitch.y / feed.y};
    if (!given(arguments, "dpi"))
        return made;
    const Vec2 dpi = parse_one_or_two("dpi", text_of(arguments, "dpi"), "D or D,D");
    if (!(dpi.x >= 1 && dpi.y >= 1 && dpi.x <= 100000 && dpi.y <= 100000))
        throw UsageError("--dpi " + text_of(arguments, "dpi") + ": 1 to 100000 is expected");
    const auto differs = [](double a, double b) { return std::fabs(a - b) > 1e-6 * b; };
    if (differs(mm_per_inch / made.x, dpi.x) || differs(mm_per_inch / made.y, dpi.y)) {
        const Vec2 pitch{mm_per_inch / dpi.x * feed.x, mm_per_inch / dpi.y * feed.y};
        throw UsageError("the frame has " + shown(mm_per_inch / film.pixel_pitch.x) + " x " + shown(mm_per_inch / film.pixel_pitch.y)
                         + " pixels an inch, and is never resampled; for this printer render it with film { pixel_pitch <" + shown(pitch.x) + ", "
                         + shown(pitch.y) + "> }, or let it print at the frame's own resolution");
    }
    return {mm_per_inch / dpi.x, mm_per_inch / dpi.y};
}

PageRequest parse_request(const options::variables_map& arguments, const Film& film)
{
    PageRequest request;
    request.paper = parse_paper(arguments, film);
    const std::string centre = given(arguments, "centre") ? text_of(arguments, "centre") : "lens";
    if (centre != "lens" && centre != "picture")
        throw UsageError("--centre " + centre + ": lens or picture is expected");
    request.centre_on_lens = centre == "lens";
    request.trim = parse_length(arguments, "bleed", 0);
    request.overlap = parse_length(arguments, "overlap", request.overlap);
    request.tiles = arguments["tile"].as<bool>();
    if (given(arguments, "overlap") && !request.tiles)
        throw UsageError("--overlap is for --tile");
    if (request.tiles && !request.paper)
        throw UsageError("--tile needs --paper");
    request.mirrored = arguments["mirror"].as<bool>();
    std::string kinds = text_of(arguments, "marks");
    while (!kinds.empty()) {
        const std::string kind = kinds.substr(0, kinds.find(','));
        kinds.erase(0, kind.size() + 1);
        if (kind != "crop" && kind != "registration" && kind != "axis" && kind != "all")
            throw UsageError("--marks " + text_of(arguments, "marks") + ": crop, registration, axis or all is expected");
        request.crop_marks |= kind == "crop" || kind == "all";
        request.registration_marks |= kind == "registration" || kind == "all";
        request.axis_marks |= kind == "axis" || kind == "all";
    }
    return request;
}

Intent parse_intent(const options::variables_map& arguments)
{
    const std::string word = given(arguments, "intent") ? text_of(arguments, "intent") : "relative";
    if (given(arguments, "intent") && !given(arguments, "icc"))
        throw UsageError("--intent needs --icc");
    for (const auto& [name, intent] : {std::pair("perceptual", Intent::perceptual), std::pair("relative", Intent::relative),
                                       std::pair("saturation", Intent::saturation), std::pair("absolute", Intent::absolute)})
        if (word == name)
            return intent;
    throw UsageError("--intent " + word + ": perceptual, relative, saturation or absolute is expected");
}

/// Today, or the day of SOURCE_DATE_EPOCH, by which builds are made repeatable.
std::string today()
{
    std::time_t now = std::time(nullptr);
    if (const char* fixed = std::getenv("SOURCE_DATE_EPOCH"))
        now = std::time_t(std::strtoll(fixed, nullptr, 10));
    char text[20];
    std::strftime(text, sizeof text, "%Y-%m-%d", std::gmtime(&now));
    return text;
}

std::string strip_text(const std::string& input, const FrameMetadata& m)
{
    const auto slash = input.rfind('/');
    std::string text = m.render && !m.render->scene.empty() ? m.render->scene : input.substr(slash == std::string::npos ? 0 : slash + 1);
    text += std::string(", ") + name_of(m.sheet.arrangement) + " " + shown(m.sheet.pitch) + " mm, " + shown(m.sheet.thickness) + " mm thick, ior "
          + shown(m.sheet.ior);
    if (m.sheet.slant != 0)
        text += ", slant " + shown(m.sheet.slant);
    text += ", " + shown(mm_per_inch / m.film.pixel_pitch.x) + " x " + shown(mm_per_inch / m.film.pixel_pitch.y) + " dpi, from "
          + shown(m.aperture.distance) + " mm, " + today();
    if (m.render && m.render->error)
        text += ", error " + shown(m.render->error->rms);
    return text;
}

/// Three channels over white paper, 8 or 16 bits, sRGB. A frame of that form is not touched.
Image printable(const Image& frame, int bits)
{
    const Encoding srgb;
    if (frame.channels == 3)
        return sample_bits(frame) == bits && same_encoding(frame.encoding, srgb) ? frame : converted(frame, bits, srgb, false);
    Image page = bits == 8 ? make_image<std::uint8_t>(frame.width, frame.height, 3, srgb) : make_image<std::uint16_t>(frame.width, frame.height, 3, srgb);
    const LinearReader light(frame);
    for (int y = 0; y < frame.height; ++y)
        for (int x = 0; x < frame.width; ++x) {
            const Color c = light(x, y);
            store_linear(page, x, y, {c.r + 1 - c.a, c.g + 1 - c.a, c.b + 1 - c.a, 1});
        }
    return page;
}

bool is_pdf(const std::string& path) { return path.size() > 4 && path.compare(path.size() - 4, 4, ".pdf") == 0; }

int run(const options::variables_map& arguments)
{
    const std::string input = inputs_of(arguments)[0], output = text_of(arguments, "output");
    if (output.empty())
        throw UsageError("-o FILE is missing");
    if (!is_pdf(output) && format_for(output) == ImageFormat::exr)
        throw OutputError(output + ": pages are .pdf, .tiff or .png");
    const Intent intent = parse_intent(arguments);
    if (given(arguments, "bits") && arguments["bits"].as<int>() != 8 && arguments["bits"].as<int>() != 16)
        throw UsageError("--bits " + std::to_string(arguments["bits"].as<int>()) + ": 8 or 16 is expected");
    check_writable(output);

    Frame frame = read_frame_with_metadata(input, text_of(arguments, "sheet"));
    stop_if_interrupted();
    const FrameMetadata& metadata = *frame.metadata;
    PageRequest request = parse_request(arguments, metadata.film);
    if (arguments["strip"].as<bool>())
        request.strip = strip_text(input, metadata);
    std::vector<Page> pages;
    const Vec2 pitch = printer_pitch(arguments, metadata.film);
    try {
        pages = lay_out(metadata, pitch, request);
    } catch (const std::invalid_argument& error) {
        throw UsageError(input + ": " + error.what());
    }
    const int bits = given(arguments, "bits") ? arguments["bits"].as<int>() : std::min(16, sample_bits(frame.image));
    Image picture = printable(frame.image, bits);
    std::string profile = srgb_profile();
    if (given(arguments, "icc")) {
        profile = read_file(text_of(arguments, "icc"));
        try {
            picture = in_profile(picture, profile, intent);
        } catch (const std::runtime_error& error) {
            throw InputError(text_of(arguments, "icc") + ": " + error.what());
        }
    }
    stop_if_interrupted();
    if (is_pdf(output)) {
        std::string bytes;
        try {
            bytes = pdf_of(pages, picture, profile, strip_text(input, metadata));
        } catch (const std::exception& error) {
            throw OutputError(output + ": " + error.what());
        }
        write_file(output, bytes);
        return exit_done;
    }
    const Progress bar = progress_bar("print");
    for (std::size_t k = 0; k < pages.size(); ++k) {
        std::optional<FrameMetadata> geometry;
        if (const auto g = geometry_of(pages[k], metadata)) {
            geometry = g->metadata;
            geometry->encoding = Encoding();
        }
        write_page(pages.size() == 1 ? output : numbered(output, int(k) + 1, int(pages.size())), rasterized(pages[k], picture), pitch,
                   profile, geometry);
        if (!bar(int(k) + 1, int(pages.size())))
            throw Interrupted();
    }
    return exit_done;
}

} // namespace

const Command print_command = {
    "print",
    "a page for a printer, pixel for pixel: PDF, TIFF or PNG",
    "FRAME -o PAGE.pdf [--paper 4x6] [--marks all] [--strip] ...",
    "Lays a frame out on paper at its own size. Its pixels are the printer's: they are never\n"
    "resampled, and a printer of another resolution is refused. A lens's axis comes to the middle of\n"
    "the paper; marks to cut and to lay the lens sheet by stand outside the picture.\n",
    1, 1, make_options, run};

} // namespace integral
