// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/io/embedded_profile.h"

#include "integral/io/lcms_profile.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstdlib>
#include <limits>
#include <stdexcept>
#include <vector>

namespace integral {
namespace {

/// sRGB's primaries with a curve of linear light.
cmsHPROFILE linear_profile()
{
    struct FreeCurve {
        void operator()(cmsToneCurve* curve) const { cmsFreeToneCurve(curve); }
    };
    const std::unique_ptr<cmsToneCurve, FreeCurve> curve(cmsBuildGamma(nullptr, 1));
    cmsToneCurve* curves[] = {curve.get(), curve.get(), curve.get()};
    const cmsCIExyY white{0.3127, 0.3290, 1};
    const cmsCIExyYTRIPLE primaries{{0.64, 0.33, 1}, {0.30, 0.60, 1}, {0.15, 0.06, 1}};
    return cmsCreateRGBProfile(&white, &primaries, curves);
}

/// Little CMS's code for a pixel format.
cmsUInt32Number pixel_type(Inks inks, int bits, int extra)
{
    const cmsUInt32Number sample = bits == 32 ? FLOAT_SH(1) | BYTES_SH(4)
                                              : BYTES_SH(cmsUInt32Number(bits / 8));
    const auto further = cmsUInt32Number(extra);
    switch (inks) {
    case Inks::grey:
        return COLORSPACE_SH(PT_GRAY) | CHANNELS_SH(1) | EXTRA_SH(further + 2) | sample;
    case Inks::rgb: return COLORSPACE_SH(PT_RGB) | CHANNELS_SH(3) | EXTRA_SH(further) | sample;
    default:
        return COLORSPACE_SH(PT_CMYK) | CHANNELS_SH(4) | sample |
               FLAVOR_SH(inks == Inks::inverted_cmyk ? 1 : 0);
    }
}

bool is_of(const Profile& profile, Inks inks)
{
    const cmsColorSpaceSignature space = cmsGetColorSpace(profile.get());
    return space == (inks == Inks::grey  ? cmsSigGrayData
                     : inks == Inks::rgb ? cmsSigRgbData
                                         : cmsSigCmykData);
}

std::shared_ptr<void> transform(const Profile& source, cmsUInt32Number from, const Profile& target,
                                cmsUInt32Number to)
{
    void* made = source && target
                     ? cmsCreateTransform(source.get(), from, target.get(), to,
                                          INTENT_RELATIVE_COLORIMETRIC,
                                          cmsFLAGS_BLACKPOINTCOMPENSATION | cmsFLAGS_NOCACHE |
                                              cmsFLAGS_HIGHRESPRECALC)
                     : nullptr;
    if (!made)
        throw std::runtime_error("it is no profile that colours can be converted from");
    return {made, cmsDeleteTransform};
}

/// Whether any of a grid of 8-bit colours changes by more than 1.
bool changes_a_grid(const Profile& source, Inks inks)
{
    const Profile target(cmsCreate_sRGBProfile());
    const auto to_srgb = transform(source, pixel_type(inks, 8, 0), target, TYPE_RGB_8);
    constexpr int step = 15;
    std::vector<std::array<std::uint8_t, 3>> colours;
    for (int r = 0; r < 256; r += step)
        for (int g = 0; g < 256; g += step)
            for (int b = 0; b < 256; b += step)
                if (inks == Inks::rgb || (r == g && g == b))
                    colours.push_back({std::uint8_t(r), std::uint8_t(g), std::uint8_t(b)});
    auto converted = colours;
    cmsDoTransform(to_srgb.get(), colours.data(), converted.data(),
                   cmsUInt32Number(colours.size()));
    for (std::size_t k = 0; k < colours.size(); ++k)
        for (std::size_t c = 0; c < 3; ++c)
            if (std::abs(int(converted[k][c]) - int(colours[k][c])) > 1)
                return true;
    return false;
}

template <class Sample>
void convert_cmyk(const void* from, void* to, std::size_t pixels, bool inverted)
{
    constexpr std::uint32_t full = std::numeric_limits<Sample>::max();
    const auto* in = static_cast<const Sample*>(from);
    auto* out = static_cast<Sample*>(to);
    for (; pixels-- > 0; in += 4, out += 3)
        for (int c = 0; c < 3; ++c) {
            const std::uint64_t light = inverted ? in[c] : full - in[c],
                                black = inverted ? in[3] : full - in[3];
            out[c] = Sample((light * black + full / 2) / full);
        }
}

} // namespace

ToWorkingSpace::ToWorkingSpace(const std::string& profile, Inks inks, int bits, int extra)
    : inverted_(inks == Inks::inverted_cmyk), wide_(bits == 16)
{
    const bool is_cmyk = inks == Inks::cmyk || inks == Inks::inverted_cmyk;
    if (profile.empty() && is_cmyk)
        return;
    const Profile source(cmsOpenProfileFromMem(profile.data(), cmsUInt32Number(profile.size())));
    if (!source)
        throw std::runtime_error("it is no ICC profile");
    if (!is_of(source, inks))
        throw std::runtime_error("it is a profile of other inks than the picture's");
    const Profile target(bits == 32 ? linear_profile() : cmsCreate_sRGBProfile());
    transform_ = transform(source, pixel_type(inks, bits, extra), target,
                           pixel_type(Inks::rgb, bits, is_cmyk ? 0 : extra));
    changes_ = is_cmyk || changes_a_grid(source, inks);
}

bool ToWorkingSpace::changes_colours() const { return changes_; }

void ToWorkingSpace::apply(const void* from, void* to, std::size_t pixels) const
{
    if (transform_)
        cmsDoTransform(transform_.get(), from, to, cmsUInt32Number(pixels));
    else if (wide_)
        convert_cmyk<std::uint16_t>(from, to, pixels, inverted_);
    else
        convert_cmyk<std::uint8_t>(from, to, pixels, inverted_);
}

} // namespace integral
