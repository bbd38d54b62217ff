// SPDX-License-Identifier: AGPL-3.0-or-later
// Reads JPEG: quilts and views of other programs, photographs, scans and the pictures of MPO pairs.
// 8 bits of grey, colour or CMYK. Damage to a small part of the picture gives a notice; more damage
// gives an error.
#include "integral/io/as_shown.h"
#include "integral/io/codecs.h"
#include "integral/io/exif.h"
#include "integral/io/jpeg_errors.h"

#include "integral/optics/film.h"

#include <algorithm>
#include <cstdlib>
#include <cstring>
#include <jerror.h>
#include <stdexcept>

namespace integral {
namespace {

using namespace std::string_literals;

constexpr double greatest_ratio = 2000; // 64 pixels of a colour in a few bits
constexpr double max_lost = 0.05;       // share of a picture that may be missing

/// Damage to a picture, by libjpeg's warnings. The first member must be a JpegFailure, because
/// libjpeg passes on only its address.
struct JpegHealth {
    JpegFailure failure;
    char warning[JMSG_LENGTH_MAX] = ""; ///< the first warning
    double lost_intervals = 0;          ///< share of the picture lost between restart markers
    double lost_end = 0;                ///< share lost at the picture's end
    bool ends_early = false;

    double lost() const { return std::min(1.0, lost_intervals + lost_end); }
};

/// Whether a warning is about bytes that no pixel depends on.
bool is_harmless(int code)
{
    return code == JWRN_EXTRANEOUS_DATA || code == JWRN_JFIF_MAJOR || code == JWRN_ADOBE_XFORM ||
           code == JWRN_NOT_SEQUENTIAL || code == JWRN_BOGUS_PROGRESSION ||
           code == JWRN_TOO_MUCH_DATA;
}

void on_message(j_common_ptr common, int level)
{
    if (level >= 0)
        return;
    auto& health = *reinterpret_cast<JpegHealth*>(common->err);
    const auto& codec = *reinterpret_cast<j_decompress_ptr>(common);
    const int code = common->err->msg_code;
    if (health.warning[0] == '\0')
        common->err->format_message(common, health.warning);
    health.ends_early |= code == JWRN_JPEG_EOF;
    // An early end alone is harmless in Huffman coding: libjpeg warns again if bits are missing.
    if (is_harmless(code) || (code == JWRN_JPEG_EOF && !codec.arith_code))
        return;
    const double rows = codec.total_iMCU_rows, units = rows * codec.MCUs_per_row;
    if (codec.restart_interval > 0 && !codec.arith_code && units > 0)
        health.lost_intervals += codec.restart_interval / units;
    else if (rows > 0)
        health.lost_end = std::max(health.lost_end, 1 - codec.input_iMCU_row / rows);
}

/// Whether a file that ended before its end marker contained every component and, if progressive,
/// every bit of the coefficients.
bool has_all_scans(const jpeg_decompress_struct& codec)
{
    for (int c = 0; c < codec.num_components; ++c)
        if (!codec.comp_info[c].quant_table)
            return false; // set in the component's first scan
    if (!codec.coef_bits)
        return true;
    for (int c = 0; c < codec.num_components; ++c)
        for (int k = 0; k < DCTSIZE2; ++k)
            if (codec.coef_bits[c][k] != 0)
                return false;
    return true;
}

class JpegReader : public RowReader {
public:
    JpegReader(const InputFile& file, ByteRange range) : bytes_(file.part(range.at, range.count))
    {
        catch_jpeg_errors(health_.failure, codec_.err, on_message);
        try {
            if (!begin())
                throw std::runtime_error(health_.failure.message);
            head_.image = form_of(8, int(codec_.image_width), int(codec_.image_height), 3,
                                  Encoding());
            head_.grey = codec_.num_components == 1;
            check_plausible_size(size_in_bytes(head_.image), double(bytes_.size()), greatest_ratio);
            read_markers();
        } catch (...) {
            jpeg_destroy_decompress(&codec_);
            throw;
        }
    }

    ~JpegReader() override { jpeg_destroy_decompress(&codec_); }

