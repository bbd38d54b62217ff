// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/batch/strips.h"

#include "integral/base/file_bytes.h"
#include "integral/base/json.h"
#include "integral/base/number_text.h"
#include "integral/io/codecs.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <filesystem>
#include <set>

namespace integral {

std::vector<RowStrip> row_strips(int height, int strips, int block_side, int reach)
{
    const int blocks = (height + block_side - 1) / block_side,
              number = std::clamp(strips, 1, blocks);
    const int margin = (reach + block_side - 1) / block_side * block_side;
    std::vector<RowStrip> all;
    for (int k = 0; k < number; ++k) {
        RowStrip strip;
        strip.first = int((long long)(blocks)*k / number) * block_side;
        const int end = std::min(height, int((long long)(blocks) * (k + 1) / number) * block_side);
        strip.rows = end - strip.first;
        strip.above = std::min(strip.first, margin);
        strip.below = std::min(height - end, reach);
        all.push_back(strip);
    }
    return all;
}

std::vector<std::string> options_of(const RowStrip& strip, int height)
{
    std::vector<std::string> options;
    const int first = strip.first - strip.above, end = strip.first + strip.rows + strip.below;
    if (first > 0)
        options.push_back("Start_Row=" + std::to_string(first + 1));
    if (end < height)
        options.push_back("End_Row=" + std::to_string(end));
    if (strip.above + strip.below > 0)
        options.push_back("Integral_Rows=" + std::to_string(strip.first + 1) + "," +
                          std::to_string(strip.first + strip.rows));
    return options;
}

namespace {

bool is_exr(const std::string& bytes) { return bytes.compare(0, 4, "\x76\x2f\x31\x01") == 0; }

/// Decodes a picture of either format.
DecodedImage picture_of(const std::string& path, const std::string& bytes)
{
    try {
        return is_exr(bytes) ? decode_exr(bytes) : decode_png(bytes);
    } catch (const std::bad_alloc&) {
        throw;
    } catch (const std::exception& error) {
        throw InputError(path + ": it cannot be read as PNG or OpenEXR: " + error.what());
    }
}

void write_as(bool exr, const DecodedImage& picture, const std::string& path)
{
    write_file(path, exr ? encode_exr(picture) : encode_png(picture));
}

/// Copies `rows` rows between pictures of equal width and format.
void copy_rows(const Image& from, int first, int rows, Image& to, int to_first)
{
    std::visit(
        [&](const auto& source) {
            auto& target = std::get<std::decay_t<decltype(source)>>(to.samples);
            const std::size_t row = std::size_t(from.width) * from.channels;
            std::copy_n(source.begin() + std::ptrdiff_t(row * first), row * rows,
                        target.begin() + std::ptrdiff_t(row * to_first));
        },
        from.samples);
}

/// The content of a strip's file.
struct StripFile {
    DecodedImage picture; ///< its document is the whole frame's
    int first, height;    ///< the strip's first row in the frame, and the frame's height
    bool exr;
};

StripFile read_strip(const std::string& path)
{
    const std::string bytes = read_file(path);
    StripFile strip{picture_of(path, bytes), 0, 0, is_exr(bytes)};
    try {
        const Json record = parse_json(strip.picture.document);
        strip.first = record.at("first_row").get<int>();
        strip.height = record.at("of_rows").get<int>();
        strip.picture.document = record.at("frame").get<std::string>();
    } catch (const JsonError& error) {
        throw InputError(path + ": it does not say which rows of a frame it holds: " +
                         error.what() + "; delete it, so that it is rendered anew");
    } catch (const Json::exception&) {
        throw InputError(path + ": it does not say which rows of a frame it holds; delete it, so "
                                "that it is rendered anew");
    }
    const int rows = strip.picture.image.height;
    if (strip.first < 0 || strip.height < rows || strip.first > strip.height - rows)
        throw InputError(
            path +
            ": the rows that it says it holds cannot be; delete it, so that it is rendered anew");
    return strip;
}

/// A frame's metadata without the fields that differ between strips.
std::string common_part(FrameMetadata metadata)
{
    if (metadata.render) {
        metadata.render->seconds = 0;
        metadata.render->error.reset();
    }
    return to_json(metadata);
}

/// Joins the documents of strips to their frame's document.
class Documents {
public:
    void add(const std::string& path, const StripFile& strip)
    {
        if (strip.picture.document.empty())
            return;
        FrameMetadata metadata;
        try {
            metadata = frame_metadata_from_json(strip.picture.document);
        } catch (const std::invalid_argument& error) {
            throw InputError(path + ": its geometry cannot be used: " + error.what());
        }
        if (whole_ && common_part(*whole_) != common_part(metadata))
            throw InputError(
                path + ": it is a strip of another frame; delete it, so that it is rendered anew");
        if (metadata.render) {
            seconds_ += metadata.render->seconds;
            if (metadata.render->error)
                errors_.push_back(*metadata.render->error);
        }
        if (!whole_)
            whole_ = metadata;
    }

