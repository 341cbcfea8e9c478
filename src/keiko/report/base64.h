#pragma once

#include <string>
#include <string_view>

namespace keiko {

/// RFC 4648 text of bytes, padded, in one line.
std::string base64(std::string_view bytes);

} // namespace keiko
