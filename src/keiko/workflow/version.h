#pragma once

#include <string>

namespace keiko {

/// "0.1.0"
std::string version();

} // namespace keiko
