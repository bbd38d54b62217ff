// SPDX-License-Identifier: AGPL-3.0-or-later
// Writes a PDF file object by object.
#ifndef INTEGRAL_IO_PDF_FILE_H
#define INTEGRAL_IO_PDF_FILE_H

#include "integral/base/file_bytes.h"

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace integral {

/// A PDF 1.6 file whose objects are written as soon as they are given. The bytes of a stream are
/// compressed (deflate) as they are written, and the stream's length follows in a separate object,
/// so that a picture of any size needs memory for a few rows only. (QPDF and cairo hold every
/// stream in memory.) Objects are given as PDF text, "<< /Type /Page >>", and refer to each other
/// with reference(). Every function throws what the sink throws. See PDF 32000-1:2008, section 7.5.
class PdfFile {
public:
    /// Writes the header. `sink` must outlive this object.
    explicit PdfFile(ByteSink& sink);

    /// Reserves a number for an object that write() will write later.
    int reserve();

    /// Writes the object with a reserved number.
    void write(int number, const std::string& text);

    /// Writes an object; returns its number.
    int add(const std::string& text);

    /// A function that accepts the next bytes of a stream.
    using TakeBytes = std::function<void(const void* bytes, std::size_t count)>;

    /// Writes a stream; returns its number. `entries`, such as "/N 3", are added to its dictionary,
    /// which also gets length and filter. `provide` is called once, with a function to which it
    /// must pass all the stream's bytes. Throws what `provide` throws.
    int add_stream(const std::string& entries,
                   const std::function<void(const TakeBytes&)>& provide);
    int add_stream(const std::string& entries, const std::string& bytes);

    /// Writes a stream without compression, as readers of metadata expect it; returns its number.
    int add_plain_stream(const std::string& entries, const std::string& bytes);

    /// 32 hexadecimal digits that identify the bytes written so far.
    std::string digest() const;

    /// Writes the cross-reference table and the trailer. `catalog` and `about` are the numbers of
    /// the document catalog and the document information dictionary. Throws std::logic_error if the
    /// object of a reserved number was not written.
    void finish(int catalog, int about);

private:
    void put(const void* bytes, std::size_t count);
    void put(const std::string& text) { put(text.data(), text.size()); }

    ByteSink& sink_;
    std::vector<std::uint64_t> places_; ///< offset of each object, from number 1; 0: not yet
                                        ///< written
    unsigned long crc_, adler_;         ///< checksums of all bytes, which make the file identifier
};

/// A reference to an object: "7 0 R".
std::string reference(int number);

/// UTF-8 text as a PDF text string, for titles: unchanged if it is ASCII, else UTF-16. Bytes that
/// are not valid UTF-8 become U+FFFD.
std::string pdf_text(const std::string& text);

/// UTF-8 as a string for a font in WinAnsiEncoding, which has Latin letters; every other letter
/// becomes a question mark.
std::string pdf_latin_text(const std::string& text);

} // namespace integral

#endif
