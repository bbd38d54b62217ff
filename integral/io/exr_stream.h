// SPDX-License-Identifier: AGPL-3.0-or-later
// Lets OpenEXR read an InputFile and write a ByteSink. To be included only by the OpenEXR codec.
#ifndef INTEGRAL_IO_EXR_STREAM_H
#define INTEGRAL_IO_EXR_STREAM_H

#include "integral/base/file_bytes.h"
#include "integral/io/input_file.h"

#include <ImfIO.h>

#include <stdexcept>
#include <utility>

namespace integral {

using ExrOffset = decltype(std::declval<Imf::IStream&>().tellg()); // another type in OpenEXR 2

class ExrSource : public Imf::IStream {
public:
    explicit ExrSource(const InputFile& file) : Imf::IStream("image"), file_(file) {}
    bool read(char data[], int count) override
    {
        if (count < 0)
            throw std::runtime_error("the file ends too early");
        file_.read(position_, data, std::size_t(count));
        position_ += std::uint64_t(count);
        return position_ < file_.size();
    }
    ExrOffset tellg() override { return position_; }
    void seekg(ExrOffset position) override { position_ = position; }

private:
    const InputFile& file_;
    std::uint64_t position_ = 0;
};

class ExrSink : public Imf::OStream {
public:
    explicit ExrSink(ByteSink& sink) : Imf::OStream("image"), sink_(sink) {}
    void write(const char data[], int count) override
    {
        sink_.write(position_, data, std::size_t(count));
        position_ += std::uint64_t(count);
    }
    ExrOffset tellp() override { return position_; }
    void seekp(ExrOffset position) override { position_ = position; }

private:
    ByteSink& sink_;
    std::uint64_t position_ = 0;
};

} // namespace integral

#endif