    std::string document()
    {
        if (!whole_)
            return "";
        if (whole_->render) {
            whole_->render->seconds = seconds_;
            whole_->render->error.reset();
            if (!errors_.empty())
                whole_->render->error = combined(errors_);
        }
        return to_json(*whole_);
    }

private:
    std::optional<FrameMetadata> whole_;
    double seconds_ = 0;
    std::vector<ErrorEstimate> errors_;
};

} // namespace

void cut_strip(const std::string& rendered, const RowStrip& strip, const std::string& output)
{
    const std::string bytes = read_file(rendered);
    DecodedImage picture = picture_of(rendered, bytes);
    const int height = picture.image.height;
    if (strip.first < 0 || strip.rows < 1 || strip.first + strip.rows + strip.below > height)
        throw InputError(rendered + ": it has " + counted(height, "row") +
                         ", too few for the strip that it was rendered for");
    Image rows = blank_like(picture.image, picture.image.width, strip.rows);
    copy_rows(picture.image, strip.first, strip.rows, rows, 0);
    picture.image = std::move(rows);
    picture.document = Json{
        {"first_row", strip.first},
        {"of_rows", height},
        {"frame",
         picture.document}}.dump();
    write_as(is_exr(bytes), picture, output);
}

void merge_strips(const std::vector<std::string>& strips, const std::string& output)
{
    if (strips.empty())
        throw InputError(output + ": it has no strips");
    StripFile whole{};
    Documents documents;
    int next = 0;
    for (const std::string& path : strips) {
        if (!std::filesystem::exists(path))
            throw InputError(path +
                             ": this strip is missing; render it before the strips are merged");
        StripFile strip = read_strip(path);
        const Image& image = strip.picture.image;
        if (next == 0) {
            whole = {strip.picture, 0, strip.height, strip.exr};
            whole.picture.image = blank_like(image, image.width, strip.height);
        }
        const Image& frame = whole.picture.image;
        if (image.width != frame.width || strip.height != frame.height ||
            image.channels != frame.channels || image.samples.index() != frame.samples.index() ||
            strip.exr != whole.exr)
            throw InputError(
                path + ": it is a strip of another frame; delete it, so that it is rendered anew");
        if (strip.first != next)
            throw InputError(path + ": it begins at row " + std::to_string(strip.first + 1) +
                             " where row " + std::to_string(next + 1) +
                             " is wanted; delete it, so that it is rendered anew");
        documents.add(path, strip);
        copy_rows(image, 0, image.height, whole.picture.image, next);
        next += image.height;
    }
    if (next != whole.height)
        throw InputError(strips.back() + ": it ends at row " + std::to_string(next) + " of " +
                         std::to_string(whole.height) + ": the strips after it are missing");
    whole.picture.document = documents.document();
    write_as(whole.exr, whole.picture, output);
}

ErrorEstimate combined(const std::vector<ErrorEstimate>& strips)
{
    constexpr double bias = 0.1; // part of the mean square, as in estimate()
    double mean = 0, down = 0, up = 0;
    long long total = 0;
    for (const ErrorEstimate& strip : strips)
        total += strip.lit_pixels;
    ErrorEstimate result = strips.at(0);
    if (strips.size() == 1 || total <= 0)
        return result;
    result.pixels = 0;
    result.seconds = 0;
    for (const ErrorEstimate& strip : strips) {
        const double share = double(strip.lit_pixels) / double(total),
                     square = strip.rms * strip.rms;
        mean += share * square;
        down = std::hypot(down, share * (square - strip.low * strip.low));
        up = std::hypot(up, share * (strip.high * strip.high - square));
        result.pixels += strip.pixels;
        result.seconds += strip.seconds;
    }
    result.rms = std::sqrt(mean);
    result.low = std::sqrt(std::max(0.0, mean - std::max(down, bias * mean)));
    result.high = std::sqrt(mean + std::max(up, bias * mean));
    result.lit_pixels = total;
    return result;
}

namespace {

/// Adds the words of a scene's text, except comments and strings.
void add_words(const std::string& text, std::set<std::string>& words)
{
    const auto at = [&](std::size_t k, const char* what) { return text.compare(k, 2, what) == 0; };
    for (std::size_t k = 0; k < text.size();) {
        if (at(k, "//")) {
            k = std::min(text.find('\n', k), text.size());
        } else if (at(k, "/*")) { // POV-Ray nests these comments
            int depth = 0;
            do {
                depth += at(k, "/*") ? 1 : at(k, "*/") ? -1 : 0;
                k += at(k, "/*") || at(k, "*/") ? 2 : 1;
            } while (depth > 0 && k < text.size());
        } else if (text[k] == '"') {
            for (++k; k < text.size() && text[k] != '"'; ++k)
                k += text[k] == '\\';
            ++k;
        } else if (std::isalpha(static_cast<unsigned char>(text[k])) || text[k] == '_') {
            std::size_t end = k;
            while (end < text.size() &&
                   (std::isalnum(static_cast<unsigned char>(text[end])) || text[end] == '_'))
                ++end;
            words.insert(text.substr(k, end - k));
            k = end;
        } else {
            ++k;
        }
    }
}

} // namespace

std::vector<std::string> words_of_randomness(const std::vector<std::string>& files)
{
    std::set<std::string> words;
    for (const std::string& file : files)
        if (extension_of(file) == "pov" || extension_of(file) == "inc")
            add_words(read_file(file), words);
    std::vector<std::string> found;
    for (const char* word : {"radiosity", "photons", "media", "jitter", "crand", "subsurface"})
        if (words.count(word))
            found.push_back(word);
    return found;
}

} // namespace integral
