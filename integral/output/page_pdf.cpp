// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/output/page_pdf.h"

#include "integral/base/number_text.h"

#define POINTERHOLDER_TRANSITION 4 // the pointers of QPDF 11
#include <qpdf/Pipeline.hh>
#include <qpdf/QPDF.hh>
#include <qpdf/QPDFObjectHandle.hh>
#include <qpdf/QPDFPageDocumentHelper.hh>
#include <qpdf/QPDFWriter.hh>

#include <cstdio>
#include <exception>
#include <new>
#include <vector>

namespace integral {
namespace {

constexpr double points_per_mm = 72 / 25.4;

std::string number(double value) { return with_decimals(value, 6); }

/// A rectangle in points from the page's bottom left corner, of pixels from its top left.
struct Points {
    const Page& page;
    double x(double pixel) const { return pixel * page.pixel_pitch.x * points_per_mm; }
    double y(double pixel) const
    {
        return (page.height - pixel) * page.pixel_pitch.y * points_per_mm;
    }
    /// A box, turned over with a mirrored page.
    std::string box(const PixelRectangle& r) const
    {
        const int left = page.mirrored ? page.width - r.x - r.width : r.x;
        return "[" + number(x(left)) + " " + number(y(r.y + r.height)) + " " +
               number(x(left + r.width)) + " " + number(y(r.y)) + "]";
    }
};

/// The picture's samples as PDF wants them: 16 bits with the high byte first.
std::vector<unsigned char> samples_of(const Image& image)
{
    std::vector<unsigned char> bytes;
    std::visit(
        [&](const auto& samples) {
            bytes.reserve(samples.size() * (sample_bits(image) / 8));
            for (const auto sample : samples) {
                if constexpr (sizeof sample == 2)
                    bytes.push_back(static_cast<unsigned char>(sample >> 8));
                bytes.push_back(static_cast<unsigned char>(static_cast<unsigned>(sample) & 0xff));
            }
        },
        image.samples);
    return bytes;
}

/// A sink as a C stream, which QPDF writes to.
class SinkStream {
public:
    explicit SinkStream(ByteSink& sink) : sink_(sink)
    {
        cookie_io_functions_t functions{};
        functions.write = on_write;
        file_ = fopencookie(this, "w", functions);
        if (!file_)
            throw std::bad_alloc();
    }
    ~SinkStream() { std::fclose(file_); }
    SinkStream(const SinkStream&) = delete;
    SinkStream& operator=(const SinkStream&) = delete;

    std::FILE* file() { return file_; }

    /// Throws what the sink threw, if it did.
    void check() const
    {
        if (failure_)
            std::rethrow_exception(failure_);
    }

private:
    static ssize_t on_write(void* self, const char* bytes, std::size_t count)
    {
        auto& stream = *static_cast<SinkStream*>(self);
        try { // no exception may pass through the C library
            stream.sink_.write(stream.sink_.size(), bytes, count);
        } catch (...) {
            stream.failure_ = std::current_exception();
            return 0;
        }
        return ssize_t(count);
    }

    ByteSink& sink_;
    std::FILE* file_ = nullptr;
    std::exception_ptr failure_;
};

/// UTF-8 as a PDF string in WinAnsiEncoding, which has Latin letters; every other letter becomes a
/// question mark.
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
        while (c >= 0xc0 && k + 1 < text.size() && (text[k + 1] & 0xc0) == 0x80) // the rest of the
                                                                                 // letter
            ++k;
    }
    return string + ")";
}

std::string content_of(const Page& page)
{
    const Points points{page};
    std::string text;
    // The picture: a unit square, stretched to its pixels' size but for a thousandth of a pixel at
    // each edge. Rasterizers that paint every pixel that an image touches (poppler's Splash, which
    // CUPS uses) would make it a pixel wider, and resample it, if its edges lay on the pixels' own.
    constexpr double inset = 1.0 / 1024;
    const int left = page.mirrored ? page.width - page.x - page.part.width : page.x;
    text += "q " + number(points.x(page.part.width - 2 * inset)) + " 0 0 " +
            number((page.part.height - 2 * inset) * page.pixel_pitch.y * points_per_mm) + " " +
            number(points.x(left + inset)) + " " +
            number(points.y(page.y + page.part.height - inset)) + " cm /Picture Do Q\n";
    if (page.mirrored)
        text += "-1 0 0 1 " + number(points.x(page.width)) + " 0 cm\n";
    text += number(points.x(1)) + " w 0 G 0 g\n";
    const auto place = [&](Vec2 mm) {
        return number(mm.x * points_per_mm) + " " + number(points.y(mm.y / page.pixel_pitch.y));
    };
    for (const PageLine& line : page.lines)
        text += place(line.from) + " m " + place(line.to) + " l S\n";
    if (!page.strip.empty())
        text += "BT /Plain " + number(page.strip_size * points_per_mm) + " Tf " +
                place(page.strip_place) + " Td " + quoted(page.strip) + " Tj ET\n";
    return text;
}

} // namespace

