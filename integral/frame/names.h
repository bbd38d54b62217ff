// SPDX-License-Identifier: AGPL-3.0-or-later
// The words for enumeration values in scene files, options and JSON documents.
#ifndef INTEGRAL_FRAME_NAMES_H
#define INTEGRAL_FRAME_NAMES_H

#include "integral/frame/frame_metadata.h"

#include <optional>
#include <string>

namespace integral {

/// The word for a value, as scene files and the JSON document spell it.
const char* name_of(Arrangement);
const char* name_of(LensMapping);
const char* name_of(LensModel);
const char* name_of(Subpixels::Order);
const char* name_of(CellPattern);
const char* name_of(ApertureShape);
const char* name_of(Encoding::Kind);
const char* name_of(ErrorMethod);

/// The inverse of name_of; nothing for any other word. Instantiated for the types above.
template <class Kind> std::optional<Kind> kind_named(const std::string& word);

/// All words of a type, for messages: "lenticular, square or hexagonal".
template <class Kind> std::string legal_names();

} // namespace integral

#endif
