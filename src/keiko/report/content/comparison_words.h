#pragma once

#include "keiko/compare/alignment/alignment.h"
#include "keiko/report/content/picture_outcome.h"

#include <string>

namespace keiko {

/// "0.012 mm", "< 1e-9 mm", or "further than 50 mm" for infinity.
std::string distance_words(double value, double reach);
/// "at most 0.012 mm", "< 1e-9 mm", or "further than 50 mm".
std::string at_most(double value, double reach);
/// Difference of the pictures of a view in words.
std::string picture_words(const PictureOutcome& picture);
/// "turned by 0.25 degrees about (0, 0, 1), its centre shifted by (3, -2, 1) mm; ..."
std::string alignment_words(const Alignment& alignment);

} // namespace keiko
