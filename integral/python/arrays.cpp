// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/python/arrays.h"

#include "integral/frame/names.h"

#include <cstring>
#include <stdexcept>

namespace integral {
namespace {

std::string shape_text(const py::array& array)
{
    std::string text;
    for (py::ssize_t k = 0; k < array.ndim(); ++k)
        text += (k ? ", " : "") + std::to_string(array.shape(k));
    return "(" + text + ")";
}

[[noreturn]] void throw_no_picture(const py::array& array)
{
    throw std::invalid_argument("an array of shape " + shape_text(array) +
                                " is no picture; (rows, columns, 3) or (rows, columns, 4) is "
                                "expected");
}

/// The form of the pictures in an array [..., y, x, channel].
Image form_of_pictures(const py::array& array, Encoding encoding, bool premultiplied)
{
    const py::ssize_t axes = array.ndim();
    const auto side = [&](int from_last) { return array.shape(axes - 1 - from_last); };
    if (axes < 3 || array.size() == 0 || (side(0) != 3 && side(0) != 4) || side(1) > largest_side ||
        side(2) > largest_side)
        throw_no_picture(array);
    const int bits = py::isinstance<py::array_t<std::uint8_t>>(array)    ? 8
                     : py::isinstance<py::array_t<std::uint16_t>>(array) ? 16
                     : array.dtype().kind() == 'f'                       ? 32
                                                                         : 0;
    if (bits == 0)
        throw std::invalid_argument("an array of " + std::string(py::str(array.dtype())) +
                                    " is no picture; its samples must be uint8, uint16 or real "
                                    "numbers, of which 1 is full scale");
    Image form = form_of(bits, int(side(1)), int(side(2)), int(side(0)), encoding);
    form.premultiplied = premultiplied;
    return form;
}

/// An array in C order, with samples of type Sample.
template <class Sample> py::array contiguous(const py::array& array)
{
    const auto made = py::array_t<Sample, py::array::c_style | py::array::forcecast>::ensure(array);
    if (!made)
        throw py::error_already_set();
    return made;
}

} // namespace

py::array array_of(Image image)
{
    const std::vector<py::ssize_t> shape{image.height, image.width, image.channels};
    return array_of(std::move(image), shape);
}

py::array array_of(Image image, std::vector<py::ssize_t> shape)
{
    return std::visit(
        [&](auto& samples) -> py::array { return array_of(std::move(samples), std::move(shape)); },
        image.samples);
}

std::vector<Image> images_from(const py::array& array, Encoding encoding, bool premultiplied)
{
    const Image form = form_of_pictures(array, encoding, premultiplied);
    const int bits = sample_bits(form);
    const py::array samples = bits == 8    ? contiguous<std::uint8_t>(array)
                              : bits == 16 ? contiguous<std::uint16_t>(array)
                                           : contiguous<float>(array);
    const auto* const first = static_cast<const unsigned char*>(samples.data());
    const auto bytes = std::size_t(size_in_bytes(form));
    std::vector<Image> images;
    for (std::size_t at = 0; at < std::size_t(samples.nbytes()); at += bytes) {
        images.push_back(blank_like(form, form.width, form.height));
        std::memcpy(row_bytes(images.back(), 0), first + at, bytes);
    }
    return images;
}

Image form_from(const py::array& array, Encoding encoding, bool premultiplied)
{
    if (array.ndim() != 3)
        throw_no_picture(array);
    return form_of_pictures(array, encoding, premultiplied);
}

Image image_from(const py::array& array, Encoding encoding, bool premultiplied)
{
    form_from(array, encoding);
    return std::move(images_from(array, encoding, premultiplied)[0]);
}

py::array array_of(const std::vector<Image>& pictures, std::vector<py::ssize_t> leading)
{
    const Image& first = pictures.at(0);
    Image all = blank_like(first, first.width, first.height * int(pictures.size()));
    for (std::size_t k = 0; k < pictures.size(); ++k)
        std::memcpy(row_bytes(all, int(k) * first.height), row_bytes(pictures[k], 0),
                    std::size_t(size_in_bytes(first)));
    for (const int side : {first.height, first.width, first.channels})
        leading.push_back(side);
    return array_of(std::move(all), std::move(leading));
}

Encoding encoding_from(const py::object& encoding)
{
    if (py::isinstance<py::float_>(encoding) || py::isinstance<py::int_>(encoding)) {
        const double gamma = encoding.cast<double>();
        if (gamma >= 0.01 && gamma <= 100)
            return {Encoding::Kind::power, gamma};
    } else if (py::isinstance<py::str>(encoding)) {
        const auto kind = kind_named<Encoding::Kind>(encoding.cast<std::string>());
        if (kind && *kind != Encoding::Kind::power)
            return {*kind};
    }
    throw std::invalid_argument("encoding " + std::string(py::str(encoding)) +
                                ": \"srgb\", \"linear\" or a gamma from 0.01 to 100 is expected");
}

Fit fit_from(const std::string& fit)
{
    if (fit == "contain")
        return Fit::contain;
    if (fit == "cover")
        return Fit::cover;
    if (fit == "stretch")
        return Fit::stretch;
    throw std::invalid_argument("fit " + fit + ": contain, cover or stretch is expected");
}

py::object python_of(Encoding encoding)
{
    if (encoding.kind == Encoding::Kind::power)
        return py::float_(encoding.gamma);
    return py::str(name_of(encoding.kind));
}

py::object parsed(const std::string& text)
{
    return py::module_::import("json").attr("loads")(text);
}

py::object python_of(const Json& document) { return parsed(document.dump()); }

std::string text_of(const py::object& document)
{
    return py::module_::import("json").attr("dumps")(document).cast<std::string>();
}

FrameMetadata geometry_from(const py::object& frame)
{
    const py::object metadata = frame.attr("metadata");
    if (metadata.is_none())
        throw std::invalid_argument("the frame has no geometry; give it sheet, film and aperture");
    Frame form;
    form.image = form_from(frame.attr("image"), encoding_from(frame.attr("encoding")));
    set_metadata(form, frame_metadata_from_json(text_of(metadata)));
    return *form.metadata;
}

Frame frame_from(const py::object& frame)
{
    Frame made;
    made.image = image_from(frame.attr("image"), encoding_from(frame.attr("encoding")),
                            frame.attr("premultiplied").cast<bool>());
    const py::object metadata = frame.attr("metadata");
    if (!metadata.is_none())
        set_metadata(made, frame_metadata_from_json(text_of(metadata)));
    return made;
}

Frame frame_with_geometry(const py::object& frame)
{
    const FrameMetadata geometry = geometry_from(frame);
    Frame made = frame_from(frame);
    made.metadata = geometry;
    return made;
}

py::tuple python_of(Frame frame)
{
    const py::object encoding = python_of(frame.image.encoding),
                     metadata = frame.metadata ? parsed(to_json(*frame.metadata))
                                               : py::object(py::none());
    const bool premultiplied = frame.image.premultiplied;
    return py::make_tuple(array_of(std::move(frame.image)), encoding, premultiplied, metadata);
}

} // namespace integral
