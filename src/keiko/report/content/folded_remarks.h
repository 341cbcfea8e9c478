#pragma once

#include "keiko/base/error.h"

#include <string>
#include <string_view>
#include <vector>

namespace keiko {

/// One remark, or several equal ones, for people.
struct FoldedRemark {
    Severity severity = Severity::note;
    std::string text; ///< "face 12: invalid in the file (226 times)"
};

/// Remarks in which equal ones are one with their number, in the order of first occurrence.
std::vector<FoldedRemark> folded_remarks(const Diagnostics& remarks);

/// "note", "warning" or "error".
std::string_view name_of(Severity severity);

} // namespace keiko
