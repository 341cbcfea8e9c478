#include "keiko/viewer/access.h"

#include "keiko/base/error.h"
#include "keiko/viewer/page.h"

#include <sys/random.h>

#include <array>
#include <charconv>

namespace keiko::viewer {
namespace {

/// True if both are equal; takes the same time wherever they differ.
bool equal_in_constant_time(const std::string& a, const std::string& b) {
    if (a.size() != b.size()) return false;
    unsigned difference = 0;
    for (std::size_t i = 0; i < a.size(); ++i)
        difference |= static_cast<unsigned char>(a[i]) ^ static_cast<unsigned char>(b[i]);
    return difference == 0;
}

bool is_own_host(const std::string& host, int port) {
    const std::string end = ":" + std::to_string(port);
    return host == "127.0.0.1" + end || host == "localhost" + end;
}

bool is_own_origin(const std::string& origin, int port) {
    constexpr std::string_view scheme = "http://";
    return origin.starts_with(scheme) && is_own_host(origin.substr(scheme.size()), port);
}

/// Bytes of the body that the head announces; nullopt unless it is a plain number.
std::optional<std::size_t> announced_length(const HttpRequest& head) {
    const std::string text = head.header("content-length");
    std::size_t length = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), length);
    if (text.empty() || error != std::errc() || end != text.data() + text.size()) return {};
    return length;
}

HttpReply refused(int status, std::string_view reason) {
    HttpReply reply = error_reply(status, reason);
    reply.ends_connection = true;
    return reply;
}

std::optional<HttpReply> body_refusal(const HttpRequest& head) {
    if (head.has("transfer-encoding"))
        return refused(411, "a body needs a length, and comes in one piece");
    if (head.has("content-encoding")) return refused(415, "a body may not be compressed");
    if (head.method == "GET" && !head.has("content-length")) return {};
    const auto length = announced_length(head);
    if (!length) return refused(411, "a body needs a length");
    if (*length > most_body)
        return refused(413, "a body may have " + std::to_string(most_body) + " bytes at most");
    return {};
}

} // namespace

std::optional<HttpReply> refusal(const HttpRequest& head, const Access& access) {
    if (!is_own_host(head.header("host"), access.port))
        return refused(403, "the host is not this server");
    if (head.has("origin") && !is_own_origin(head.header("origin"), access.port))
        return refused(403, "the request comes from a page of another server");
    if (head.method != "GET" && head.method != "POST" && head.method != "PUT")
        return refused(405, "the method must be GET, POST or PUT");
    const bool is_page = head.method == "GET" && page_file(head.path);
    if (!is_page && !equal_in_constant_time(head.header("x-keiko-token"), access.token))
        return refused(401, "the token is missing or not that of this server");
    return body_refusal(head);
}

std::string random_token() {
    std::array<unsigned char, 16> bytes{};
    if (getrandom(bytes.data(), bytes.size(), 0) != static_cast<ssize_t>(bytes.size()))
        throw Error("", "", "the system gives no random numbers");
    constexpr std::string_view digits = "0123456789abcdef";
    std::string token;
    for (const unsigned char byte : bytes) {
        token += digits[byte >> 4];
        token += digits[byte & 15];
    }
    return token;
}

} // namespace keiko::viewer
