#pragma once

#include <string>
#include <string_view>

namespace keiko {

/// Base64 text of bytes [RFC4648], padded, in one line.
std::string base64(std::string_view bytes);

} // namespace keiko
