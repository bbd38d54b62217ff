// SPDX-License-Identifier: AGPL-3.0-or-later
// Frames, their files and their geometry, for Python.
#include "integral/io/image_file.h"
#include "integral/python/arrays.h"
#include "integral/python/calls.h"
#include "integral/python/rooms.h"

namespace integral {

void declare_frame(py::module_& module)
{
    module.def("read", [](const std::string& path, const std::string& sheet) {
        return python_of(
            result_of_long(py::none(), [&](const Progress&) { return read_frame(path, sheet); }));
    });
    module.def("write", [](const py::object& frame, const std::string& path) {
        const Frame made = frame_from(frame);
        run_long(py::none(), [&](const Progress&) { write_frame(path, made); });
    });
    module.def("linear", [](const py::object& frame) {
        const Frame made = frame_from(frame);
        return array_of(result_of_long(py::none(), [&](const Progress&) {
            return converted(made.image, 32, {Encoding::Kind::linear}, false);
        }));
    });
    // (encoding, metadata) of a new frame: complete, and checked against its image.
    module.def("complete",
               [](const py::array& image, const py::object& encoding,
                  const py::object& document) -> py::tuple {
                   std::optional<FrameMetadata> metadata;
                   if (!document.is_none())
                       metadata = frame_metadata_from_json(text_of(document));
                   Frame form;
                   form.image = form_from(image, !encoding.is_none() ? encoding_from(encoding)
                                                 : metadata          ? metadata->encoding
                                                                     : Encoding());
                   if (metadata)
                       set_metadata(form, *metadata);
                   return py::make_tuple(python_of(form.image.encoding),
                                         metadata ? parsed(to_json(*form.metadata)) : py::none());
               });
    // The complete document of a geometry: with all defaults, in the order of files.
    module.def("document", [](const py::object& document) {
        return parsed(to_json(frame_metadata_from_json(text_of(document))));
    });
}

} // namespace integral
