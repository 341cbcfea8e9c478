#pragma once

#include "keiko/math/vec.h"

#include <string>
#include <string_view>

namespace keiko {

/// Text escaped for an HTML element or a quoted attribute. Control characters, which HTML forbids,
/// become spaces, and bytes that are not UTF-8 become U+FFFD.
std::string html_escaped(std::string_view text);

/// A number with this many decimals, e.g. fixed_number(0.0125, 3) = "0.013" (or "0.012"). A size
/// below half the last decimal but not 0 becomes "< 0.001". A number that is not finite becomes a
/// dash.
std::string fixed_number(double value, int decimals);

/// A bar that is full at a share of 1, empty at 0 or without a number.
std::string html_bar(double share);

/// A number with this many significant digits, in the shorter of the usual notations.
std::string short_number(double value, int digits = 3);

/// "12.3, -45.6, 789.0", mm.
std::string place_text(const Vec3& place);

/// Base64 text of bytes [RFC4648], padded, in one line.
std::string base64(std::string_view bytes);

} // namespace keiko
