// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/studio/server.h"

#include "integral/base/file_bytes.h"
#include "integral/base/interrupt.h"
#include "integral/base/programs.h"

#include <httplib.h>

#include <atomic>
#include <cerrno>
#include <chrono>
#include <cstdlib>
#include <cstring>
#include <thread>
#include <vector>

#include <sys/random.h>
#include <sys/socket.h>

namespace integral {
namespace {

constexpr const char* loopback = "127.0.0.1";
constexpr std::size_t most_content = 1 << 20; // bytes of a request

/// 128 random bits as hexadecimal digits.
std::string random_word()
{
    unsigned char bytes[16];
    if (getrandom(bytes, sizeof bytes, 0) != ssize_t(sizeof bytes))
        throw OutputError(std::string("no random numbers for a token: ") + std::strerror(errno));
    std::string word;
    for (const unsigned char byte : bytes)
        for (const int digit : {byte >> 4, byte & 15})
            word += "0123456789abcdef"[digit];
    return word;
}

/// Whether two texts are equal, in a time independent of the place of a difference.
bool equal_in_constant_time(const std::string& a, const std::string& b)
{
    if (a.size() != b.size())
        return false;
    unsigned difference = 0;
    for (std::size_t k = 0; k < a.size(); ++k)
        difference |= unsigned(a[k] ^ b[k]);
    return difference == 0;
}

/// Sets the headers that isolate an answer's page from other pages.
void set_headers(httplib::Response& response, const std::string& nonce)
{
    response.set_header("Content-Security-Policy",
                        "default-src 'none'; img-src 'self' data: blob:; connect-src 'self'; "
                        "form-action 'self'; base-uri 'none'; frame-ancestors 'none'; script-src "
                        "'nonce-" +
                            nonce + "'; style-src 'nonce-" + nonce + "'");
    response.set_header("X-Content-Type-Options", "nosniff");
    response.set_header("Referrer-Policy", "same-origin");
    response.set_header("Cross-Origin-Resource-Policy", "same-origin");
    response.set_header("Cross-Origin-Opener-Policy", "same-origin");
    response.set_header("Cache-Control", "no-store");
}

void set_sentence(httplib::Response& response, int status, const std::string& sentence)
{
    response.status = status;
    response.set_content(sentence + "\n", "text/plain; charset=utf-8");
}

/// Answers with a stream of server-sent events. A comment in place of an event shows whether the
/// page still reads.
void set_events(httplib::Response& response,
                const std::function<std::optional<std::string>()>& next_event)
{
    response.set_chunked_content_provider(
        "text/event-stream", [next_event](std::size_t, httplib::DataSink& sink) {
            const auto event = next_event();
            if (!event) {
                sink.done();
                return true;
            }
            const std::string text = event->empty() ? ":\n\n" : "data: " + *event + "\n\n";
            return sink.write(text.data(), text.size());
        });
}

} // namespace

struct Server::State {
    httplib::Server http;
    Answer answer;
    std::string token = random_word();
    int port = 0;

    bool is_own(const std::string& host) const
    {
        const std::string at = ":" + std::to_string(port);
        return host == loopback + at || host == "localhost" + at;
    }

    /// The reason for refusing a request; empty if it is accepted.
    std::string refusal(const httplib::Request& request) const
    {
        if (request.get_header_value_count("Host") != 1 ||
            !is_own(request.get_header_value("Host")))
            return "This server answers only at its own address.";
        const std::string scheme = "http://", origin = request.get_header_value("Origin");
        if (request.has_header("Origin") && (origin.compare(0, scheme.size(), scheme) != 0 ||
                                             !is_own(origin.substr(scheme.size()))))
            return "This server answers only its own pages.";
        if (request.path.empty() || request.path[0] != '/' ||
            !equal_in_constant_time(request.path.substr(1, token.size()), token) ||
            (request.path.size() > 1 + token.size() && request.path[1 + token.size()] != '/'))
            return "The token is missing: open the address that the program printed.";
        return "";
    }

    void respond(const httplib::Request& request, httplib::Response& response, bool is_post) const
    {
        const std::string nonce = random_word(), path = request.path.substr(1 + token.size());
        set_headers(response, nonce);
        try {
            const auto found = answer(
                {is_post, path.empty() ? "/" : path, "/" + token, nonce, request.body});
            if (!found)
                return set_sentence(response, 404, "There is no such page.");
            response.status = found->status;
            if (!found->location.empty())
                response.set_header("Location", found->location);
            if (found->next_event)
                set_events(response, found->next_event);
            else
                response.set_content(found->body, found->type.c_str());
        } catch (const std::exception& error) {
            set_sentence(response, 500, error.what());
        }
    }
};

Server::Server(int port, Answer answer) : state_(std::make_unique<State>())
{
    State& s = *state_;
    s.answer = std::move(answer);
    s.http.set_keep_alive_max_count(1); // so that no idle connection delays the end
    s.http.set_payload_max_length(most_content);
    // Not SO_REUSEPORT, with which a second server would get some of the requests.
    s.http.set_socket_options([](auto socket) {
        const int yes = 1;
        setsockopt(socket, SOL_SOCKET, SO_REUSEADDR, &yes, sizeof yes);
    });
    s.http.set_pre_routing_handler(
        [&s](const httplib::Request& request, httplib::Response& response) {
            const std::string refusal = s.refusal(request);
            if (refusal.empty())
                return httplib::Server::HandlerResponse::Unhandled;
            set_headers(response, random_word());
            set_sentence(response, 403, refusal);
            return httplib::Server::HandlerResponse::Handled;
        });
    s.http.Get(".*", [&s](const httplib::Request& request, httplib::Response& response) {
        s.respond(request, response, false);
    });
    s.http.Post(".*", [&s](const httplib::Request& request, httplib::Response& response) {
        s.respond(request, response, true);
    });
    errno = 0;
    const bool bound = port == 0 ? (s.port = s.http.bind_to_any_port(loopback)) > 0
                                 : s.http.bind_to_port(loopback, s.port = port);
    if (!bound)
        throw OutputError("port " + std::to_string(port) + " of this machine cannot be used" +
                          (errno != 0 ? std::string(": ") + std::strerror(errno) : "") +
                          "; without --port a free one is taken");
}

Server::~Server() = default;

std::string Server::address() const
{
    return std::string("http://") + loopback + ":" + std::to_string(state_->port) + "/" +
           state_->token + "/";
}

void Server::run(const std::function<bool()>& ended)
{
    std::atomic<bool> failed = false;
    std::thread listener([&] { failed = !state_->http.listen_after_bind(); });
    const auto wait = [] { std::this_thread::sleep_for(std::chrono::milliseconds(50)); };
    const auto stop = [&] {
        while (!state_->http.is_running() && !failed) // stop() requires a listening server
            wait();
        if (!failed)
            state_->http.stop();
        listener.join();
    };
    try {
        while (!ended() && !interrupted() && !failed)
            wait();
    } catch (...) {
        stop();
        throw;
    }
    stop();
}

bool open_in_browser(const std::string& address)
{
    if (!std::getenv("DISPLAY") && !std::getenv("WAYLAND_DISPLAY"))
        return false;
    return start_program({"xdg-open", address}).process > 0;
}

} // namespace integral
