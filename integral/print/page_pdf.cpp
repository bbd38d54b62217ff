// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/print/page_pdf.h"

#include "integral/base/number_text.h"
#include "integral/io/packed_bits.h"
#include "integral/print/page_text.h"
#include "integral/print/pdfx.h"

#include <algorithm>
#include <vector>

namespace integral {
namespace {

constexpr double points_per_mm = 72 / 25.4;

std::string number(double value) { return with_decimals(value, 6); }

/// Converts pixels from the page's top left corner to points from its bottom left.
struct Points {
    const Page& page;
    double x(double pixel) const { return pixel * page.pixel_pitch.x * points_per_mm; }
    double y(double pixel) const
    {
        return (page.height - pixel) * page.pixel_pitch.y * points_per_mm;
    }
    /// A box, mirrored if the page is mirrored.
    std::string box(const PixelRectangle& r) const
    {
        const int left = page.mirrored ? page.width - r.x - r.width : r.x;
        return "[" + number(x(left)) + " " + number(y(r.y + r.height)) + " " +
               number(x(left + r.width)) + " " + number(y(r.y)) + "]";
    }
};

/// Some of a picture's channels.
struct Channels {
    int first = 0, count = 0;
};

/// Samples of the channels in PDF's order: 16 bits with the high byte first.
std::vector<unsigned char> samples_of(const Image& image, Channels channels)
{
    std::vector<unsigned char> bytes;
    std::visit(
        [&](const auto& samples) {
            const auto every = std::size_t(image.channels);
            bytes.reserve(samples.size() / every * channels.count * (sample_bits(image) / 8));
            for (std::size_t pixel = 0; pixel < samples.size(); pixel += every)
                for (int c = channels.first; c < channels.first + channels.count; ++c) {
                    const auto sample = samples[pixel + std::size_t(c)];
                    if constexpr (sizeof sample == 2)
                        bytes.push_back(static_cast<unsigned char>(sample >> 8));
                    bytes.push_back(
                        static_cast<unsigned char>(static_cast<unsigned>(sample) & 0xff));
                }
        },
        image.samples);
    return bytes;
}

/// The samples of a picture of two tones, a bit each; every row begins at a whole byte.
std::vector<unsigned char> bits_of(const Image& image)
{
    std::vector<unsigned char> bytes;
    for (int y = 0; y < image.height; ++y) {
        const auto row = packed_bits(row_bytes(image, y),
                                     std::size_t(image.width) * image.channels);
        bytes.insert(bytes.end(), row.begin(), row.end());
    }
    return bytes;
}

/// The strip in black: letters of a font or, of inks, outlines, since a PDF/X holds all its fonts.
std::string strip_of(const Page& page, bool inks)
{
    if (page.strip.empty())
        return "";
    if (inks)
        return "0 0 0 1 k\n" + strip_outlines(page);
    const Points points{page};
    return "BT /Plain " + number(page.strip_size * points_per_mm) + " Tf " +
           number(page.strip_place.x * points_per_mm) + " " +
           number(points.y(page.strip_place.y / page.pixel_pitch.y)) + " Td " +
           pdf_latin_text(page.strip) + " Tj ET\n";
}

std::string content_of(const Page& page, bool inks)
{
    const Points points{page};
    std::string text;
    // The picture: a unit square, stretched to its pixels' size less a thousandth of a pixel at
    // each edge. With edges on pixel edges, rasterizers that paint every pixel that it touches
    // (poppler's Splash, which CUPS uses) would make it a pixel wider and resample it.
    constexpr double inset = 1.0 / 1024;
    const int left = page.mirrored ? page.width - page.x - page.part.width : page.x;
    const std::string onto = "q " + number(points.x(page.part.width - 2 * inset)) + " 0 0 " +
                             number((page.part.height - 2 * inset) * page.pixel_pitch.y *
                                    points_per_mm) +
                             " " + number(points.x(left + inset)) + " " +
                             number(points.y(page.y + page.part.height - inset)) + " cm ";
    // White comes first, so that viewers without overprinting show the picture on it.
    if (page.white != WhiteInk::none)
        text += "/Over gs\n";
    if (page.white == WhiteInk::full)
        text += "/White cs 1 scn 0 0 " + number(points.x(page.width)) + " " + number(points.y(0)) +
                " re f\n";
    if (page.white == WhiteInk::picture)
        text += onto + "/White Do Q\n";
    text += onto + "/Picture Do Q\n";
    if (page.mirrored)
        text += "-1 0 0 1 " + number(points.x(page.width)) + " 0 cm\n";
    text += number(points.x(1)) + (inks ? " w /Marks CS 1 SCN\n" : " w 0 G 0 g\n");
    const auto place = [&](Vec2 mm) {
        return number(mm.x * points_per_mm) + " " + number(points.y(mm.y / page.pixel_pitch.y));
    };
    for (const PageLine& line : page.lines)
        text += place(line.from) + " m " + place(line.to) + " l S\n";
    return text + strip_of(page, inks);
}

/// Adds channels of the page's part of the picture as an image; returns its object's number.
int add_picture(PdfFile& pdf, const Page& page, const Image& form, const PictureRows& picture,
                Channels channels, const std::string& colour_space, bool two_tone)
{
    const std::string entries = "/Type /XObject /Subtype /Image /Width " +
                                std::to_string(page.part.width) + " /Height " +
                                std::to_string(page.part.height) + " /BitsPerComponent " +
                                std::to_string(two_tone ? 1 : sample_bits(form)) + " /ColorSpace " +
                                colour_space + " /Interpolate false";
    return pdf.add_stream(entries, [&](const PdfFile::TakeBytes& take) {
        draw_part(page, form, picture, [&](const Image& rows) {
            const std::vector<unsigned char> bytes = two_tone ? bits_of(rows)
                                                              : samples_of(rows, channels);
            take(bytes.data(), bytes.size());
        });
    });
}

/// Colours and resources that all pages share.
struct Shared {
    bool inks = false;
    std::string colour_space; ///< of the picture
    std::string white;        ///< colour space of white ink; empty: none
    std::string resources;    ///< the font of the strip, or the colour of the marks
};

/// Adds the colour space of an ink, or of all, which viewers without that ink show as `shown`, four
/// inks. Returns a reference to it.
std::string add_separation(PdfFile& pdf, const std::string& name, const std::string& shown)
{
    return reference(pdf.add("[ /Separation /" + name +
                             " /DeviceCMYK << /FunctionType 2 /Domain [0 1] /C0 [0 0 0 0] /C1 [" +
                             shown + "] /N 1 >> ]"));
}

Shared add_shared(PdfFile& pdf, int channels, const std::string& profile)
{
    Shared shared;
    shared.inks = channels > 3;
    if (shared.inks) {
        shared.colour_space = "/DeviceCMYK";
        shared.resources = "/ColorSpace << /Marks " + add_separation(pdf, "All", "1 1 1 1");
        if (channels > 4) {
            shared.white = add_separation(pdf, "White", "0.2 0 0 0"); // visible on a screen
            shared.resources += " /White " + shared.white +
                                " >> /ExtGState << /Over << /Type /ExtGState /op true "
                                "/OPM 0 >>";
        }
        shared.resources += " >>";
        return shared;
    }
    shared.colour_space = "/DeviceGray";
    if (channels == 3) {
        const int colours = pdf.add_stream("/N 3 /Alternate /DeviceRGB", profile);
        shared.colour_space = reference(pdf.add("[ /ICCBased " + reference(colours) + " ]"));
    }
    const int font = pdf.add("<< /Type /Font /Subtype /Type1 /BaseFont /Helvetica "
                             "/Encoding /WinAnsiEncoding >>");
    shared.resources = "/Font << /Plain " + reference(font) + " >>";
    return shared;
}

/// Adds the page itself; returns its object's number.
int add_page(PdfFile& pdf, const Page& page, int parent, const std::string& pictures,
             const Shared& shared)
{
    const int content = pdf.add_stream("", content_of(page, shared.inks));
    const Points points{page};
    const std::string paper = points.box({0, 0, page.width, page.height});
    return pdf.add("<< /Type /Page /Parent " + reference(parent) + " /MediaBox " + paper +
                   " /CropBox " + paper + " /BleedBox " +
                   points.box({page.x, page.y, page.part.width, page.part.height}) + " /TrimBox " +
                   points.box(page.trimmed) + " /Resources << /XObject << " + pictures + " >> " +
                   shared.resources + " >> /Contents " + reference(content) + " >>");
}

} // namespace

void write_pdf(ByteSink& sink, const std::vector<Page>& pages, const Image& form,
               const PictureRows& picture, const std::string& profile, const std::string& title,
               std::time_t created, bool two_tone)
{
    PdfFile pdf(sink);
    const Shared shared = add_shared(pdf, form.channels, profile);
    const int all_pages = pdf.reserve();
    std::string kids;
    for (const Page& page : pages) {
        const Channels colours{0, std::min(form.channels, 4)}, white{4, 1};
        std::string pictures = "/Picture " +
                               reference(add_picture(pdf, page, form, picture, colours,
                                                     shared.colour_space, two_tone));
        if (page.white == WhiteInk::picture)
            pictures += " /White " + reference(add_picture(pdf, page, form, picture, white,
                                                           shared.white, false));
        kids += reference(add_page(pdf, page, all_pages, pictures, shared)) + " ";
    }
    pdf.write(all_pages, "<< /Type /Pages /Kids [ " + kids + "] /Count " +
                             std::to_string(pages.size()) + " >>");
    PdfxEntries entries{"", "<< /Title " + pdf_text(title) + " /Producer (povray-integral) >>"};
    if (shared.inks)
        entries = add_pdfx(pdf, {profile, title, created});
    const int catalog = pdf.add("<< /Type /Catalog /Pages " + reference(all_pages) +
                                " /ViewerPreferences << /PrintScaling /None >>" + entries.catalog +
                                " >>");
    pdf.finish(catalog, pdf.add(entries.about));
}

} // namespace integral
