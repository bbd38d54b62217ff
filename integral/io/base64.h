// SPDX-License-Identifier: AGPL-3.0-or-later
// Bytes as text, for pictures within HTML pages.
#ifndef INTEGRAL_IO_BASE64_H
#define INTEGRAL_IO_BASE64_H

#include <string>

namespace integral {

/// The bytes in base64 (RFC 4648), without line breaks.
std::string base64(const std::string& bytes);

} // namespace integral

#endif
