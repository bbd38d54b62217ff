// SPDX-License-Identifier: AGPL-3.0-or-later
// Replaces server.cpp if the HTTP library is missing.
#include "integral/studio/server.h"

#include "integral/base/file_bytes.h"

namespace integral {

struct Server::State {};

Server::Server(int, Answer)
{
    throw OutputError("this build serves no pages; build it with libcpp-httplib-dev (a package of "
                      "Debian)");
}

Server::~Server() = default;
std::string Server::address() const { return ""; }
void Server::run(const std::function<bool()>&) {}
bool open_in_browser(const std::string&) { return false; }

} // namespace integral
