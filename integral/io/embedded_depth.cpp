// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/io/embedded_depth.h"

#include "integral/base/message_text.h"
#include "integral/io/as_shown.h"
#include "integral/io/codecs.h"
#include "integral/io/exif.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <stdexcept>
#include <vector>

namespace integral {
namespace {

const std::string xmp_name = std::string("http://ns.adobe.com/xap/1.0/") + '\0',
                  extension_name = std::string("http://ns.adobe.com/xmp/extension/") + '\0';

/// The XMP of a JPEG: its main part, and its extension, whose parts are in their own order.
struct Xmp {
    std::string main, extension;
    bool damaged = false; ///< a part of the extension is outside of the whole
};

/// Puts a part of the extension, whose content without its name begins at `begin`, in its place.
void add_part(Xmp& xmp, const std::string& bytes, std::size_t begin, std::size_t end)
{
    constexpr std::size_t guid = 32, head = guid + 8; // bytes before the sizes, and the content
    const TiffNumbers file(bytes, 0); // reads big-endian, as no JPEG begins with II
    const std::size_t whole = file.at(begin + guid, 4), offset = file.at(begin + guid + 4, 4);
    begin = std::min(end, begin + head);
    std::string& extension = xmp.extension;
    xmp.damaged = xmp.damaged || whole > bytes.size() || offset > whole ||
                  end - begin > whole - offset || (!extension.empty() && extension.size() != whole);
    if (xmp.damaged)
        return;
    extension.resize(whole, ' ');
    extension.replace(offset, end - begin, bytes, begin, end - begin);
}

/// The XMP of a JPEG as one text, without a damaged extension. Throws std::runtime_error if depth
/// is in that extension.
std::string xmp_of(const std::string& bytes)
{
    Xmp xmp;
    const TiffNumbers file(bytes, 0);
    for (std::size_t at = 2; at + 4 <= bytes.size() && bytes[at] == '\xff';) {
        const auto marker = std::uint8_t(bytes[at + 1]);
        if (marker == 0xda || marker == 0xd9) // pixels follow, or nothing
            break;
        const std::size_t size = file.at(at + 2, 2), content = at + 4;
        const std::size_t end = std::min(bytes.size(), at + 2 + size);
        const auto begins_with = [&](const std::string& name) {
            return marker == 0xe1 && content + name.size() <= end &&
                   bytes.compare(content, name.size(), name) == 0;
        };
        if (begins_with(xmp_name))
            xmp.main = bytes.substr(content + xmp_name.size(), end - content - xmp_name.size());
        else if (begins_with(extension_name))
            add_part(xmp, bytes, content + extension_name.size(), end);
        at += 2 + std::max<std::size_t>(2, size);
    }
    if (xmp.damaged && xmp.main.find("GDepth:") != std::string::npos)
        throw std::runtime_error("its extended XMP is damaged");
    return xmp.damaged ? xmp.main : xmp.main + xmp.extension;
}

/// The value of a property in XMP, as an attribute or an element; nothing if it is not there.
std::optional<std::string> property(const std::string& xmp, const std::string& name)
{
    for (const char quote : {'"', '\''}) {
        const std::string begin = name + "=" + quote;
        if (const auto at = xmp.find(begin); at != std::string::npos) {
            const auto first = at + begin.size(), end = xmp.find(quote, first);
            if (end != std::string::npos)
                return xmp.substr(first, end - first);
        }
    }
    const std::string begin = "<" + name + ">";
    const auto at = xmp.find(begin), end = xmp.find("</" + name + ">");
    if (at == std::string::npos || end == std::string::npos || end < at + begin.size())
        return std::nullopt;
    return xmp.substr(at + begin.size(), end - at - begin.size());
}

/// The number of a property; `otherwise` if it has none.
double number_of(const std::string& xmp, const std::string& name, double otherwise)
{
    const auto text = property(xmp, name);
    char* end = nullptr;
    const double number = text ? std::strtod(text->c_str(), &end) : otherwise;
    return text && end == text->c_str() ? otherwise : number;
}

/// The bytes of a text in base64; other characters, and XML's escapes of line ends, are skipped.
std::string from_base64(const std::string& text)
{
    std::string bytes;
    std::uint32_t bits = 0;
    int count = 0;
    bool escape = false;
    for (const char c : text) {
        escape = c == '&' || (escape && c != ';');
        const int digit = c >= 'A' && c <= 'Z'   ? c - 'A'
                          : c >= 'a' && c <= 'z' ? c - 'a' + 26
                          : c >= '0' && c <= '9' ? c - '0' + 52
                          : c == '+'             ? 62
                          : c == '/'             ? 63
                                                 : -1;
        if (digit < 0 || escape)
            continue;
        bits = bits << 6 | std::uint32_t(digit);
        count += 6;
        if (count >= 8) {
            count -= 8;
            bytes += char(bits >> count & 255);
        }
    }
    return bytes;
}

/// A part of a Dynamic Depth file, as its list in the XMP describes it.
struct Part {
    bool is_depth = false;
    double length = 0; ///< bytes
};

/// The parts in the list; none if the list is too long or its tags are.
std::vector<Part> parts_in(const std::string& xmp)
{
    constexpr std::size_t most_parts = 64, longest_tag = 4096;
    const std::string mark = "Item:Mime";
    std::vector<Part> parts;
    for (std::size_t at = xmp.find(mark), last = 0; at != std::string::npos;
         at = xmp.find(mark, last)) {
        const std::size_t begin = std::max(last, at - std::min(at, longest_tag));
        const std::string around = xmp.substr(begin, at - begin + longest_tag);
        const std::size_t first = around.rfind('<', at - begin), end = around.find('>', at - begin);
        if (first == std::string::npos || end == std::string::npos || parts.size() == most_parts)
            return {};
        const std::string tag = around.substr(first, end - first);
        const std::string semantic = property(tag, "Item:Semantic").value_or(""),
                          uri = property(tag, "Item:DataURI").value_or("");
        parts.push_back({semantic == "Depth" || uri.find("depth") != std::string::npos,
                         number_of(tag, "Item:Length", 0)});
        last = begin + end;
    }
    return parts;
}

/// The bytes of the depth picture behind a photograph; the parts end where the file ends. Empty if
/// there is none. Throws std::runtime_error if the list has one that the file has not.
std::string appended_depth(const std::string& bytes, const std::string& xmp)
{
    const std::vector<Part> parts = parts_in(xmp);
    double behind = 0;                             // bytes from a part's first to the file's end
    for (std::size_t k = parts.size(); k-- > 1;) { // the first one is the photograph
        const double length = parts[k].length;
        behind = length >= 0 ? behind + length : HUGE_VAL;
        if (!parts[k].is_depth)
            continue;
        if (behind > double(bytes.size()))
            throw std::runtime_error("the file is shorter than its list of parts");
        return bytes.substr(bytes.size() - std::size_t(behind), std::size_t(length));
    }
    return "";
}

std::unique_ptr<RowReader> reader_of(const InputFile& file)
{
    return file.beginning(1) == "\x89" ? read_png(file) : read_jpeg(file);
}

/// Decodes a depth picture and turns it as the photograph is turned, unless its shape shows that
/// it is upright already.
Image decoded(const std::string& bytes, const DecodedImage& photograph)
{
    const InputFile file = InputFile::of_bytes(bytes);
    std::unique_ptr<RowReader> reader = reader_of(file);
    const DecodedImage& head = reader->head();
    int orientation = head.orientation != 1 ? head.orientation : photograph.orientation;
    const auto lies = [](const Image& image) { return image.width > image.height; };
    if (head.orientation == 1 && orientation >= 5 && lies(head.image) != lies(photograph.image))
        orientation = 1;
    reader = turned(std::move(reader), orientation);
    return whole_picture(*reader).image;
}

/// The greys of depth of a format as nearness: 1 for the nearest surface, 0 for the farthest,
/// linear in 1/distance.
Image nearness(const Image& stored, bool of_distance, double near, double far)
{
    Image made = make_image<float>(stored.width, stored.height, 3, {Encoding::Kind::linear, 1});
    const bool converts = of_distance && near > 0 && far > near && std::isfinite(far);
    for (int y = 0; y < stored.height; ++y)
        for (int x = 0; x < stored.width; ++x) {
            const float grey = stored_pixel(stored, x, y).g;
            const double distance = near + grey * (far - near);
            const float part = converts ? float((1 / distance - 1 / far) / (1 / near - 1 / far))
                                        : 1 - grey;
            store_pixel(made, x, y, {part, part, part, 1});
        }
    return made;
}

} // namespace

std::optional<Image> depth_in_jpeg(const std::string& bytes)
{
    if (bytes.compare(0, 2, "\xff\xd8") != 0)
        return std::nullopt;
    const std::string xmp = xmp_of(bytes);
    const auto text = property(xmp, "GDepth:Data");
    const std::string picture = text ? from_base64(*text) : appended_depth(bytes, xmp);
    if (picture.empty())
        return std::nullopt;
    const std::string prefix = text ? "GDepth:" : "DepthMap:";
    const InputFile file = InputFile::of_bytes(bytes);
    const Image stored = decoded(picture, read_jpeg(file)->head());
    return nearness(stored, property(xmp, prefix + "Format") == "RangeLinear",
                    number_of(xmp, prefix + "Near", 0), number_of(xmp, prefix + "Far", 0));
}

std::optional<Image> embedded_depth(const std::string& path)
{
    const std::string extension = extension_of(path);
    if (extension != "jpg" && extension != "jpeg")
        return std::nullopt;
    try {
        return depth_in_jpeg(read_file(path));
    } catch (const InputError&) {
        throw;
    } catch (const std::exception& error) {
        throw InputError(path + ": its depth cannot be read: " + reason_of(error) +
                         "; --depth none leaves it out");
    }
}

} // namespace integral
