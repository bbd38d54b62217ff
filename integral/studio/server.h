// SPDX-License-Identifier: AGPL-3.0-or-later
// Serves pages to a browser on this machine, and to nobody else.
#ifndef INTEGRAL_STUDIO_SERVER_H
#define INTEGRAL_STUDIO_SERVER_H

#include <functional>
#include <memory>
#include <optional>
#include <string>

namespace integral {

/// A request that the server let through.
struct ServerRequest {
    bool is_post = false; ///< else GET or HEAD
    std::string path;     ///< below the token, decoded: "/", "/picture/3"
    std::string base;     ///< begins the path of each link: "/TOKEN"
    std::string nonce;    ///< styles and scripts of the answer run only with this nonce
};

struct ServerAnswer {
    int status = 200;
    std::string body;
    std::string type = "text/html; charset=utf-8";
    std::string location = {}; ///< for status 303: the path where the browser goes on
};

/// An HTTP server on the loopback interface. Its address holds a random token of 128 bits. A
/// request is refused with status 403 unless it begins with the token, names this server as its
/// Host and, if it has an Origin, as that. Pages may use only styles and scripts that have the
/// answer's nonce, pictures of their own, and requests to this server.
class Server {
public:
    /// Answers a request; nothing: there is no such page (404). Called by several threads at once.
    /// What it throws becomes status 500 with the sentence.
    using Answer = std::function<std::optional<ServerAnswer>(const ServerRequest&)>;

    /// Listens on `port`, or on a free one for 0. Throws OutputError if that fails, also where this
    /// build has no HTTP library.
    Server(int port, Answer answer);
    ~Server();
    Server(const Server&) = delete;
    Server& operator=(const Server&) = delete;

    /// "http://127.0.0.1:PORT/TOKEN/".
    std::string address() const;

    /// Answers requests until `ended` returns true, which is asked several times a second, or until
    /// the program is interrupted (interrupted()). Answers under way are finished.
    void run(const std::function<bool()>& ended);

private:
    struct State;
    std::unique_ptr<State> state_;
};

/// Opens an address in the user's browser if there is a display and a program that opens one
/// (xdg-open). Does not wait for it. Returns whether it was started.
bool open_in_browser(const std::string& address);

} // namespace integral

#endif
