#include "keiko/viewer/http_server.h"

#include "keiko/base/error.h"
#include "keiko/base/text.h"
#include "keiko/viewer/access.h"

#include <httplib.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <thread>

namespace keiko::viewer {
namespace {

/// A browser keeps up to six connections of a page, and each takes a thread.
constexpr std::size_t threads = 32;
/// s that a connection may rest: as long as the end of the server waits for it.
constexpr time_t rest = 1;
/// s within which a client must go on to send, and to read: a page that draws by software may
/// pause.
constexpr time_t patience = 5, write_patience = 20;
constexpr std::size_t most_requests = 1'000'000; ///< of one connection
/// Bytes that are written at once: of a larger piece the library would make a copy.
constexpr std::size_t piece = 1 << 18;

HttpRequest request_of(const httplib::Request& from) {
    HttpRequest request{from.method, from.path, {}, from.body};
    for (const auto& [name, value] : from.headers) {
        std::string& all = request.headers[lower_case(name)];
        all += (all.empty() ? "" : ",") + value;
    }
    return request;
}

class LibraryOutlet : public Outlet {
public:
    explicit LibraryOutlet(httplib::DataSink& sink) : sink_(sink) {}

    bool write(std::string_view bytes) override {
        for (; !bytes.empty(); bytes.remove_prefix(std::min(bytes.size(), piece)))
            if (!sink_.write(bytes.data(), std::min(bytes.size(), piece))) return false;
        return true;
    }
    bool is_open() const override { return sink_.is_writable(); }

private:
    httplib::DataSink& sink_;
};

/// Sends a body and ends the connection, on which an unread body may follow: the library ends it
/// after a body that reports to be incomplete.
void set_last_body(httplib::Response& to, const HttpReply& reply) {
    const auto send = [body = reply.body](std::size_t, std::size_t, httplib::DataSink& sink) {
        sink.write(body.data(), body.size());
        return false;
    };
    to.set_header("Connection", "close");
    to.set_content_provider(reply.body.size(), reply.type.c_str(), send);
}

void set_reply(httplib::Response& to, HttpReply reply) {
    to.status = reply.status;
    if (reply.ends_connection) return set_last_body(to, reply);
    if (!reply.stream) return to.set_content(std::move(reply.body), reply.type.c_str());
    to.set_chunked_content_provider(reply.type.c_str(), [stream = std::move(reply.stream)](
                                                            std::size_t, httplib::DataSink& sink) {
        LibraryOutlet outlet(sink);
        if (!stream(outlet)) return false;
        sink.done();
        return true;
    });
}

/// A page may load and reach nothing but this server, and is shown in no page of others.
httplib::Headers safe_headers() {
    return {{"Content-Security-Policy",
             "default-src 'self'; base-uri 'none'; form-action 'none'; frame-ancestors 'none'"},
            {"X-Content-Type-Options", "nosniff"},
            {"Referrer-Policy", "no-referrer"},
            {"Cross-Origin-Opener-Policy", "same-origin"},
            {"Cross-Origin-Resource-Policy", "same-origin"},
            {"Cache-Control", "no-store"}};
}

/// Unlike the library's own, which let two servers share a port.
void set_socket_options(socket_t socket) {
    const int yes = 1;
    setsockopt(socket, SOL_SOCKET, SO_REUSEADDR, &yes, sizeof yes);
}

} // namespace

struct HttpServer::Library {
    httplib::Server server;
};

HttpServer::HttpServer(int port) : library_(std::make_unique<Library>()) {
    httplib::Server& server = library_->server;
    server.new_task_queue = [] { return new httplib::ThreadPool(threads); };
    server.set_tcp_nodelay(true);
    server.set_socket_options(set_socket_options);
    server.set_keep_alive_max_count(most_requests);
    server.set_keep_alive_timeout(rest);
    server.set_read_timeout(patience), server.set_write_timeout(write_patience);
    server.set_payload_max_length(most_body);
    server.set_default_headers(safe_headers());
    constexpr const char* loopback = "127.0.0.1";
    if (port == 0)
        port_ = server.bind_to_any_port(loopback);
    else
        port_ = server.bind_to_port(loopback, port) ? port : -1;
    if (port_ <= 0) throw FieldError("port", "cannot be opened on 127.0.0.1; it may be taken");
}

HttpServer::~HttpServer() = default;

void HttpServer::serve(const HttpHandlers& handlers, const std::stop_token& stop,
                       const std::function<void()>& at_stop) {
    httplib::Server& server = library_->server;
    using Handled = httplib::Server::HandlerResponse;
    server.set_pre_routing_handler([&](const httplib::Request& from, httplib::Response& to) {
        auto refusal = handlers.refuse(request_of(from));
        if (!refusal) return Handled::Unhandled;
        set_reply(to, std::move(*refusal));
        return Handled::Handled;
    });
    const auto answer = [&](const httplib::Request& from, httplib::Response& to) {
        set_reply(to, handlers.answer(request_of(from)));
    };
    server.Get(".*", answer), server.Post(".*", answer), server.Put(".*", answer);
    std::atomic<bool> ended = false;
    const std::jthread watcher([&] {
        constexpr std::chrono::milliseconds look{10};
        while (!ended && !stop.stop_requested()) std::this_thread::sleep_for(look);
        if (ended) return;
        at_stop();
        // The library ignores a stop before it runs, and none may come twice.
        while (!ended && !server.is_running()) std::this_thread::sleep_for(look);
        if (!ended) server.stop();
    });
    const bool closed_by_us = server.listen_after_bind();
    ended = true;
    if (!closed_by_us) throw Error("", "", "the server's socket was closed by the system");
}

} // namespace keiko::viewer
