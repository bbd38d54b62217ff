// SPDX-License-Identifier: AGPL-3.0-or-later
// Reads TIFF: grey, palettes, RGB and CMYK of 1 to 16 bit integers or of floats, with or without
// alpha, in strips or tiles, with the channels together or in planes; also pictures that libtiff
// itself converts to RGB. The document is in ImageDescription, the resolution in the resolution
// tags.
#include "integral/base/memory.h"
#include "integral/io/as_shown.h"
#include "integral/io/codecs.h"
#include "integral/io/tiff_samples.h"
#include "integral/io/tiff_stream.h"

#include "integral/optics/film.h"

#include <algorithm>
#include <cstring>
#include <limits>
#include <stdexcept>

namespace integral {
namespace {

constexpr double greatest_ratio = 10000; // of LZMA and Zstandard for long runs

/// Rows of a TIFF's planes as they are stored, from the top: a row of tiles, a strip of a plane or
/// a single row at a time.
class StoredRows {
public:
    StoredRows(TIFF* tiff, const TiffLayout& layout, double file_bytes) : tiff_(tiff), l_(layout)
    {
        std::uint32_t width = l_.width, rows = 1;
        if (l_.tiled) {
            TIFFGetField(tiff, TIFFTAG_TILEWIDTH, &tile_width_);
            TIFFGetField(tiff, TIFFTAG_TILELENGTH, &rows);
            width = tile_width_ ? (l_.width + tile_width_ - 1) / tile_width_ * tile_width_ : 0;
        } else if (l_.planes() > 1) {
            TIFFGetFieldDefaulted(tiff, TIFFTAG_ROWSPERSTRIP, &rows);
            rows = std::min(rows, l_.height);
        }
        block_rows_ = rows;
        row_bytes_ = (std::size_t(width) * std::size_t(l_.samples_a_plane()) * l_.bits + 7) / 8;
        const double block = double(row_bytes_) * rows * l_.planes();
        check_plausible_size(block, file_bytes, greatest_ratio);
        if (rows == 0 || width == 0 || !has_plausible_rows())
            throw std::runtime_error("its rows are not as long as its size says");
        check_memory(block);
        block_.resize(std::size_t(block));
    }

    /// The bytes of a row of a plane. Rows must be requested in order.
    const unsigned char* row(std::uint32_t y, int plane)
    {
        const std::uint32_t first = y / block_rows_ * block_rows_;
        if (first != loaded_) {
            load(first);
            loaded_ = first;
        }
        return place(y - first, plane);
    }

private:
    bool has_plausible_rows() const
    {
        return l_.tiled ? TIFFTileRowSize64(tiff_) *
                                  (l_.width / tile_width_ + (l_.width % tile_width_ ? 1 : 0)) ==
                              row_bytes_
                        : TIFFScanlineSize64(tiff_) == row_bytes_;
    }

    unsigned char* place(std::uint32_t row, int plane)
    {
        return block_.data() + (std::size_t(plane) * block_rows_ + row) * row_bytes_;
    }

    void load(std::uint32_t first)
    {
        for (int plane = 0; plane < l_.planes(); ++plane)
            if (l_.tiled)
                load_tiles(first, plane);
            else if (block_rows_ == 1 && l_.planes() == 1)
                check(TIFFReadScanline(tiff_, place(0, plane), first, 0) >= 0);
            else
                check(TIFFReadEncodedStrip(
                          tiff_, TIFFComputeStrip(tiff_, first, std::uint16_t(plane)),
                          place(0, plane), tmsize_t(rows_at(first) * row_bytes_)) ==
                      tmsize_t(rows_at(first) * row_bytes_));
    }

    std::size_t rows_at(std::uint32_t first) const
    {
        return std::min(block_rows_, l_.height - first);
    }

    void load_tiles(std::uint32_t first, int plane)
    {
        const std::size_t width = std::size_t(TIFFTileRowSize64(tiff_));
        tile_.resize(width * block_rows_);
        for (std::uint32_t x = 0; x < l_.width; x += tile_width_) {
            check(TIFFReadTile(tiff_, tile_.data(), x, first, 0, std::uint16_t(plane)) >= 0);
            for (std::uint32_t y = 0; y < block_rows_; ++y)
                std::memcpy(place(y, plane) + width * (x / tile_width_), tile_.data() + width * y,
                            width);
        }
    }

    static void check(bool done)
    {
        if (!done)
            fail_tiff("it ends too early");
    }

