// SPDX-License-Identifier: AGPL-3.0-or-later
// Serves pages to a browser on this machine only.
#ifndef INTEGRAL_STUDIO_SERVER_H
#define INTEGRAL_STUDIO_SERVER_H

#include <functional>
#include <memory>
#include <optional>
#include <string>

namespace integral {

/// A request accepted by the server.
struct ServerRequest {
    bool is_post = false; ///< else GET or HEAD
    std::string path;     ///< below the token, decoded: "/", "/picture/3"
    std::string base;     ///< beginning of each link's path: "/TOKEN"
    std::string nonce;    ///< styles and scripts of the answer run only with this nonce
    std::string body;     ///< of a POST; at most 1 MiB
};

struct ServerAnswer {
    int status = 200;
    std::string body;
    std::string type = "text/html; charset=utf-8";
    std::string location = {}; ///< for status 303: the path of the next page
    /// If set, the answer is a stream of server-sent events in place of `body`. Returns the data of
    /// the next event, one line; waits for it at most a few seconds and then returns an empty text.
    /// Returns nothing at the end of the stream. The function is destroyed when the page closes the
    /// stream.
    std::function<std::optional<std::string>()> next_event = {};
};

/// An HTTP server on the loopback interface. Its address contains a random token of 128 bits. A
/// request is refused with status 403 unless its path begins with the token, its Host is this
/// server and its Origin, if any, is too. Pages may use only styles and scripts with the answer's
/// nonce, pictures of their own, and requests to this server.
class Server {
public:
    /// Answers a request; empty: there is no such page (404). Called by several threads at once. An
    /// exception becomes status 500 with its message.
    using Answer = std::function<std::optional<ServerAnswer>(const ServerRequest&)>;

    /// Listens on `port`, or on a free one for 0. Throws OutputError if that fails, or if this
    /// build has no HTTP library.
    Server(int port, Answer answer);
    ~Server();
    Server(const Server&) = delete;
    Server& operator=(const Server&) = delete;

    /// "http://127.0.0.1:PORT/TOKEN/".
    std::string address() const;

    /// Answers requests until `ended`, called several times a second, returns true, or until the
    /// program is interrupted (interrupted()). Finishes the answers under way.
    void run(const std::function<bool()>& ended);

private:
    struct State;
    std::unique_ptr<State> state_;
};

/// Opens an address in the user's browser if there is a display and a program for it (xdg-open).
/// Does not wait for the program. Returns whether the program was started.
bool open_in_browser(const std::string& address);

} // namespace integral

#endif
