#pragma once

#include <cstdint>
#include <string_view>
#include <unordered_map>

namespace keiko {

/// Lines, from 1, on which the entity instances "#12 = ..." of a STEP file begin, by their number.
/// Texts and comments are passed over [ISO10303-21]; of a number given twice the first counts.
std::unordered_map<std::uint64_t, std::uint32_t> step_entity_lines(std::string_view text);

} // namespace keiko
