// SPDX-License-Identifier: AGPL-3.0-or-later
// Makes messages safe and short for a terminal, and prints them.
#ifndef INTEGRAL_BASE_MESSAGE_TEXT_H
#define INTEGRAL_BASE_MESSAGE_TEXT_H

#include <cstddef>
#include <exception>
#include <string>

namespace integral {

/// A message as one terminal line: each byte of a control character (also of the two-byte ones of
/// UTF-8, U+0080 to U+009F) becomes a question mark. A message longer than 2000 bytes is cut to
/// that length and ends in "...".
std::string one_line(const std::string& text);

/// A text to be quoted in a message: cut after at most `most` bytes, then "...". No UTF-8 character
/// is split.
std::string excerpt(const std::string& text, std::size_t most = 80);

/// Why something failed: the exception's what(), or for std::bad_alloc a sentence about memory.
std::string reason_of(const std::exception& error);

/// Prints one line on standard error, "integral COMMAND: TEXT". The text goes through one_line(),
/// so that file names and other programs' output cannot send control sequences to the terminal.
void say(const std::string& command, const std::string& text);

} // namespace integral

#endif
