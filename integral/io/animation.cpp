// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/io/animation.h"

#include "integral/io/release.h"

#include <stdexcept>

#ifdef HAVE_WEBP
#include <webp/encode.h>
#include <webp/mux.h>

#include <memory>
#endif

namespace integral {

#ifdef HAVE_WEBP

bool can_animate() { return true; }

/// Sets how a picture is compressed. Quality 100 loses nothing.
static void set_quality(int quality, WebPConfig& config, WebPPicture& picture)
{
    const bool lossless = quality >= 100;
    if (lossless)
        WebPConfigLosslessPreset(&config, 3); // 0 to 9; higher costs seconds per picture and saves
                                              // a few per cent
    else
        config.quality = float(quality);
    config.exact = lossless; // keep the colours of transparent pixels
    config.thread_level = 1;
    picture.use_argb = lossless;
}

void Animation::add(const Image& picture)
{
    if (!pictures_.empty() && (picture.width != width_ || picture.height != height_))
        throw std::runtime_error("the pictures differ in size");
    if (picture.width > largest_side || picture.height > largest_side)
        throw std::runtime_error("a WebP has at most " + std::to_string(largest_side) +
                                 " pixels either way");
    width_ = picture.width;
    height_ = picture.height;
    const Image plain = converted(picture, 8, Encoding(), false);

    WebPConfig config;
    WebPPicture source;
    if (!WebPConfigInit(&config) || !WebPPictureInit(&source))
        throw std::runtime_error("libwebp is of another version than this program was built with");
    const std::unique_ptr<WebPPicture, Release<WebPPicture, WebPPictureFree>> owned(&source);
    WebPMemoryWriter written;
    WebPMemoryWriterInit(&written);
    const std::unique_ptr<WebPMemoryWriter, Release<WebPMemoryWriter, WebPMemoryWriterClear>>
        written_owned(&written);

    set_quality(quality_, config, source);
    source.width = width_;
    source.height = height_;
    source.writer = WebPMemoryWrite;
    source.custom_ptr = &written;
    const std::uint8_t* samples = std::get<std::vector<std::uint8_t>>(plain.samples).data();
    const int stride = width_ * plain.channels;
    if (!(plain.channels == 4 ? WebPPictureImportRGBA : WebPPictureImportRGB)(&source, samples,
                                                                              stride) ||
        !WebPEncode(&config, &source))
        throw std::runtime_error("libwebp could not encode a picture (error " +
                                 std::to_string(source.error_code) + ")");
    pictures_.emplace_back(reinterpret_cast<const char*>(written.mem), written.size);
}

std::string Animation::bytes(int milliseconds, bool there_and_back) const
{
    if (pictures_.empty())
        throw std::runtime_error("there are no pictures");
    const std::unique_ptr<WebPMux, Release<WebPMux, WebPMuxDelete>> mux(WebPMuxNew());
    const WebPMuxAnimParams params = {0xff000000, 0}; // black background; repeat without end
    bool good = mux && WebPMuxSetAnimationParams(mux.get(), &params) == WEBP_MUX_OK;
    const auto push = [&](const std::string& picture) {
        WebPMuxFrameInfo info = {};
        info.bitstream = {reinterpret_cast<const std::uint8_t*>(picture.data()), picture.size()};
        info.duration = milliseconds;
        info.id = WEBP_CHUNK_ANMF;
        info.dispose_method = WEBP_MUX_DISPOSE_NONE;
        info.blend_method = WEBP_MUX_NO_BLEND;
        good = good && WebPMuxPushFrame(mux.get(), &info, 1) == WEBP_MUX_OK;
    };
    for (const std::string& picture : pictures_)
        push(picture);
    if (there_and_back)
        for (std::size_t i = pictures_.size(); i-- > 2;)
            push(pictures_[i - 1]);
    WebPData whole = {};
    const std::unique_ptr<WebPData, Release<WebPData, WebPDataClear>> whole_owned(&whole);
    if (!good || WebPMuxAssemble(mux.get(), &whole) != WEBP_MUX_OK)
        throw std::runtime_error("libwebp could not assemble the animation");
    return std::string(reinterpret_cast<const char*>(whole.bytes), whole.size);
}

#else

bool can_animate() { return false; }

void Animation::add(const Image&) { throw std::runtime_error("this build has no libwebp"); }

std::string Animation::bytes(int, bool) const
{
    throw std::runtime_error("this build has no libwebp");
}

#endif

} // namespace integral