void write_pdf(ByteSink& sink, const std::vector<Page>& pages, const Image& form,
               const PictureRows& picture, const std::string& profile, const std::string& title)
{
    QPDF pdf;
    pdf.emptyPDF();
    auto icc = QPDFObjectHandle::newStream(&pdf, profile);
    icc.getDict().replaceKey("/N", QPDFObjectHandle::newInteger(3));
    icc.getDict().replaceKey("/Alternate", QPDFObjectHandle::newName("/DeviceRGB"));
    auto space = QPDFObjectHandle::newArray();
    space.appendItem(QPDFObjectHandle::newName("/ICCBased"));
    space.appendItem(pdf.makeIndirectObject(icc));
    const auto font = pdf.makeIndirectObject(QPDFObjectHandle::parse(
        "<< /Type /Font /Subtype /Type1 /BaseFont /Helvetica /Encoding /WinAnsiEncoding >>"));

    std::exception_ptr failure; // of reading the picture
    QPDFPageDocumentHelper document(pdf);
    for (const Page& page : pages) {
        auto image = QPDFObjectHandle::newStream(&pdf);
        const auto provide = [&, of = &page](Pipeline* pipeline) { // called when the page is
                                                                   // written
            try {
                draw_part(*of, form, picture, [&](const Image& rows) {
                    std::vector<unsigned char> bytes = samples_of(rows);
                    pipeline->write(bytes.data(), bytes.size());
                });
            } catch (...) { // QPDF would make an error of its own of it
                failure = std::current_exception();
                throw;
            }
            pipeline->finish();
        };
        image.replaceStreamData(provide, QPDFObjectHandle::newNull(), QPDFObjectHandle::newNull());
        auto about = image.getDict();
        about.replaceKey("/Type", QPDFObjectHandle::newName("/XObject"));
        about.replaceKey("/Subtype", QPDFObjectHandle::newName("/Image"));
        about.replaceKey("/Width", QPDFObjectHandle::newInteger(page.part.width));
        about.replaceKey("/Height", QPDFObjectHandle::newInteger(page.part.height));
        about.replaceKey("/BitsPerComponent", QPDFObjectHandle::newInteger(sample_bits(form)));
        about.replaceKey("/ColorSpace", space);
        about.replaceKey("/Interpolate", QPDFObjectHandle::newBool(false));

        auto resources = QPDFObjectHandle::parse("<< /XObject << >> /Font << >> >>");
        resources.getKey("/XObject").replaceKey("/Picture", pdf.makeIndirectObject(image));
        resources.getKey("/Font").replaceKey("/Plain", font);
        const Points points{page};
        auto sheet = QPDFObjectHandle::parse("<< /Type /Page >>");
        sheet.replaceKey("/MediaBox",
                         QPDFObjectHandle::parse(points.box({0, 0, page.width, page.height})));
        sheet.replaceKey("/CropBox", sheet.getKey("/MediaBox"));
        sheet.replaceKey("/BleedBox", QPDFObjectHandle::parse(points.box(
                                          {page.x, page.y, page.part.width, page.part.height})));
        sheet.replaceKey("/TrimBox", QPDFObjectHandle::parse(points.box(page.trimmed)));
        sheet.replaceKey("/Resources", resources);
        sheet.replaceKey("/Contents", pdf.makeIndirectObject(
                                          QPDFObjectHandle::newStream(&pdf, content_of(page))));
        document.addPage(QPDFPageObjectHelper(pdf.makeIndirectObject(sheet)), false);
    }
    pdf.getRoot().replaceKey("/ViewerPreferences",
                             QPDFObjectHandle::parse("<< /PrintScaling /None >>"));
    auto about = QPDFObjectHandle::parse("<< >>");
    about.replaceKey("/Title", QPDFObjectHandle::newUnicodeString(title));
    about.replaceKey("/Producer", QPDFObjectHandle::newString("povray-integral"));
    pdf.getTrailer().replaceKey("/Info", pdf.makeIndirectObject(about));

    SinkStream stream(sink);
    try {
        QPDFWriter writer(pdf);
        writer.setOutputFile("the PDF", stream.file(), false);
        writer.setMinimumPDFVersion("1.6");
        writer.setCompressStreams(true);
        writer.setDeterministicID(true);
        writer.write();
    } catch (...) {
        if (failure)
            std::rethrow_exception(failure);
        stream.check();
        throw;
    }
    std::fflush(stream.file());
    stream.check();
}

} // namespace integral
