// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/python/arrays.h"

#include "integral/base/number_text.h"
#include "integral/frame/names.h"

#include <cstring>
#include <stdexcept>
#include <type_traits>

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
    const char kind = array.dtype().kind(); // whatever the order of bytes
    const int bits = kind == 'u' && array.itemsize() <= 2 ? 8 * int(array.itemsize())
                     : kind == 'f'                        ? 32
                                                          : 0;
    if (bits == 0)
        throw std::invalid_argument("an array of " + std::string(py::str(array.dtype())) +
                                    " is no picture; its samples must be uint8, uint16 or real "
                                    "numbers, where 1 is full scale");
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

/// Throws std::invalid_argument for a Python frame without metadata.
void require_metadata(const py::object& frame)
{
    if (frame.attr("metadata").is_none())
        throw std::invalid_argument("the frame has no geometry; give it sheet, film and aperture");
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
    if (array.ndim() != 3)
        throw_no_picture(array);
    return std::move(images_from(array, encoding, premultiplied)[0]);
}

ViewsOfArray views_from(const py::array& array, Encoding encoding, bool premultiplied)
{
    if (array.ndim() != 5)
        throw std::invalid_argument("views: an array [row, column, y, x, channel] is expected");
    return {images_from(array, encoding, premultiplied),
            {int(array.shape(1)), int(array.shape(0))}};
}

py::array array_of(std::vector<Image> pictures, std::vector<py::ssize_t> leading)
{
    const Image form = form_of(pictures.at(0));
    for (const int side : {form.height, form.width, form.channels})
        leading.push_back(side);
    return std::visit(
        [&](auto& first) -> py::array {
            using Values = std::decay_t<decltype(first)>;
            Values all;
            {
                const py::gil_scoped_release released;
                all.reserve(first.size() * pictures.size());
                for (Image& picture : pictures) {
                    const Values samples = std::get<Values>(std::exchange(picture.samples, {}));
                    all.insert(all.end(), samples.begin(), samples.end());
                }
            }
            return array_of(std::move(all), std::move(leading));
        },
        pictures[0].samples);
}

void check_number(const char* name, double value, double least, double greatest)
{
    if (!(value >= least && value <= greatest))
        throw std::invalid_argument(std::string(name) + " " + with_digits(value, 10) +
                                    ": a number from " + with_digits(least, 10) + " to " +
                                    with_digits(greatest, 10) + " is expected");
}

void check_threads(int threads) { check_number("threads", threads, 0, 1024); }

void check_picture_size(const std::optional<std::array<int, 2>>& size, int largest)
{
    for (const int side : size.value_or(std::array<int, 2>{1, 1}))
        check_number("size", side, 1, largest);
}

void check_grid(const char* name, const std::pair<int, int>& grid, int most)
{
    for (const int number : {grid.first, grid.second})
        check_number(name, number, 1, most);
}

void check_film_size(const FrameMetadata& geometry)
{
    if (geometry.film.width < 1 || geometry.film.height < 1)
        throw std::invalid_argument("the film has no width and height; give the frame's pixels");
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
    require_metadata(frame);
    Frame form;
    form.image = form_from(frame.attr("image"), encoding_from(frame.attr("encoding")));
    set_metadata(form, frame_metadata_from_json(text_of(frame.attr("metadata"))));
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
    require_metadata(frame);
    return frame_from(frame);
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
