#pragma once

#include <string>

namespace keiko {

/// Version of the loaded OpenImageIO: "2.4.7".
std::string openimageio_version();

} // namespace keiko
