#pragma once

#include <functional>
#include <map>
#include <string>
#include <string_view>

namespace keiko::viewer {

/// A request of a browser. Names of headers are in lower case; of a header that stands twice, the
/// values follow each other with a comma between.
struct HttpRequest {
    std::string method, path;                   ///< "GET" and "/scene", without a query
    std::map<std::string, std::string> headers; ///< by name
    std::string body;                           ///< of a POST or PUT

    /// Value of a header, empty if it is missing.
    std::string header(const std::string& name) const {
        const auto found = headers.find(name);
        return found == headers.end() ? "" : found->second;
    }
    /// True if there is such a header.
    bool has(const std::string& name) const { return headers.count(name) > 0; }
};

/// The connection that a reply is written to, piece by piece.
class Outlet {
public:
    virtual ~Outlet() = default;
    /// Writes bytes; false once the client has gone.
    virtual bool write(std::string_view bytes) = 0;
    /// True while the client is there. Not to be called while bytes are written.
    virtual bool is_open() const = 0;
};

/// The answer to a request: a body, or a stream that writes one.
struct HttpReply {
    int status = 200;                      ///< of HTTP
    std::string type = "application/json"; ///< of the body
    std::string body{};                    ///< unused with a stream
    /// Writes the body; false cuts the answer off, so that the client does not take it for whole.
    std::function<bool(Outlet&)> stream{};
    bool ends_connection = false; ///< for requests whose body is not read
};

/// A reply of one line of text, {"error": reason}.
HttpReply error_reply(int status, std::string_view reason);

} // namespace keiko::viewer
