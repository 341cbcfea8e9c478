#pragma once

#include "keiko/base/export.h"
#include "keiko/radiosity/radiosity_solution.h"

#include <string>
#include <string_view>

namespace KEIKO_API keiko {

/// Text of a solution, keiko-solution/1: lines of words and numbers, which read back as the same
/// bits (docs/file-formats.md#solutions-keiko-solution1).
std::string solution_text(const RadiositySolution& solution);

/// Solution of such a text. Throws Error naming `source` and the line for anything else: another
/// format, a number that is missing, not finite or out of range, a corner that is not there.
RadiositySolution parse_solution(std::string_view text, const std::string& source);

} // namespace keiko
