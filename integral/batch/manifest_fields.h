// SPDX-License-Identifier: AGPL-3.0-or-later
// Reads and checks single fields of a manifest. Each function throws InputError, with the line and
// the field, for a value that cannot be used.
#ifndef INTEGRAL_BATCH_MANIFEST_FIELDS_H
#define INTEGRAL_BATCH_MANIFEST_FIELDS_H

#include "integral/batch/located_json.h"
#include "integral/batch/manifest.h"

namespace integral {

/// Some names, separated by commas, for a message; "none" if there are none.
std::string list_of(const Names& names);

/// A name that may become part of a file's name: 1 to 100 letters, digits, _ and -, not beginning
/// with -.
std::string name_in(const Located& field);

/// The field "size" of an object; 0 by 0 if it has none.
FrameSize size_in(const Located& object);

/// The name of a regular file that can be read; a relative name starts at `folder`.
std::string readable_file(const Located& field, const std::string& folder);

/// Refuses a text with both kinds of quotation marks, which POV-Ray's command line cannot hold.
void check_quotable(const Located& field, const std::string& text);

/// Refuses a name of a file that povray-integral cannot open: also one with letters outside of
/// ASCII.
void check_renderer_name(const Located& field, const std::string& name);

/// The field "options" of an object, as options of povray-integral that the batch does not give
/// itself; none if there is no such field.
Names renderer_options(const Located& object);

/// The field "options" of an object, as options of the command print, lcd or replay that make sense
/// in a batch. `own_field` names the option that has a field of its own, as "paper".
Names command_options(const Located& object, const std::string& own_field);

/// The field "declare" of an object: identifiers of the scene, and numbers as text.
std::vector<std::pair<std::string, std::string>> declarations(const Located& object);

/// The field "format" of an object, one of `formats`; the first of them if there is no such field.
std::string format_in(const Located& object, const Names& formats);

} // namespace integral

#endif
