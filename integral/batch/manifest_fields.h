// SPDX-License-Identifier: AGPL-3.0-or-later
// Reads and checks single fields of a manifest. Each function throws InputError, with the line and
// the field, for a value that cannot be used.
#ifndef INTEGRAL_BATCH_MANIFEST_FIELDS_H
#define INTEGRAL_BATCH_MANIFEST_FIELDS_H

#include "integral/batch/manifest.h"
#include "integral/batch/source_json.h"

namespace integral {

/// A comma-separated list of some names, for a message; "none" if there are none.
std::string list_of(const Names& names);

/// A name that may become part of a file's name: 1 to 100 letters, digits, _ and -, not beginning
/// with -.
std::string name_in(const SourceJson& field);

/// The field "size" of an object; 0 by 0 if there is none.
FrameSize size_in(const SourceJson& object);

/// A file's name, unchanged. Checks that the file (relative to `folder`) is regular and readable.
std::string readable_file(const SourceJson& field, const std::string& folder);

/// Rejects a text with both kinds of quotation marks, which POV-Ray's command line cannot hold.
void check_quotable(const SourceJson& field, const std::string& text);

/// Rejects a file name that povray-integral cannot open: non-ASCII, or with both quotation marks.
void check_renderer_name(const SourceJson& field, const std::string& name);

/// The field "options" of an object, as options of povray-integral that the batch does not set
/// itself; empty if there is no such field.
Names renderer_options(const SourceJson& object);

/// The field "options" of an object, as options of print, lcd or replay that make sense in a batch.
/// `own_field` names the option that has a field of its own, e.g. "paper".
Names command_options(const SourceJson& object, const std::string& own_field);

/// The field "declare" of an object: identifiers of the scene, and numbers as text.
std::vector<std::pair<std::string, std::string>> declarations(const SourceJson& object);

/// The field "format" of an object, one of `formats`; the first of them if there is no such field.
std::string format_in(const SourceJson& object, const Names& formats);

} // namespace integral

#endif
