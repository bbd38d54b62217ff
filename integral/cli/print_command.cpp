// SPDX-License-Identifier: AGPL-3.0-or-later
// integral print: a frame on paper, pixel for pixel.
#include "integral/base/number_text.h"
#include "integral/cli/picture_series.h"
#include "integral/cli/print_chart.h"
#include "integral/cli/print_options.h"
#include "integral/cli/progress.h"
#include "integral/cli/values.h"
#include "integral/io/image_file.h"
#include "integral/lightfield/names.h"
#include "integral/output/colour_profile.h"
#include "integral/output/page_pdf.h"
#include "integral/output/page_raster.h"
#include "integral/output/spool.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <initializer_list>
#include <iostream>

namespace integral {
namespace {

options::options_description make_options()
{
    options::options_description all("Options");
    const auto value = [](const char* name) {
        return options::value<std::string>()->value_name(name);
    };
    all.add_options()("output,o", value("FILE"),
                      "the page: .pdf (several tiles: several pages), .tiff or .png (several "
                      "tiles: files with numbers)")(
        "paper", value("NAME|WxH"),
        "the paper: 4x6, 6x8, 5x7, 8x10, A4, A6, letter, postcard and others, or its width and "
        "height in mm "
        "(default: as large as picture and marks)")(
        "orientation", value("WAY"),
        "portrait, landscape or auto: as the picture is (default auto; WxH: as given)")(
        "dpi", value("D[,D]"),
        "the printer's pixels per inch, across and down (default: the frame's)")(
        "feed", value("X[,Y]"),
        "how long the printer makes what should be 1, measured across and down (default 1)")(
        "centre", value("WHAT"),
        "what comes to the paper's middle: lens, the axis nearest to it (default), or picture")(
        "bleed", value("MM"), "how much of the picture's edge is cut off afterwards (default 0)")(
        "marks", value("KIND,..."),
        "crop, registration, axis (where lenses' axes run) or all, outside the picture (default "
        "none)")("strip", options::bool_switch(),
                 "below the picture: scene, sheet, film, date and error figure")(
        "mirror", options::bool_switch(),
        "turned left to right, for printing on the back of the lens sheet")(
        "tile", options::bool_switch(), "on several pages, where one is too small")(
        "overlap", value("MM"), "of neighbouring tiles (default 10)")(
        "bits", options::value<int>()->value_name("N"),
        "8 or 16 bits for each colour (default: the frame's)")(
        "icc", value("FILE"),
        "the printer's ICC profile, to whose colours the page is converted (default: sRGB)")(
        "intent", value("INTENT"), "perceptual, relative (default), saturation or absolute")(
        "printer", value("NAME"),
        "print it, to a queue of CUPS; ? lists them. -o is then not needed")(
        "copies", options::value<int>()->value_name("N"), "how many, 1 to 1000 (default 1)")(
        "medium", value("NAME"), "the printer's name of the paper (default: by the page's size)")(
        "printer-option", options::value<std::vector<std::string>>()->value_name("NAME=VALUE"),
        "of the printer's driver, as StpLaminate=Matte; may be given again")(
        "sheet", value("FILE.json"),
        "geometry for a frame that carries none, or instead of its own")(
        "json", "with --even: print figures as JSON")("help", "print this");
    add_chart_options(all);
    return all;
}

/// Today, or the day of SOURCE_DATE_EPOCH, by which builds are made repeatable.
std::string today()
{
    std::time_t now = std::time(nullptr);
    if (const char* fixed = std::getenv("SOURCE_DATE_EPOCH"))
        now = std::time_t(std::strtoll(fixed, nullptr, 10));
    const std::tm* day = std::gmtime(&now);
    char text[40];
    if (!day || std::strftime(text, sizeof text, "%Y-%m-%d", day) == 0)
        throw UsageError("SOURCE_DATE_EPOCH is no time that has a date");
    return text;
}

std::string strip_text(const std::string& input, const FrameMetadata& m)
{
    const auto slash = input.rfind('/');
    std::string text = m.render && !m.render->scene.empty()
                           ? m.render->scene
                           : input.substr(slash == std::string::npos ? 0 : slash + 1);
    text += std::string(", ") + name_of(m.sheet.arrangement) + " " + with_digits(m.sheet.pitch, 6) +
            " mm, " + with_digits(m.sheet.thickness, 6) + " mm thick, ior " +
            with_digits(m.sheet.ior, 6);
    if (m.sheet.slant != 0)
        text += ", slant " + with_digits(m.sheet.slant, 6);
    text += ", " + with_digits(mm_per_inch / m.film.pixel_pitch.x, 6) + " x " +
            with_digits(mm_per_inch / m.film.pixel_pitch.y, 6) + " dpi, from " +
            with_digits(m.aperture.distance, 6) + " mm, " + today();
    if (m.render && m.render->error)
        text += ", error " + with_digits(m.render->error->rms, 6);
    return text;
}

/// Three channels over white paper, 8 or 16 bits, sRGB. A picture of that form is not touched.
Image printable(Image picture, int bits)
{
    const Encoding srgb;
    if (picture.channels == 3)
        return sample_bits(picture) == bits && same_encoding(picture.encoding, srgb)
                   ? std::move(picture)
                   : converted(picture, bits, srgb, false);
    Image page = blank_like(form_of(bits, picture.width, picture.height, 3, srgb), picture.width,
                            picture.height);
    const LinearReader light(picture);
    for_each_row(picture.height, 0, [&](int y) {
        for (int x = 0; x < picture.width; ++x) {
            const Color c = light(x, y);
            store_linear(page, x, y, {c.r + 1 - c.a, c.g + 1 - c.a, c.b + 1 - c.a, 1});
        }
    });
    return page;
}

enum class PageFormat { pdf, tiff, png };

/// By the file's name; - is PNG. Throws OutputError.
PageFormat page_format(const std::string& path)
{
    if (path == "-")
        return PageFormat::png;
    const std::string extension = extension_of(path);
    if (extension == "pdf")
        return PageFormat::pdf;
    if (extension == "tif" || extension == "tiff")
        return PageFormat::tiff;
    if (extension == "png")
        return PageFormat::png;
    throw OutputError(path + ": pages are .pdf, .tiff or .png");
}

/// The options that only one kind of work has, refused for the other.
void refuse_given(const options::variables_map& arguments, std::initializer_list<const char*> names,
                  const std::string& why)
{
    for (const char* option : names)
        if (given(arguments, option) && !arguments[option].defaulted())
            throw UsageError(std::string("--") + option + " " + why);
}

/// Prints pages and waits for them.
void send(const options::variables_map& arguments, std::vector<Image> pages, Vec2 pixel_pitch,
          const std::string& title)
{
    SpoolJob job;
    job.printer = text_of(arguments, "printer");
    job.title = title;
    for (Image& page : pages)
        job.pages.push_back(printable(std::move(page), 8));
    job.dpi = {mm_per_inch / pixel_pitch.x, mm_per_inch / pixel_pitch.y};
    job.medium = text_of(arguments, "medium");
    if (given(arguments, "copies"))
        job.copies = in_range(arguments, "copies", 1, 1000);
    if (given(arguments, "printer-option"))
        for (const std::string& option :
             arguments["printer-option"].as<std::vector<std::string>>()) {
            const std::size_t middle = option.find('=');
            if (middle == std::string::npos || middle == 0)
                throw UsageError("--printer-option " + option + ": NAME=VALUE is expected");
            job.options.emplace_back(option.substr(0, middle), option.substr(middle + 1));
        }
    const auto number = spool(job, progress_bar("printing"));
    if (!number)
        throw Interrupted();
    std::cout << job.printer << ": job " << *number << " is printed\n";
}

/// A frame's pages, ready to be written. Only some rows of the frame are in memory at a time.
class Print {
public:
    explicit Print(const options::variables_map& arguments);