    void read(Image& band) override
    {
        inks_.resize(cmyk_ ? 4 * std::size_t(band.width) : 0);
        for (int y = 0; y < band.height; ++y) {
            unsigned char* row = row_bytes(band, y);
            if (!read_row(cmyk_ ? inks_.data() : row))
                throw std::runtime_error(health_.failure.message);
            if (cmyk_)
                cmyk_->apply(inks_.data(), row, std::size_t(band.width));
        }
        if (codec_.output_scanline == codec_.output_height) {
            if (!finish())
                throw std::runtime_error(health_.failure.message);
            if (health_.ends_early && !complete_)
                health_.lost_end = 1;
        }
        if (health_.lost() > max_lost)
            throw std::runtime_error("up to " + std::to_string(int(100 * health_.lost() + 0.5)) +
                                     "% of it is lost: " + health_.warning);
        if (codec_.output_scanline == codec_.output_height && health_.warning[0])
            add_notice(std::string(health_.warning) +
                       (health_.lost() > 0 ? "; a small part of the picture may be wrong"
                                           : "; it is read all the same"));
    }

private:
    bool begin()
    {
        if (setjmp(health_.failure.place))
            return false;
        jpeg_create_decompress(&codec_);
        constexpr unsigned most_of_a_marker = 65535;
        jpeg_save_markers(&codec_, exif_marker, most_of_a_marker);
        jpeg_save_markers(&codec_, profile_marker, most_of_a_marker);
        jpeg_mem_src(&codec_, reinterpret_cast<const unsigned char*>(bytes_.data()), bytes_.size());
        jpeg_read_header(&codec_, TRUE);
        const bool inks = codec_.jpeg_color_space == JCS_CMYK ||
                          codec_.jpeg_color_space == JCS_YCCK;
        codec_.out_color_space = inks ? JCS_CMYK : JCS_RGB;
        return true;
    }

    bool read_row(unsigned char* row)
    {
        if (setjmp(health_.failure.place))
            return false;
        if (!started_)
            started_ = jpeg_start_decompress(&codec_) != 0;
        jpeg_read_scanlines(&codec_, &row, 1);
        return true;
    }

    bool finish()
    {
        if (setjmp(health_.failure.place))
            return false;
        while (!jpeg_input_complete(&codec_)) // to the end marker
            jpeg_consume_input(&codec_);
        complete_ = has_all_scans(codec_);
        jpeg_finish_decompress(&codec_);
        return true;
    }

    /// Resolution, orientation and profile.
    void read_markers()
    {
        for (auto* marker = codec_.marker_list; marker; marker = marker->next) {
            const std::string data(reinterpret_cast<const char*>(marker->data),
                                   marker->data_length);
            if (marker->marker == exif_marker && data.compare(0, 6, "Exif\0\0"s) == 0) {
                const ExifFacts facts = exif_facts(data.substr(6));
                head_.orientation = facts.orientation;
                head_.pixel_pitch = facts.pixel_pitch;
                break;
            }
        }
        if (codec_.saw_JFIF_marker && codec_.density_unit > 0 && codec_.X_density > 0 &&
            codec_.Y_density > 0) {
            constexpr double mm_per_cm = 10;
            const double mm = codec_.density_unit == 1 ? mm_per_inch : mm_per_cm;
            head_.pixel_pitch = Vec2{mm / codec_.X_density, mm / codec_.Y_density};
        }
        JOCTET* profile = nullptr;
        unsigned size = 0;
        if (has_profile(profile, size)) {
            head_.profile.assign(reinterpret_cast<const char*>(profile), size);
            std::free(profile);
        }
        if (codec_.out_color_space == JCS_CMYK)
            cmyk_ = cmyk_conversion(std::exchange(head_.profile, ""), Inks::inverted_cmyk, 8,
                                    *this);
    }

    bool has_profile(JOCTET*& profile, unsigned& size)
    {
        if (setjmp(health_.failure.place))
            return false;
        return jpeg_read_icc_profile(&codec_, &profile, &size);
    }

    static constexpr int exif_marker = JPEG_APP0 + 1, profile_marker = JPEG_APP0 + 2;
    std::string bytes_;
    JpegHealth health_;
    jpeg_decompress_struct codec_ = {};
    std::optional<ToWorkingSpace> cmyk_;
    std::vector<unsigned char> inks_; ///< a row of CMYK
    bool started_ = false, complete_ = false;
};

} // namespace

std::unique_ptr<RowReader> read_jpeg(const InputFile& file, ByteRange range)
{
    return std::make_unique<JpegReader>(file, range);
}

} // namespace integral
