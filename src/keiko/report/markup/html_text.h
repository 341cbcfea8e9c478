#pragma once

#include "keiko/math/vec.h"

#include <string>
#include <string_view>

namespace keiko {

/// Text as it may stand in an HTML element or a quoted attribute; control characters, which HTML
/// forbids, become spaces, and bytes that are no UTF-8 become U+FFFD.
std::string html_escaped(std::string_view text);

/// A number with so many decimals, e.g. fixed_number(0.0125, 3) = "0.013" (or "0.012"); what is
/// below half the last decimal but not 0 is told as "< 0.001"; no number as a dash.
std::string fixed_number(double value, int decimals);

/// A bar that is full at a share of 1, empty at 0 or where there is no number.
std::string html_bar(double share);

/// A number with so many significant digits, in the shorter of the usual notations.
std::string short_number(double value, int digits = 3);

/// "12.3, -45.6, 789.0", mm.
std::string place_text(const Vec3& place);

} // namespace keiko
