// SPDX-License-Identifier: AGPL-3.0-or-later
// The words of messages: what files and libraries say becomes one short line of a terminal.
#ifndef INTEGRAL_BASE_MESSAGE_TEXT_H
#define INTEGRAL_BASE_MESSAGE_TEXT_H

#include <cstddef>
#include <exception>
#include <string>

namespace integral {

/// A message as one line of a terminal: each control character, which a name or a file's text may
/// have, becomes a question mark (of those that UTF-8 writes in two bytes, U+0080 to U+009F, each
/// byte). Of a message of more than 2000 bytes only those are left, then "...".
std::string one_line(const std::string& text);

/// What a message quotes of a file: at most the first `most` bytes of a text, then "...".
/// Characters of UTF-8 stay whole.
std::string excerpt(const std::string& text, std::size_t most = 80);

/// Why something failed: what the error says, or that there is too little memory.
std::string reason_of(const std::exception& error);

/// Says one line on standard error, "integral COMMAND: TEXT". Names and other programs' words in
/// the text cannot steer the terminal: each control character becomes a question mark.
void say(const std::string& command, const std::string& text);

} // namespace integral

#endif
