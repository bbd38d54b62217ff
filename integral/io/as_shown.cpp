// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/io/as_shown.h"

#include "integral/base/parallel.h"

#include <cstring>
#include <stdexcept>

namespace integral {
namespace {

std::string unused_profile(const std::runtime_error& why)
{
    return std::string("its colour profile is not used: ") + why.what();
}

/// Converts each row from the picture's profile.
class ConvertedReader : public RowReader {
public:
    ConvertedReader(std::unique_ptr<RowReader> stored, const ToWorkingSpace& colours)
        : stored_(std::move(stored)), colours_(colours)
    {
        head_ = stored_->head();
        head_.profile.clear();
        head_.image.encoding = sample_bits(head_.image) == 32 ? Encoding{Encoding::Kind::linear, 1}
                                                              : Encoding{};
        head_.image.premultiplied = false; // a profile is for unmultiplied colours
        head_.colours_converted = true;
    }

    void read(Image& band) override
    {
        read_own_colours(band);
        for_each_row(band.height, 0, [&](int y) {
            colours_.apply(row_bytes(band, y), row_bytes(band, y), std::size_t(band.width));
        });
    }

    std::vector<std::string> take_notices() override { return stored_->take_notices(); }

private:
    /// Reads rows, dividing premultiplied colours by alpha.
    void read_own_colours(Image& band)
    {
        const Image& form = stored_->head().image;
        if (!form.premultiplied) {
            stored_->read(band);
            return;
        }
        Image rows = blank_like(form, band.width, band.height);
        stored_->read(rows);
        band.samples = converted(rows, sample_bits(form), form.encoding, false).samples;
    }

    std::unique_ptr<RowReader> stored_;
    ToWorkingSpace colours_;
};

/// Turns and mirrors a picture to be upright.
class UprightReader : public RowReader {
public:
    UprightReader(std::unique_ptr<RowReader> stored, int orientation) : stored_(std::move(stored))
    {
        head_ = stored_->head();
        lies_ = orientation >= 5;
        from_right_ = orientation == 2 || orientation == 3 || orientation == 7 || orientation == 8;
        from_below_ = orientation == 3 || orientation == 4 || orientation == 6 || orientation == 7;
        head_.orientation = 1;
        if (!lies_)
            return;
        std::swap(head_.image.width, head_.image.height);
        if (head_.pixel_pitch)
            std::swap(head_.pixel_pitch->x, head_.pixel_pitch->y);
    }

    void read(Image& band) override
    {
        if (all_.height == 0)
            all_ = whole_picture(*stored_).image;
        const std::size_t pixel = std::size_t(band.channels) * std::size_t(sample_bits(band) / 8);
        for (int y = 0; y < band.height; ++y, ++next_)
            for (int x = 0; x < band.width; ++x)
                std::memcpy(row_bytes(band, y) + pixel * std::size_t(x), stored_at(x, next_, pixel),
                            pixel);
    }

    std::vector<std::string> take_notices() override { return stored_->take_notices(); }

private:
    /// The stored pixel that is shown at (x, y).
    const unsigned char* stored_at(int x, int y, std::size_t pixel) const
    {
        const int column = lies_ ? y : x, row = lies_ ? x : y;
        const int i = from_right_ ? all_.width - 1 - column : column,
                  j = from_below_ ? all_.height - 1 - row : row;
        return row_bytes(all_, j) + pixel * std::size_t(i);
    }

    std::unique_ptr<RowReader> stored_;
    bool lies_ = false;                            ///< a stored row is shown as a column
    bool from_right_ = false, from_below_ = false; ///< order of the stored columns and rows
    Image all_;
    int next_ = 0;
};

std::unique_ptr<RowReader> in_working_space(std::unique_ptr<RowReader> stored)
{
    const DecodedImage& head = stored->head();
    if (head.profile.empty())
        return stored;
    constexpr std::size_t colour_space = 16; // offset of the space's name in a profile
    const bool grey = head.grey && head.profile.compare(colour_space, 4, "GRAY") == 0;
    try {
        const ToWorkingSpace colours(head.profile, grey ? Inks::grey : Inks::rgb,
                                     sample_bits(head.image), head.image.channels - 3);
        if (colours.changes_colours())
            return std::make_unique<ConvertedReader>(std::move(stored), colours);
    } catch (const std::runtime_error& error) {
        stored->add_notice(unused_profile(error));
    }
    return stored;
}

} // namespace

std::unique_ptr<RowReader> as_shown(std::unique_ptr<RowReader> stored)
{
    auto reader = in_working_space(std::move(stored));
    const int orientation = reader->head().orientation;
    return turned(std::move(reader), orientation);
}

std::unique_ptr<RowReader> turned(std::unique_ptr<RowReader> stored, int orientation)
{
    if (orientation == 1)
        return stored;
    return std::make_unique<UprightReader>(std::move(stored), orientation);
}

ToWorkingSpace cmyk_conversion(const std::string& profile, Inks inks, int bits, RowReader& reader)
{
    try {
        if (!profile.empty())
            return {profile, inks, bits, 0};
        reader.add_notice("it is CMYK without a colour profile; its colours are approximate");
    } catch (const std::runtime_error& error) {
        reader.add_notice(unused_profile(error));
    }
    return {"", inks, bits, 0};
}

} // namespace integral
