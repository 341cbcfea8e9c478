#pragma once

#include "keiko/inspect/check.h"

#include <string>
#include <string_view>

namespace keiko {

/// Wording of a measure in messages.
struct Wording {
    const char* what; ///< "the gap"
    const char* unit; ///< " mm"
    double scale = 1; ///< what is printed is the value times this
};

/// A number of a message, to three digits.
std::string short_number(double value);

/// A check with the names of its criterion; throws std::out_of_range for an unknown code.
Check named_check(std::string_view code);

/// A judged check, with a sentence that holds the value against its limit.
Check judged_check(std::string_view code, const std::string& unit, const MeasuredValue& worst,
                   const Wording& wording);

/// A check that is not judged, with the reason in its message.
Check unjudged_check(std::string_view code, const std::string& reason);

} // namespace keiko
