// SPDX-License-Identifier: AGPL-3.0-or-later
// Whole files as bytes; writing that either succeeds whole or leaves things as they were.
#ifndef INTEGRAL_IO_FILE_BYTES_H
#define INTEGRAL_IO_FILE_BYTES_H

#include <stdexcept>
#include <string>

namespace integral {

/// A text as one line of a terminal: each control character, which a name or a file's text may have, becomes a question mark;
/// of those that UTF-8 writes in two bytes, U+0080 to U+009F, each byte.
std::string one_line(std::string text);

/// An input that cannot be read or makes no sense. The message is one line, "FILE: what is
/// wrong; what would help".
struct InputError : std::runtime_error {
    explicit InputError(const std::string& message) : std::runtime_error(one_line(message)) {}
};

/// An output that could not be written. Same form.
struct OutputError : std::runtime_error {
    explicit OutputError(const std::string& message) : std::runtime_error(one_line(message)) {}
};

/// The name by which messages call a path: "-" is standard input or output.
std::string display_name(const std::string& path, const char* standard_stream);

/// What follows the last dot of a path's own name, in small letters: "png"; empty if there is no dot.
std::string extension_of(const std::string& path);

/// All bytes of a file; "-" reads standard input. Throws InputError.
std::string read_file(const std::string& path);

/// Writes a file: beside it under another name, synced, then renamed over it, so that a file
/// that was there stays whole until the new one is. Devices, pipes and "-" (standard output) are
/// written straight. Throws OutputError.
void write_file(const std::string& path, const std::string& bytes);

/// This machine's name.
std::string host_name();

/// The number of the PID namespace in which this process runs. Containers of one host name have
/// different ones, and a process number means another process in each. Empty where /proc is missing
/// or shows another namespace's processes: then no process can be looked up.
std::string process_namespace();

/// The name under which this process may make a file of a folder before that gets its own:
/// ".integral-NAME.HOST.NAMESPACE.PROCESS". write_file uses such names.
std::string unfinished_name(const std::string& name);

/// Deletes the files of such names in a folder whose makers were killed: those of this machine and
/// PID namespace at once; others, whose makers cannot be asked, once they are a day old, also those
/// that earlier versions named without a namespace.
void sweep_unfinished(const std::string& folder);

/// Throws OutputError if write_file(path, ...) must fail: its folder is missing or read-only.
/// For use before long work.
void check_writable(const std::string& path);

} // namespace integral

#endif
