#pragma once

#include <string>

namespace keiko {

/// Version of the loaded oneTBB: "2021.8".
std::string tbb_version();

} // namespace keiko
