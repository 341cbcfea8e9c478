#pragma once

#include <string>
#include <string_view>

namespace keiko {

/// Words on what a file of this format of Keiko's own ("keiko-rig/1") is and what takes it: "a rig:
/// inspect, render and lines take it as their rig". Empty for any other text.
std::string use_of_format(std::string_view format);

} // namespace keiko
