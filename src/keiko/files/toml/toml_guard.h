#pragma once

#include <string>
#include <string_view>

namespace keiko {

/// Refuses texts that toml++ 3.3 does not survive, before it sees them: keys of very many parts,
/// down which it goes by recursion, and characters beyond ASCII where TOML has none or after a
/// backslash, for which it has no defined answer (marzer/tomlplusplus issues 190 and 295); with
/// them quotes, brackets and equals signs in the middle of a value, behind which the two would
/// differ in what a string is. Throws Error with file and line.
void require_parsable_toml(std::string_view text, const std::string& source);

} // namespace keiko