    TIFF* tiff_;
    const TiffLayout& l_;
    std::uint32_t tile_width_ = 0, block_rows_ = 1;
    std::uint32_t loaded_ = UINT32_MAX; ///< first row in the block
    std::size_t row_bytes_ = 0;
    std::vector<unsigned char> block_, tile_; ///< rows of every plane
};

/// Divides premultiplied integer colours by alpha. Other programs multiply the stored values by
/// alpha; this program multiplies linear light.
template <class Sample> void divide_by_alpha(Sample* pixels, std::size_t count)
{
    constexpr std::uint64_t full = std::numeric_limits<Sample>::max();
    for (; count-- > 0; pixels += 4)
        for (int c = 0; c < 3; ++c)
            pixels[c] = pixels[3] == 0 ? Sample(0)
                                       : Sample(std::min(full, (pixels[c] * full + pixels[3] / 2) /
                                                                   pixels[3]));
}

/// Converts samples as read into the pixels of a picture.
template <class Sample> class Pixels {
public:
    Pixels(const TiffLayout& layout, const std::optional<ToWorkingSpace>& cmyk, int channels)
        : l_(layout),
          cmyk_(cmyk),
          channels_(std::size_t(channels)),
          row_(std::size_t(layout.width) * std::size_t(layout.samples_a_plane()))
    {
    }

    void read(StoredRows& stored, std::uint32_t y, Sample* out)
    {
        inks_.resize(cmyk_ ? 4 * std::size_t(l_.width) : 0);
        for (int plane = 0; plane < l_.planes(); ++plane) {
            unpack(l_, stored.row(y, plane), row_);
            take(plane, out);
        }
        if (cmyk_)
            convert_inks(out);
        else if (l_.inks == 1)
            spread_grey(out);
    }

private:
    /// Puts samples of a plane into their places in the pixels.
    void take(int plane, Sample* out)
    {
        const std::size_t count = std::size_t(l_.samples_a_plane());
        const auto* from = row_.data();
        for (std::size_t x = 0; x < l_.width; ++x, from += count, out += channels_)
            for (std::size_t s = 0; s < count; ++s) {
                const int sample = int(s) + plane;
                if (sample < l_.inks)
                    (cmyk_ ? inks_[4 * x + std::size_t(sample)] : out[sample]) = from[s];
                else if (sample == l_.inks && l_.alpha)
                    out[3] = from[s];
            }
    }

    void convert_inks(Sample* out)
    {
        colours_.resize(3 * std::size_t(l_.width));
        cmyk_->apply(inks_.data(), colours_.data(), l_.width);
        for (std::size_t x = 0; x < l_.width; ++x)
            std::copy_n(&colours_[3 * x], 3, out + channels_ * x);
    }

    void spread_grey(Sample* out) const
    {
        for (std::size_t x = 0; x < l_.width; ++x, out += channels_) {
            const Sample value = out[0];
            for (std::size_t c = 0; c < 3; ++c)
                out[c] = shown(value, c);
        }
    }

    /// Channel c of a grey value or of a palette's index.
    Sample shown(Sample value, std::size_t c) const
    {
        if constexpr (std::is_integral<Sample>::value) {
            if (!l_.palette.empty())
                return Sample(l_.palette[c * (l_.palette.size() / 3) + value] >>
                              (16 - 8 * sizeof(Sample)));
            if (l_.photometric == PHOTOMETRIC_MINISWHITE)
                return Sample(std::numeric_limits<Sample>::max() - value);
        }
        return value;
    }

    const TiffLayout& l_;
    const std::optional<ToWorkingSpace>& cmyk_;
    std::size_t channels_;
    std::vector<Sample> row_, inks_, colours_;
};

std::optional<Vec2> pixel_pitch_of(TIFF* tiff)
{
    float x = 0, y = 0;
    std::uint16_t unit = RESUNIT_INCH;
    TIFFGetFieldDefaulted(tiff, TIFFTAG_RESOLUTIONUNIT, &unit);
    if (!TIFFGetField(tiff, TIFFTAG_XRESOLUTION, &x) ||
        !TIFFGetField(tiff, TIFFTAG_YRESOLUTION, &y) || !(x > 0) || !(y > 0) ||
        unit == RESUNIT_NONE)
        return std::nullopt;
    const double mm = unit == RESUNIT_CENTIMETER ? 10 : mm_per_inch;
    return Vec2{mm / x, mm / y};
}

void go_to_directory(TIFF* tiff, int directory)
{
    if (!TIFFSetDirectory(tiff, std::uint16_t(directory)))
        fail_tiff("it cannot be opened as a TIFF");
}

/// The directories of a file's pictures, without small copies and masks of other pictures; the
/// first directory if there are only such. Leaves another directory open.
std::vector<int> picture_directories(TIFF* tiff)
{
    constexpr int most = 1000;
    std::vector<int> pictures;
    for (int k = 0; k < most; ++k) {
        std::uint32_t kind = 0;
        TIFFGetField(tiff, TIFFTAG_SUBFILETYPE, &kind);
        if (!(kind & (FILETYPE_REDUCEDIMAGE | FILETYPE_MASK)))
            pictures.push_back(k);
        if (TIFFLastDirectory(tiff) || !TIFFReadDirectory(tiff))
            break;
    }
    clear_tiff_error(); // an error in another picture
    return pictures.empty() ? std::vector<int>{0} : pictures;
}

class TiffReader : public RowReader {
public:
    TiffReader(const InputFile& file, std::optional<int> directory)
    {
        stream_.input = &file;
        tiff_ = open_tiff(stream_, "rm"); // m: no memory mapping
        TIFF* tiff = tiff_.get();
        if (directory) {
            go_to_directory(tiff, *directory);
        } else if (!TIFFLastDirectory(tiff)) {
            const std::vector<int> pictures = picture_directories(tiff);
            go_to_directory(tiff, pictures.front());
            if (pictures.size() > 1)
                add_notice("it holds " + std::to_string(pictures.size()) +
                           " pictures; the first is read");
        }
        layout_ = tiff_layout(tiff);
        set_head();
        const Image& form = head_.image;
        check_plausible_size(double(layout_.width) * layout_.height * layout_.samples *
                                 layout_.bits / 8,
                             double(file.size()), greatest_ratio);
        if (!layout_.by_libtiff)
            stored_.emplace(tiff, layout_, double(file.size()));
        if (layout_.inks == 4 && !layout_.by_libtiff)
            cmyk_ = cmyk_conversion(std::exchange(head_.profile, ""), Inks::cmyk, sample_bits(form),
                                    *this);
    }