    /// Rows of the picture in the colours of the profile. Rows that have been passed are read from
    /// the file again.
    Image rows(int first, int count);

    FrameMetadata metadata;
    std::vector<Page> pages;
    Image form; ///< of the picture: 8 or 16 bits
    Vec2 pixel_pitch;
    std::string profile, title;

private:
    FrameReader reader_;
    int next_ = 0; ///< the row that the reader is at
    std::optional<ProfileTransform> transform_;
};

Print::Print(const options::variables_map& arguments)
    : reader_(inputs_of(arguments)[0], text_of(arguments, "sheet"))
{
    const std::string input = inputs_of(arguments)[0];
    const Intent intent = parse_intent(arguments);
    if (given(arguments, "bits") && arguments["bits"].as<int>() != 8 &&
        arguments["bits"].as<int>() != 16)
        throw UsageError("--bits " + std::to_string(arguments["bits"].as<int>()) +
                         ": 8 or 16 is expected");
    reader_.require_metadata();
    const Image& frame = reader_.frame().image;
    metadata = *reader_.frame().metadata;
    title = strip_text(input, metadata);
    pixel_pitch = printer_pitch(arguments, metadata.film);
    PageRequest request = parse_request(arguments, metadata.film);
    if (arguments["strip"].as<bool>())
        request.strip = title;
    try {
        pages = lay_out(metadata, pixel_pitch, request);
    } catch (const std::invalid_argument& error) {
        throw UsageError(input + ": " + error.what());
    }
    const int bits = given(arguments, "bits") ? arguments["bits"].as<int>()
                                              : std::min(16, sample_bits(frame));
    form = form_of(bits, frame.width, frame.height, 3, Encoding());
    profile = srgb_profile();
    if (!given(arguments, "icc"))
        return;
    profile = read_file(text_of(arguments, "icc"));
    try {
        transform_.emplace(profile, bits, intent);
    } catch (const std::runtime_error& error) {
        throw InputError(text_of(arguments, "icc") + ": " + error.what());
    }
}

Image Print::rows(int first, int count)
{
    const Image& frame = reader_.frame().image;
    const auto read = [&](int rows) {
        stop_if_interrupted();
        Image band = blank_like(frame, frame.width, rows);
        reader_.read(band);
        next_ += rows;
        return band;
    };
    if (first < next_) {
        reader_.restart();
        next_ = 0;
    }
    while (next_ < first)
        read(std::min(rows_of_a_band(frame), first - next_));
    Image picture = printable(read(count), sample_bits(form));
    if (transform_)
        transform_->apply(picture);
    return picture;
}

PictureRows rows_of(Print& print)
{
    return [&print](int first, int count) { return print.rows(first, count); };
}

/// What `draw` does, whose errors are those of a page that cannot be drawn.
template <class Draw> auto drawn(const Page& page, Draw draw)
{
    try {
        return draw();
    } catch (const InputError&) {
        throw;
    } catch (const OutputError&) {
        throw;
    } catch (const Interrupted&) {
        throw;
    } catch (const std::runtime_error& error) {
        throw UsageError("a page of " + std::to_string(page.width) + " x " +
                         std::to_string(page.height) + " pixels: " + error.what());
    }
}

void write_as_pdf(Print& print, const std::string& output)
{
    OutputFile file(output);
    try {
        write_pdf(file, print.pages, print.form, rows_of(print), print.profile, print.title);
    } catch (const InputError&) {
        throw;
    } catch (const OutputError&) {
        throw;
    } catch (const Interrupted&) {
        throw;
    } catch (const std::exception& error) {
        throw OutputError(output + ": " + reason_of(error));
    }
    file.finish();
}

/// The file of a page, with its geometry where the page can be replayed.
PictureWriter page_writer(const Print& print, const Page& page, const std::string& path)
{
    std::optional<FrameMetadata> geometry;
    if (const auto g = geometry_of(page, print.metadata)) {
        geometry = g->metadata;
        geometry->encoding = Encoding();
    }
    Image form = print.form;
    form.width = page.width;
    form.height = page.height;
    return PictureWriter::of_page(path, form, print.pixel_pitch, print.profile, geometry);
}

void write_pages(Print& print, const std::string& output)
{
    const Progress bar = progress_bar("print");
    const int count = int(print.pages.size());
    for (int begin = 0; begin < count;) { // a row of tiles
        const int end = begin + print.pages[std::size_t(begin)].columns;
        const std::vector<Page> pages(print.pages.begin() + begin, print.pages.begin() + end);
        std::vector<PictureWriter> files;
        for (int k = begin; k < end; ++k)
            files.push_back(page_writer(print, print.pages[std::size_t(k)],
                                        count == 1 ? output : numbered(output, k + 1, count)));
        drawn(pages[0], [&] {
            draw_pages(pages, print.form, rows_of(print), [&](std::size_t k, const Image& rows) {
                stop_if_interrupted();
                files[k].write(rows);
            });
        });
        for (PictureWriter& file : files)
            file.finish();
        begin = end;
        if (!bar(begin, count) && begin < count)
            throw Interrupted();
    }
}

int print_frame(const options::variables_map& arguments)
{
    const std::string output = text_of(arguments, "output");
    if (inputs_of(arguments).empty())
        throw UsageError("FRAME is missing; --chart makes a chart without one");
    if (output.empty() && !given(arguments, "printer"))
        throw UsageError("-o FILE is missing, or --printer NAME");
    if (!output.empty()) {
        page_format(output);
        check_writable(output);
    }
    Print print(arguments);
    stop_if_interrupted();
    if (output == "-" && print.pages.size() > 1)
        throw UsageError("-o -: " + std::to_string(print.pages.size()) +
                         " pages go to a .pdf or to files with numbers");
    if (!output.empty() && page_format(output) == PageFormat::pdf)
        write_as_pdf(print, output);
    else if (!output.empty())
        write_pages(print, output);
    if (given(arguments, "printer")) {
        std::vector<Image> pages;
        for (const Page& page : print.pages)
            pages.push_back(
                drawn(page, [&] { return rasterized(page, print.form, rows_of(print)); }));
        send(arguments, std::move(pages), print.pixel_pitch, print.title);
    }
    return exit_done;
}

int print_chart(const options::variables_map& arguments)
{
    refuse_given(arguments,
                 {"paper", "orientation", "feed", "centre", "bleed", "marks", "strip", "mirror",
                  "tile", "overlap", "bits", "icc", "intent"},
                 "is for frames, not for charts");
    if (given(arguments, "even"))
        refuse_given(arguments, {"printer"}, "does not go with --even");
    if (!inputs_of(arguments).empty())
        throw UsageError("a chart takes no FRAME; --sheet FRAME gives it a frame's geometry");
    if (given(arguments, "printer")) {
        const Frame chart = chart_page(arguments).frame;
        if (given(arguments, "output"))
            make_chart(arguments);
        send(arguments, {chart.image}, chart.metadata->film.pixel_pitch, "pitch chart");
        return exit_done;
    }
    return make_chart(arguments);
}

int run(const options::variables_map& arguments)
{
    if (text_of(arguments, "printer") == "?") {
        for (const std::string& printer : printers())
            std::cout << printer << '\n';
        return exit_done;
    }
    if (!given(arguments, "printer"))
        refuse_given(arguments, {"copies", "medium", "printer-option"}, "is for --printer");
    if (is_chart(arguments))
        return print_chart(arguments);
    refuse_given(arguments,
                 {"arrangement", "pitch", "thickness", "ior", "slant", "offset", "pixel-pitch",
                  "size", "pitch-range", "pitch-step", "bars", "page", "keep-index", "json"},
                 "is for --chart and --even");
    return print_frame(arguments);
}

} // namespace

const Command print_command = {
    "print",
    "a frame on paper, pixel for pixel: PDF, TIFF, PNG or a printer; and pitch charts",
    "FRAME (-o PAGE.pdf | --printer NAME) [--paper 4x6] ... | --chart -o FILE | --even BARS@MM ...",
    "Lays a frame out on paper at its own size. Its pixels are the printer's: they are never\n"
    "resampled, and a printer of another resolution is refused. A lens's axis comes to the middle "
    "of\n"
    "the paper; marks to cut and to lay the lens sheet by stand outside the picture.\n"
    "\n"
    "--chart makes a chart of pitches in fine steps, to be looked at through a lens sheet: its bar "
    "that\n"
    "is even tells the sheet's pitch as it is seen from there. --even works out from one such "
    "reading\n"
    "the sheet's mechanical pitch, and from readings at several distances its index as well.\n",
    0,
    1,
    make_options,
    run_from_map<run>};

} // namespace integral
