#pragma once

#include "keiko/viewer/http_message.h"

#include <cstddef>
#include <optional>
#include <string>

namespace keiko::viewer {

/// Most bytes of a request's body.
constexpr std::size_t most_body = 1 << 20;

/// Who may ask a server on this machine.
struct Access {
    int port = 0;      ///< that the server listens at, on the loopback interface
    std::string token; ///< known to the user's own pages alone
};

/// The refusal of a request by its head alone, before its body is read; nullopt if it is allowed.
/// The host and the origin, if there is one, must be the server itself: pages of others, and names
/// that lead here, are refused. All but the page's own files needs the token in X-Keiko-Token. A
/// body needs a length of most_body at most, and is neither chunked nor compressed.
std::optional<HttpReply> refusal(const HttpRequest& head, const Access& access);

/// 128 random bits of the system as 32 hexadecimal digits. Throws Error if it gives none.
std::string random_token();

} // namespace keiko::viewer
