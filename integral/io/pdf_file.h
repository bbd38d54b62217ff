// SPDX-License-Identifier: AGPL-3.0-or-later
// Writing a PDF file object by object.
#ifndef INTEGRAL_IO_PDF_FILE_H
#define INTEGRAL_IO_PDF_FILE_H

#include "integral/base/file_bytes.h"

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace integral {

/// A PDF 1.6 file whose objects are written as soon as they are known. A stream's bytes are packed
/// (deflate) on their way to the file, and its length is written behind it: so that a picture of
/// any size takes no more memory than the rows that it is given in. (QPDF and cairo keep every
/// stream whole.) Objects are given as PDF text, "<< /Type /Page >>", and refer to each other by
/// reference(). Every function throws what the sink throws. After "PDF 32000-1:2008", 7.5.
class PdfFile {
public:
    /// Writes the header. `sink` has to outlive this.
    explicit PdfFile(ByteSink& sink);

    /// A number for an object that is written later, by write().
    int reserve();

    /// Writes the object of a reserved number.
    void write(int number, const std::string& text);

    /// Writes an object; returns its number.
    int add(const std::string& text);

    /// Takes the next bytes of a stream.
    using TakeBytes = std::function<void(const void* bytes, std::size_t count)>;

    /// Writes a stream; returns its number. `entries` stand in its dictionary beside length and
    /// filter: "/N 3". `provide` hands all its bytes to the function that it is given. Throws what
    /// `provide` throws.
    int add_stream(const std::string& entries,
                   const std::function<void(const TakeBytes&)>& provide);
    int add_stream(const std::string& entries, const std::string& bytes);

    /// Writes the table of objects and what points to it. `catalog` and `about` are the numbers of
    /// the document's catalog and of its title and producer. Throws std::logic_error where a
    /// reserved number was not written.
    void finish(int catalog, int about);

private:
    void put(const void* bytes, std::size_t count);
    void put(const std::string& text) { put(text.data(), text.size()); }

    ByteSink& sink_;
    std::vector<std::uint64_t> places_; ///< of each object from 1 on; 0: not written yet
    unsigned long crc_, adler_;         ///< of all bytes: the file's identifier
};

/// How an object is referred to: "7 0 R".
std::string reference(int number);

/// UTF-8 as a PDF text string, for titles: as it is where it is ASCII, else in UTF-16. Letters that
/// are no valid UTF-8 become U+FFFD.
std::string pdf_text(const std::string& text);

} // namespace integral

#endif
