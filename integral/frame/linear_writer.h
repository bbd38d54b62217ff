// SPDX-License-Identifier: AGPL-3.0-or-later
// Stores linear light in pictures of 8 bits without computing each sample's encoding.
#ifndef INTEGRAL_FRAME_LINEAR_WRITER_H
#define INTEGRAL_FRAME_LINEAR_WRITER_H

#include "integral/frame/image.h"

#include <vector>

namespace integral {

/// Does what store_linear does, sample by sample the same. Refers to the image, which must outlive
/// it. Samples of 8 bits without alpha are found in tables, others are computed.
class LinearWriter {
public:
    explicit LinearWriter(Image& image);

    void operator()(int x, int y, Colour linear) const
    {
        if (first_light_.empty()) {
            store_linear(image_, x, y, linear);
            return;
        }
        std::uint8_t* sample = std::get<std::vector<std::uint8_t>>(image_.samples).data() +
                               first_sample(image_, x, y);
        sample[0] = sample_of(linear.r);
        sample[1] = sample_of(linear.g);
        sample[2] = sample_of(linear.b);
    }

private:
    static constexpr int steps = 4096; ///< of light from 0 to 1

    std::uint8_t sample_of(float light) const
    {
        if (!(light > 0))
            return 0;
        if (light >= 1)
            return 255;
        int sample = start_[std::size_t(light * steps)];
        while (light >= first_light_[std::size_t(sample) + 1])
            ++sample;
        return std::uint8_t(sample);
    }

    Image& image_;
    std::vector<float> first_light_;  ///< the least light of each sample; infinite after the last
    std::vector<std::uint8_t> start_; ///< sample of the least light of each step
};

} // namespace integral

#endif
