#pragma once

#include "keiko/report/picture_outcome.h"

#include <string>

namespace keiko {

/// "0.012 mm", "< 1e-9 mm", or "further than 50 mm" for infinity.
std::string distance_words(double value, double reach);
/// "at most 0.012 mm", "< 1e-9 mm", or "further than 50 mm".
std::string at_most(double value, double reach);
/// How the pictures of a view differ.
std::string picture_words(const PictureOutcome& picture);

} // namespace keiko
