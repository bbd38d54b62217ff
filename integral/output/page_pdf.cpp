// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/output/page_pdf.h"

#include "integral/lightfield/number_text.h"
#include "integral/output/page_raster.h"

#define POINTERHOLDER_TRANSITION 4 // the pointers of QPDF 11
#include <qpdf/QPDF.hh>
#include <qpdf/QPDFObjectHandle.hh>
#include <qpdf/QPDFPageDocumentHelper.hh>
#include <qpdf/QPDFWriter.hh>

namespace integral {
namespace {

constexpr double points_per_mm = 72 / 25.4;

std::string number(double value) { return with_decimals(value, 6); }

/// A rectangle in points from the page's bottom left corner, of pixels from its top left.
struct Points {
    const Page& page;
    double x(double pixel) const { return pixel * page.pixel_pitch.x * points_per_mm; }
    double y(double pixel) const { return (page.height - pixel) * page.pixel_pitch.y * points_per_mm; }
    /// A box, turned over with a mirrored page.
    std::string box(const PixelRectangle& r) const
    {
        const int left = page.mirrored ? page.width - r.x - r.width : r.x;
        return "[" + number(x(left)) + " " + number(y(r.y + r.height)) + " " + number(x(left + r.width)) + " " + number(y(r.y)) + "]";
    }
};

/// The picture's samples as PDF wants them: 16 bits with the high byte first.
std::string samples_of(const Image& image)
{
    std::string bytes;
    std::visit([&](const auto& samples) {
        bytes.reserve(samples.size() * (sample_bits(image) / 8));
        for (const auto sample : samples) {
            if constexpr (sizeof sample == 2)
                bytes += char(sample >> 8);
            bytes += char(static_cast<unsigned>(sample) & 0xff);
        }
    }, image.samples);
    return bytes;
}

/// UTF-8 as a PDF string in WinAnsiEncoding, which has Latin letters; every other letter becomes a question mark.
std::string quoted(const std::string& text)
{
    std::string string = "(";
    for (std::size_t k = 0; k < text.size(); ++k) {
        const auto c = static_cast<unsigned char>(text[k]);
        const auto next = static_cast<unsigned char>(k + 1 < text.size() ? text[k + 1] : 0);
        if (c == '(' || c == ')' || c == '\\')
            string += '\\';
        if (c >= ' ' && c <= '~')
            string += char(c);
        else if ((c == 0xc2 && next >= 0xa0) || c == 0xc3) // U+00A0 to U+00FF
            string += char((c & 3) << 6 | (next & 0x3f));
        else
            string += '?';
        while (c >= 0xc0 && k + 1 < text.size() && (text[k + 1] & 0xc0) == 0x80) // the rest of the letter
            ++k;
    }
    return string + ")";
}

std::string content_of(const Page& page)
{
    const Points points{page};
    std::string text;
    // The picture: a unit square, stretched to its pixels' size but for a thousandth of a pixel at each edge. Rasterizers that paint
    // every pixel that an image touches (poppler's Splash, which CUPS uses) would make it a pixel wider, and resample it, if its edges lay
    // on the pixels' own.
    constexpr double inset = 1.0 / 1024;
    const int left = page.mirrored ? page.width - page.x - page.part.width : page.x;
    text += "q " + number(points.x(page.part.width - 2 * inset)) + " 0 0 "
          + number((page.part.height - 2 * inset) * page.pixel_pitch.y * points_per_mm) + " " + number(points.x(left + inset)) + " "
          + number(points.y(page.y + page.part.height - inset)) + " cm /Picture Do Q\n";
    if (page.mirrored)
        text += "-1 0 0 1 " + number(points.x(page.width)) + " 0 cm\n";
    text += number(points.x(1)) + " w 0 G 0 g\n";
    const auto place = [&](Vec2 mm) { return number(mm.x * points_per_mm) + " " + number(points.y(mm.y / page.pixel_pitch.y)); };
    for (const PageLine& line : page.lines)
        text += place(line.from) + " m " + place(line.to) + " l S\n";
    if (!page.strip.empty())
        text += "BT /Plain " + number(page.strip_size * points_per_mm) + " Tf " + place(page.strip_place) + " Td "
              + quoted(page.strip) + " Tj ET\n";
    return text;
}

} // namespace

std::string pdf_of(const std::vector<Page>& pages, const Image& picture, const std::string& profile, const std::string& title)
{
    QPDF pdf;
    pdf.emptyPDF();
    auto icc = QPDFObjectHandle::newStream(&pdf, profile);
    icc.getDict().replaceKey("/N", QPDFObjectHandle::newInteger(3));
    icc.getDict().replaceKey("/Alternate", QPDFObjectHandle::newName("/DeviceRGB"));
    auto space = QPDFObjectHandle::newArray();
    space.appendItem(QPDFObjectHandle::newName("/ICCBased"));
    space.appendItem(pdf.makeIndirectObject(icc));
    const auto font = pdf.makeIndirectObject(
        QPDFObjectHandle::parse("<< /Type /Font /Subtype /Type1 /BaseFont /Helvetica /Encoding /WinAnsiEncoding >>"));

    QPDFPageDocumentHelper document(pdf);
    for (const Page& page : pages) {
        const Image part = picture_on(page, picture);
        auto image = QPDFObjectHandle::newStream(&pdf, samples_of(part));
        auto about = image.getDict();
        about.replaceKey("/Type", QPDFObjectHandle::newName("/XObject"));
        about.replaceKey("/Subtype", QPDFObjectHandle::newName("/Image"));
        about.replaceKey("/Width", QPDFObjectHandle::newInteger(part.width));
        about.replaceKey("/Height", QPDFObjectHandle::newInteger(part.height));
        about.replaceKey("/BitsPerComponent", QPDFObjectHandle::newInteger(sample_bits(part)));
        about.replaceKey("/ColorSpace", space);
        about.replaceKey("/Interpolate", QPDFObjectHandle::newBool(false));

        auto resources = QPDFObjectHandle::parse("<< /XObject << >> /Font << >> >>");
        resources.getKey("/XObject").replaceKey("/Picture", pdf.makeIndirectObject(image));
        resources.getKey("/Font").replaceKey("/Plain", font);
        const Points points{page};
        auto sheet = QPDFObjectHandle::parse("<< /Type /Page >>");
        sheet.replaceKey("/MediaBox", QPDFObjectHandle::parse(points.box({0, 0, page.width, page.height})));
        sheet.replaceKey("/CropBox", sheet.getKey("/MediaBox"));
        sheet.replaceKey("/BleedBox", QPDFObjectHandle::parse(points.box({page.x, page.y, page.part.width, page.part.height})));
        sheet.replaceKey("/TrimBox", QPDFObjectHandle::parse(points.box(page.trimmed)));
        sheet.replaceKey("/Resources", resources);
        sheet.replaceKey("/Contents", pdf.makeIndirectObject(QPDFObjectHandle::newStream(&pdf, content_of(page))));
        document.addPage(QPDFPageObjectHelper(pdf.makeIndirectObject(sheet)), false);
    }
    pdf.getRoot().replaceKey("/ViewerPreferences", QPDFObjectHandle::parse("<< /PrintScaling /None >>"));
    auto about = QPDFObjectHandle::parse("<< >>");
    about.replaceKey("/Title", QPDFObjectHandle::newUnicodeString(title));
    about.replaceKey("/Producer", QPDFObjectHandle::newString("povray-integral"));
    pdf.getTrailer().replaceKey("/Info", pdf.makeIndirectObject(about));

    QPDFWriter writer(pdf);
    writer.setOutputMemory();
    writer.setMinimumPDFVersion("1.6");
    writer.setCompressStreams(true);
    writer.setDeterministicID(true);
    writer.write();
    const auto buffer = writer.getBufferSharedPointer();
    return std::string(reinterpret_cast<const char*>(buffer->getBuffer()), buffer->getSize());
}

} // namespace integral
