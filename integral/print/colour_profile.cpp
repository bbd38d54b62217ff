// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/print/colour_profile.h"

#include "integral/base/parallel.h"
#include "integral/io/lcms_profile.h"

#include <cstring>
#include <stdexcept>

namespace integral {

std::string srgb_profile()
{
    const Profile profile(cmsCreate_sRGBProfile());
    cmsUInt32Number size = 0;
    if (!profile || !cmsSaveProfileToMem(profile.get(), nullptr, &size))
        throw std::runtime_error("Little CMS makes no sRGB profile");
    std::string bytes(size, '\0');
    if (!cmsSaveProfileToMem(profile.get(), bytes.data(), &size))
        throw std::runtime_error("Little CMS makes no sRGB profile");
    constexpr std::size_t date = 24,
                          date_size = 12; // the header's creation date, which would change
    static const unsigned char fixed_date[date_size] = {0x07, 0xd0, 0, 1, 0, 1, 0, 0, 0, 0, 0, 0};
    std::memcpy(bytes.data() + date, fixed_date, date_size);
    return bytes;
}

ProfileTransform::ProfileTransform(const std::string& bytes, int bits, Intent intent)
{
    const Profile source(cmsCreate_sRGBProfile());
    const Profile target(cmsOpenProfileFromMem(bytes.data(), cmsUInt32Number(bytes.size())));
    if (!target)
        throw std::runtime_error("it is no ICC profile");
    const cmsProfileClassSignature kind = cmsGetDeviceClass(target.get());
    if (kind != cmsSigOutputClass && kind != cmsSigDisplayClass && kind != cmsSigColorSpaceClass)
        throw std::runtime_error("it is no printer's profile");
    const bool cmyk = cmsGetColorSpace(target.get()) == cmsSigCmykData;
    if (!cmyk && cmsGetColorSpace(target.get()) != cmsSigRgbData)
        throw std::runtime_error("it is the profile of a device that takes neither RGB nor CMYK");
    if (cmyk && kind != cmsSigOutputClass)
        throw std::runtime_error("it is a CMYK profile, but no press's");
    channels_ = cmyk ? 4 : 3;
    const cmsUInt32Number from = bits == 8 ? TYPE_RGB_8 : TYPE_RGB_16,
                          inks = bits == 8 ? TYPE_CMYK_8 : TYPE_CMYK_16;
    constexpr cmsUInt32Number intents[] = {INTENT_PERCEPTUAL, INTENT_RELATIVE_COLORIMETRIC,
                                           INTENT_SATURATION, INTENT_ABSOLUTE_COLORIMETRIC};
    const cmsUInt32Number flags = intent == Intent::relative ? cmsFLAGS_BLACKPOINTCOMPENSATION : 0;
    void* transform = cmsCreateTransform(source.get(), from, target.get(), cmyk ? inks : from,
                                         intents[int(intent)],
                                         flags | cmsFLAGS_NOCACHE | cmsFLAGS_HIGHRESPRECALC);
    if (!transform)
        throw std::runtime_error("it is no profile that colours can be converted to");
    transform_.reset(transform, cmsDeleteTransform);
}

Image ProfileTransform::apply(Image picture) const
{
    Image inks;
    if (channels_ == 4)
        inks = blank_like(form_of(sample_bits(picture), 0, 0, channels_, picture.encoding),
                          picture.width, picture.height);
    for_each_row(picture.height, 0, [&](int y) {
        unsigned char* row = row_bytes(picture, y);
        cmsDoTransform(transform_.get(), row, channels_ == 4 ? row_bytes(inks, y) : row,
                       cmsUInt32Number(picture.width));
    });
    return channels_ == 4 ? inks : picture;
}

Image in_profile(Image picture, const std::string& profile, Intent intent)
{
    return ProfileTransform(profile, sample_bits(picture), intent).apply(std::move(picture));
}

std::string profile_description(const std::string& bytes)
{
    const Profile profile(cmsOpenProfileFromMem(bytes.data(), cmsUInt32Number(bytes.size())));
    char text[256] = "";
    if (profile)
        cmsGetProfileInfoASCII(profile.get(), cmsInfoDescription, "en", "US", text, sizeof text);
    return text;
}

} // namespace integral
