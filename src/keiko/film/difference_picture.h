#pragma once

#include "keiko/film/film.h"

namespace keiko {

/// Display picture of how many tolerances two pictures are apart (1 channel): grey up to 1, from
/// yellow to red where it is beyond (100 and more), magenta where it is infinite.
Image difference_picture(const Image& excess);

} // namespace keiko