    void read(Image& band) override
    {
        clear_tiff_error();
        if (layout_.by_libtiff)
            read_converted(band);
        else
            std::visit([&](auto& samples) { read_rows(band, samples); }, band.samples);
        next_ += band.height;
    }

private:
    void set_head()
    {
        TIFF* tiff = tiff_.get();
        const TiffLayout& l = layout_;
        const int bits = l.read_bits();
        head_.image = form_of(bits, int(l.width), int(l.height), l.alpha ? 4 : 3,
                              bits == 32 ? Encoding{Encoding::Kind::linear, 1} : Encoding{});
        head_.orientation = l.orientation;
        head_.grey = l.inks == 1 && l.palette.empty();
        const char* text = nullptr;
        if (TIFFGetField(tiff, TIFFTAG_IMAGEDESCRIPTION, &text) && text && text[0] == '{')
            head_.document = text; // ignore other programs' descriptions, which are not JSON
        divides_ = l.premultiplied && bits != 32 && head_.document.empty();
        head_.image.premultiplied = l.premultiplied && !divides_;
        head_.pixel_pitch = pixel_pitch_of(tiff);
        std::uint32_t size = 0;
        const void* profile = nullptr;
        if (!l.by_libtiff && TIFFGetField(tiff, TIFFTAG_ICCPROFILE, &size, &profile) && profile)
            head_.profile.assign(static_cast<const char*>(profile), size);
    }

    template <class Sample> void read_rows(const Image& band, std::vector<Sample>& samples)
    {
        Pixels<Sample> pixels(layout_, cmyk_, band.channels);
        for (int y = 0; y < band.height; ++y) {
            Sample* row = samples.data() + std::size_t(y) * layout_.width * band.channels;
            pixels.read(*stored_, std::uint32_t(next_ + y), row);
            if constexpr (std::is_integral<Sample>::value)
                if (divides_)
                    divide_by_alpha(row, layout_.width);
        }
    }

    /// Reads rows of a picture that libtiff converts as a whole.
    void read_converted(Image& band)
    {
        if (converted_.empty()) {
            check_memory(4.0 * layout_.width * layout_.height);
            converted_.resize(std::size_t(layout_.width) * layout_.height);
            if (!TIFFReadRGBAImageOriented(tiff_.get(), layout_.width, layout_.height,
                                           converted_.data(), ORIENTATION_TOPLEFT, 1))
                fail_tiff("it ends too early");
        }
        for (int y = 0; y < band.height; ++y) {
            unsigned char* out = row_bytes(band, y);
            const std::uint32_t* from = converted_.data() + std::size_t(next_ + y) * layout_.width;
            for (std::uint32_t x = 0; x < layout_.width; ++x, ++from) {
                *out++ = TIFFGetR(*from);
                *out++ = TIFFGetG(*from);
                *out++ = TIFFGetB(*from);
            }
        }
    }

    TiffStream stream_;
    TiffHandle tiff_;
    TiffLayout layout_;
    bool divides_ = false; ///< divides colours by alpha
    std::optional<StoredRows> stored_;
    std::optional<ToWorkingSpace> cmyk_;
    std::vector<std::uint32_t> converted_; ///< the whole picture, if libtiff converts it
    int next_ = 0;
};

} // namespace

std::unique_ptr<RowReader> read_tiff(const InputFile& file, std::optional<int> directory)
{
    return std::make_unique<TiffReader>(file, directory);
}

std::vector<int> picture_directories_of_tiff(const InputFile& file)
{
    TiffStream stream;
    stream.input = &file;
    return picture_directories(open_tiff(stream, "rm").get());
}

} // namespace integral
