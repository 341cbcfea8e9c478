#pragma once

#include "keiko/viewer/http_message.h"

#include <functional>
#include <memory>
#include <optional>
#include <stop_token>

namespace keiko::viewer {

/// Functions that answer requests, called by several threads at once.
struct HttpHandlers {
    /// The refusal of a request by its head, before the body is read; nullopt if it is allowed.
    std::function<std::optional<HttpReply>(const HttpRequest& head)> refuse;
    std::function<HttpReply(const HttpRequest&)> answer; ///< to a whole request
};

/// HTTP server on this machine's loopback interface, for one user with a few pages open.
class HttpServer {
public:
    /// Binds 127.0.0.1 at a port; 0: one that is free. Throws Error if it is taken.
    explicit HttpServer(int port);
    ~HttpServer();
    HttpServer(const HttpServer&) = delete;
    HttpServer& operator=(const HttpServer&) = delete;

    /// The port that is bound.
    int port() const { return port_; }
    /// Answers requests until a stop is requested; `at_stop` then ends what still runs. Throws
    /// Error if the system closes the socket.
    void serve(const HttpHandlers& handlers, const std::stop_token& stop,
               const std::function<void()>& at_stop);

private:
    struct Library;
    std::unique_ptr<Library> library_;
    int port_ = 0;
};

} // namespace keiko::viewer
