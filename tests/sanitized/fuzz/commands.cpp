// SPDX-License-Identifier: AGPL-3.0-or-later
// Runs commands with the geometry that a file may contain: every number is anywhere in the range
// that the file's reader accepts.
#include "tests/sanitized/fuzz/target.h"

#include "integral/cli/command.h"
#include "integral/io/codecs.h"

#include <nlohmann/json.hpp>

#include <cmath>
#include <cstdlib>
#include <filesystem>

int integral_main(int count, char** words); // main of the integral program, as this build calls it

namespace fuzz {
namespace {

using namespace integral;
using Json = nlohmann::ordered_json;

constexpr int film_width = 8, film_height = 6;

/// Makes choices from the bytes of the fuzzer's input.
class Choices {
public:
    explicit Choices(const Bytes& bytes) : bytes_(bytes) {}
    unsigned of(unsigned count) { return byte() % count; }
    /// A number in [least, greatest], evenly distributed in its logarithm. Both must be > 0.
    double size(double least, double greatest)
    {
        return least * std::pow(greatest / least, std::min(1.0, part()));
    }
    /// A number in [least, greatest], often 0, one of the bounds, or halfway between them.
    double within(double least, double greatest)
    {
        switch (of(8)) {
        case 0: return least;
        case 1: return greatest;
        case 2: return least / 2 + greatest / 2;
        default: return least + (greatest - least) * part();
        }
    }
    /// A number of either sign, or 0.
    double signed_size(double greatest)
    {
        const unsigned sign = of(3);
        return sign == 0 ? 0 : (sign == 1 ? 1 : -1) * size(greatest * 1e-20, greatest);
    }
    std::string word(const std::vector<std::string>& words)
    {
        return words[of(unsigned(words.size()))];
    }

private:
    unsigned byte() { return at_ < bytes_.size() ? static_cast<unsigned char>(bytes_[at_++]) : 0; }
    double part() { return (byte() * 256 + byte()) / 65535.0; }
    const Bytes& bytes_;
    std::size_t at_ = 0;
};

/// Geometry that frame_metadata.cpp and find_value_errors accept. `narrow`: the aperture is
/// so small that each film point sees it through few lenses, because a forecast tries thousands of
/// rays.
Json geometry(Choices& c, bool has_picture, bool narrow)
{
    Json json;
    const double pitch = c.size(1.0001e-4, 999), thickness = c.size(1.0001e-6, 0.999e6),
                 distance = c.size(1.0001e-2, 0.999e9);
    json["sheet"] = {{"arrangement", c.word({"lenticular", "square", "hexagonal"})},
                     {"pitch_mm", pitch},
                     {"thickness_mm", thickness},
                     {"ior", c.within(1, 4)},
                     {"slant_degrees", c.of(2) ? c.within(-90, 90) : 0.0},
                     {"offset_mm", {c.signed_size(1e6), c.signed_size(1e6)}}};
    json["film"] = {{"pixel_pitch_mm", {c.size(1.0001e-6, 0.999e4), c.size(1.0001e-6, 0.999e4)}}};
    if (has_picture || c.of(2)) {
        json["film"]["width"] = has_picture ? film_width : int(c.size(1, 1e6));
        json["film"]["height"] = has_picture ? film_height : int(c.size(1, 1e6));
    }
    if (c.of(3) == 0)
        json["film"]["subpixels"] = c.word({"rgb", "bgr"});
    Json& aperture = json["aperture"] = {{"distance_mm", distance}};
    for (const char* extent : {"width_mm", "height_mm"})
        switch (narrow ? 4 : c.of(4)) {
        case 0: aperture[extent] = nullptr; break;
        case 1: aperture[extent] = c.size(1e-9, 0.999e30); break;
        case 2: aperture[extent] = 0; break;
        case 4: aperture[extent] = pitch / thickness * distance * c.size(1e-3, 10); break;
        }
    aperture["shape"] = c.word({"rectangle", "ellipse"});
    if (c.of(4) == 0)
        for (const char* axis : {"origin", "x", "y", "z"})
            json["camera"][axis] = {c.signed_size(1e100), c.signed_size(1e100),
                                    c.signed_size(1e100)};
    if (json.contains("camera"))
        json["camera"]["units_per_mm"] = c.size(1.0001e-100, 0.999e100);
    if (c.of(4) == 0)
        json["encoding"] = {{"kind", "power"}, {"gamma", c.size(0.010001, 99.9)}};
    if (c.of(4) == 0)
        json["render"] = {{"model", c.word({"pinhole", "extended_pinhole", "hybrid", "full"})},
                          {"pixel_samples", int(c.size(1, 65536))},
                          {"beam_samples", int(c.size(1, 65536))}};
    if (c.of(4) == 0) {
        json["quilt"] = {{"columns", int(c.size(1, 4096))}, {"rows", int(c.size(1, 4096))}};
        if (c.of(2))
            json["quilt"]["eyes"] = {{"distance_mm", c.size(1.0001e-2, 0.999e9)},
                                     {"width_mm", c.size(1e-9, 0.999e30)},
                                     {"height_mm", c.size(1e-9, 0.999e30)}};
    }
    return json;
}

/// A path with that extension; everything written to it is discarded.
std::string sink(const std::string& extension)
{
    const std::string path = scratch_path("out." + extension);
    if (!std::filesystem::exists(path))
        std::filesystem::create_symlink("/dev/null", path);
    return path;
}

std::string number(double value)
{
    char text[40];
    std::snprintf(text, sizeof text, "%.17g", value);
    return text;
}

const Bytes& picture()
{
    static const Bytes png = [] {
        Image image = make_image<std::uint8_t>(film_width, film_height, 4, {});
        for (int y = 0; y < film_height; ++y)
            for (int x = 0; x < film_width; ++x)
                store_pixel(image, x, y, {x / 7.0f, y / 5.0f, 0.5f, x == y ? 0.5f : 1.0f});
        return encode_png({image, "", {}, ""});
    }();
    return png;
}

using Arguments = std::vector<std::string>;

/// The words after `integral` of a command that needs no picture.
Arguments words_without_picture(Choices& c, const std::string& sheet)
{
    Arguments words = {"sheet", "--sheet", sheet};
    switch (c.of(8)) {
    case 0: return words;
    case 1: words.push_back("--json"); return words;
    case 2:
    case 3:
    case 4:
    case 5:
        words.insert(words.end(),
                     {"--plot", c.word({"spread", "lens", "sheets", "resolution", "film"}), "-o",
                      sink("svg")});
        return words;
    }
    return {"print", "--chart", "--size", "40x30", "--sheet", sheet, "-o", sink("png")};
}

Arguments words_with_picture(Choices& c, const std::string& sheet)
{
    const std::string frame = file_of(picture(), 1);
    Arguments words;
    switch (c.of(5)) {
    case 0:
        words = {"replay", frame, "--threads", "1", "--samples", "1", "--size", "3x2"};
        if (c.of(2))
            words.insert(words.end(),
                         {"--eye=" + number(c.signed_size(1e6)) + "," + number(c.signed_size(1e6)) +
                          "," + number(c.size(1e-2, 1e6))});
        if (c.of(2))
            words.insert(words.end(), {"--pupil", number(c.size(1e-3, 1e6)),
                                       "--focus=" + number(c.signed_size(1e6)),
                                       "--film-gap=" + number(c.signed_size(1e6))});
        if (c.of(4) == 0)
            words.insert(words.end(), {"--lens-model", "full"});
        switch (c.of(4)) {
        case 0:
            words.insert(words.end(), {"--stereo", number(c.size(1e-3, 1e6)), "-o", sink("png")});
            break;
        case 1: words.insert(words.end(), {"--grid", "3x2", "-o", sink("tiff")}); break;
        case 2: words.insert(words.end(), {"--html", sink("html")}); break;
        default: words.insert(words.end(), {"-o", sink("exr")});
        }
        break;
    case 1:
        words = {"views", frame, "--threads", "1", "-o", "-"};
        // Parallel views have a pixel for each lens. For sheets of very narrow lenses they are so
        // large that drawing them takes too long here.
        if (c.of(2))
            words.insert(words.end(), {"--eyes", "--views", "3x2", "--size", "4x3"});
        else
            words.insert(words.end(), {"--upright", "--views", "2x1", "--size", "4x3"});
        break;
    case 2:
        words = {"views",     "--to-frame", frame,
                 "--threads", "1",          "-o",
                 "-",         "--views",    c.word({"1x1", "2x1", "4x3"})};
        if (c.of(2))
            words.push_back("--eyes");
        break;
    case 3:
        if (c.of(3) == 0) { // a part no larger than the film
            words = {"print", frame, "-o", sink(c.word({"png", "tiff"}))};
            break;
        }
        words = {"print", frame, "-o", sink("pdf")};
        if (c.of(2))
            words.insert(words.end(),
                         {"--marks", "all", "--strip", "--bleed", number(c.size(1e-3, 5000))});
        if (c.of(2))
            words.insert(words.end(), {"--paper", c.word({"a4", "5x5", "5000x5000"}), "--tile",
                                       "--overlap", number(c.size(1e-3, 5000))});
        if (c.of(2))
            words.push_back("--mirror");
        break;
    default: words = {"compare", frame, frame};
    }
    words.insert(words.end(), {"--sheet", sheet});
    return words;
}

} // namespace

void run_command(const Bytes& bytes)
{
    Choices c(bytes);
    const bool has_picture = c.of(4) != 0;
    const std::string document = geometry(c, has_picture, !has_picture).dump(),
                      sheet = file_of(document);
    Arguments words = has_picture ? words_with_picture(c, sheet) : words_without_picture(c, sheet);
    words.insert(words.begin(), "integral");
    std::vector<char*> pointers;
    for (std::string& word : words)
        pointers.push_back(&word[0]);
    if (std::getenv("FUZZ_SHOW")) { // prints the command line that an input's bytes choose
        for (const std::string& word : words)
            std::fprintf(stderr, "%s ", word.c_str());
        std::fprintf(stderr, "\n%s\n", document.c_str());
    }
    if (integral_main(int(pointers.size()), pointers.data()) ==
        exit_check_failed) // nothing is checked: an internal error
        std::abort();
}

} // namespace fuzz
