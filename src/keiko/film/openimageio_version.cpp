#include "keiko/film/openimageio_version.h"

#include <OpenImageIO/imageio.h>

namespace keiko {

std::string openimageio_version() {
    const int number = OIIO::openimageio_version(); // 20407 is 2.4.7
    return std::to_string(number / 10000) + "." + std::to_string(number / 100 % 100) + "." +
           std::to_string(number % 100);
}

} // namespace keiko
