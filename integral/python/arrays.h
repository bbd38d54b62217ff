// SPDX-License-Identifier: AGPL-3.0-or-later
// Converts between NumPy arrays and pictures, and between Python's and the library's frames.
#ifndef INTEGRAL_PYTHON_ARRAYS_H
#define INTEGRAL_PYTHON_ARRAYS_H

#include "integral/base/json.h"
#include "integral/frame/frame.h"
#include "integral/frame/picture_fit.h"
#include "integral/frame/view_grid.h"

#include <pybind11/numpy.h>

#include <array>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace integral {

namespace py = pybind11;

/// An array that owns `values`, without copying them.
template <class T> py::array_t<T> array_of(std::vector<T> values, std::vector<py::ssize_t> shape)
{
    auto kept = std::make_unique<std::vector<T>>(std::move(values));
    const T* const data = kept->data();
    py::capsule owner(kept.get(), [](void* p) { delete static_cast<std::vector<T>*>(p); });
    kept.release();
    return py::array_t<T>(std::move(shape), data, owner);
}

/// The samples of a picture as an array [y, x, channel] of uint8, uint16 or float32; they are
/// moved. Another `shape` may have as many elements.
py::array array_of(Image image);
py::array array_of(Image image, std::vector<py::ssize_t> shape);

/// A picture of an array [y, x, channel] of any strides, with 3 or 4 channels. Its samples are
/// uint8 or uint16 (full scale = 1), or real numbers, which become floats. Throws
/// std::invalid_argument for other arrays.
Image image_from(const py::array& array, Encoding encoding, bool premultiplied = false);

/// The form of the picture of an array, as above.
Image form_from(const py::array& array, Encoding encoding, bool premultiplied = false);

/// Arrays with leading axes: [..., y, x, channel], one picture after the other in C order.
std::vector<Image> images_from(const py::array& array, Encoding encoding,
                               bool premultiplied = false);
/// The views of an array [row, column, y, x, channel]. Throws std::invalid_argument.
struct ViewsOfArray {
    std::vector<Image> pictures; ///< row after row
    ViewGrid grid;
};
ViewsOfArray views_from(const py::array& array, Encoding encoding, bool premultiplied = false);

/// Inverse of images_from, for pictures of one size and form, which are freed one by one.
/// `leading`: the leading axes.
py::array array_of(std::vector<Image> pictures, std::vector<py::ssize_t> leading);

/// "srgb", "linear", or the gamma of a power law as a number. Throws std::invalid_argument.
Encoding encoding_from(const py::object& encoding);
py::object python_of(Encoding encoding);

/// "contain", "cover" or "stretch". Throws std::invalid_argument.
Fit fit_from(const std::string& fit);

/// Throws std::invalid_argument, "NAME VALUE: a number from LEAST to GREATEST is expected", for a
/// value outside this range and for NaN.
void check_number(const char* name, double value, double least, double greatest);

/// check_number of `threads`, with the limits of the commands' --threads.
void check_threads(int threads);

/// check_number of both sides of a picture, pixels, if given.
void check_picture_size(const std::optional<std::array<int, 2>>& size, int largest);

/// Throws std::invalid_argument for a number of views, across or up, outside 1 to `most`. `name`:
/// of the argument.
void check_grid(const char* name, const std::pair<int, int>& grid, int most);

constexpr int most_views_one_way = 256;

/// Throws std::invalid_argument for a geometry whose film has no width and height.
void check_film_size(const FrameMetadata& geometry);

/// A JSON document as Python's dicts, lists and numbers, and back.
py::object python_of(const Json& document);
py::object parsed(const std::string& text);
std::string text_of(const py::object& document);

/// The frame of a Python object with the attributes image, encoding, premultiplied and metadata (a
/// dict or None). The samples are copied. Throws std::invalid_argument.
Frame frame_from(const py::object& frame);

/// The checked geometry of such a frame, without its samples. Throws std::invalid_argument.
FrameMetadata geometry_from(const py::object& frame);

/// The frame itself, but requires metadata.
Frame frame_with_geometry(const py::object& frame);

/// (image, encoding, premultiplied, metadata) of a frame; the samples are moved.
py::tuple python_of(Frame frame);

/// The numbers of an array of points with shape (n, columns), contiguous. Throws
/// std::invalid_argument for another shape.
template <class T>
py::array_t<T, py::array::c_style> rows_from(const py::object& points, int columns,
                                             const char* name)
{
    auto array = py::array_t<T, py::array::c_style | py::array::forcecast>::ensure(points);
    if (!array)
        PyErr_Clear();
    if (!array || array.ndim() != 2 || array.shape(1) != columns)
        throw std::invalid_argument(std::string(name) + ": an array of shape (n, " +
                                    std::to_string(columns) + ") is expected");
    return array;
}

} // namespace integral

#endif
