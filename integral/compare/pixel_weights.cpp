// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/compare/pixel_weights.h"

#include "integral/base/message_text.h"
#include "integral/base/number_text.h"

#include <algorithm>
#include <charconv>
#include <stdexcept>

namespace integral {
namespace {

/// Reads the parts of a region's words, one after the other.
class RegionWords {
public:
    explicit RegionWords(const std::string& words) : words_(words), at_(words.data()) {}

    bool skip(const std::string& text)
    {
        if (std::string(at_, end()).compare(0, text.size(), text) != 0)
            return false;
        at_ += text.size();
        return true;
    }
    void expect(const std::string& text)
    {
        if (!skip(text))
            refuse();
    }
    std::int64_t number(std::int64_t least, std::int64_t greatest)
    {
        std::int64_t value = 0;
        const auto read = std::from_chars(at_, end(), value);
        if (read.ec != std::errc() || value < least || value > greatest)
            refuse();
        at_ = read.ptr;
        return value;
    }
    void expect_end()
    {
        if (at_ != end())
            refuse();
    }

private:
    const char* end() const { return words_.data() + words_.size(); }
    [[noreturn]] void refuse() const
    {
        throw std::invalid_argument("\"" + excerpt(words_) +
                                    "\" is no region; give X,Y,WxH in pixels, or lens:COLUMN,ROW, "
                                    "or ranges of lenses as in "
                                    "lens:0..3,-2..2");
    }
    const std::string& words_;
    const char* at_;
};

} // namespace

Region region_of(const std::string& words, double weight)
{
    Region region;
    region.words = words;
    region.weight = weight;
    RegionWords read(words);
    if (read.skip("lens:")) {
        region.of_lenses = true;
        constexpr std::int64_t most = 1000000000;
        const auto range = [&](std::int64_t& first, std::int64_t& last) {
            first = last = read.number(-most, most);
            if (read.skip(".."))
                last = read.number(first, most);
        };
        range(region.first_column, region.last_column);
        read.expect(",");
        range(region.first_row, region.last_row);
    } else {
        region.x = int(read.number(0, largest_side));
        read.expect(",");
        region.y = int(read.number(0, largest_side));
        read.expect(",");
        region.width = int(read.number(1, largest_side));
        read.expect("x");
        region.height = int(read.number(1, largest_side));
    }
    read.expect_end();
    return region;
}

PixelWeights::PixelWeights(const std::vector<Region>& regions, const std::optional<Image>& mask,
                           int width, int height, const std::optional<FrameMetadata>& metadata)
    : regions_(regions), mask_(mask), width_(width), metadata_(metadata)
{
    if (mask && (mask->width != width || mask->height != height))
        throw std::invalid_argument("the mask has " + size_text(mask->width, mask->height) +
                                    " pixels, the picture has " + size_text(width, height) +
                                    "; make them equal");
    for (const Region& region : regions) {
        if (region.of_lenses && !metadata)
            throw std::invalid_argument("region " + region.words +
                                        ": no frame geometry found; give the region in pixels, "
                                        "X,Y,WxH");
        if (!region.of_lenses && (region.x >= width || region.y >= height))
            throw std::invalid_argument("region " + region.words + " is outside the picture of " +
                                        size_text(width, height) + " pixels");
    }
    std::vector<float> row(std::size_t(width), 0.0f);
    bool counts = false;
    for (int y = 0; y < height && !counts; ++y) {
        fill(y, row.data());
        counts = std::any_of(row.begin(), row.end(), [](float weight) { return weight > 0; });
    }
    if (!counts)
        throw std::invalid_argument("the regions and the mask ignore every pixel; leave some to "
                                    "compare");
}

void PixelWeights::fill(int y, float* weights) const
{
    for (int x = 0; x < width_; ++x) {
        weights[x] = 1;
        if (mask_) {
            const Colour c = stored_pixel(*mask_, x, y);
            weights[x] = mask_->channels == 1
                             ? c.r
                             : std::max(0.0f, 0.2126f * c.r + 0.7152f * c.g + 0.0722f * c.b);
        }
    }
    for (const Region& region : regions_) {
        if (region.of_lenses) {
            const Lattice lattice(metadata_->sheet);
            for (int x = 0; x < width_; ++x) {
                const LensIndex lens = lattice.nearest(
                    film_from_pixel(metadata_->film, {x + 0.5, y + 0.5}));
                if (lens.i >= region.first_column && lens.i <= region.last_column &&
                    lens.j >= region.first_row && lens.j <= region.last_row)
                    weights[x] *= float(region.weight);
            }
        } else if (y >= region.y && y < region.y + region.height) {
            for (int x = region.x; x < std::min(width_, region.x + region.width); ++x)
                weights[x] *= float(region.weight);
        }
    }
}

} // namespace integral
