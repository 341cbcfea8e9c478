#pragma once

#include "keiko/files/model/model_format.h"

#include <cstdint>
#include <string>
#include <string_view>
#include <unordered_map>

namespace keiko {

/// Refuses the text of a STEP, IGES or BREP file that holds a number beyond all doubles (1E999) or
/// a word for none (nan, inf). With these OpenCASCADE computes for ever or makes faces of nothing.
/// In a STEP or IGES file it also refuses a number that breaks the syntax of the format (1.5e3 in
/// STEP, 1.2.3). OpenCASCADE takes such a number for another without a message. Other formats pass.
/// Throws Error with `source`, the line and, where the format has one, the entity.
void require_numbers(std::string_view text, ModelFormat format, const std::string& source);

/// Lines, from 1, on which the entity instances "#12 = ..." of a STEP file begin, by their number.
/// Texts and comments are passed over [ISO10303-21]; of a number given twice the first counts.
std::unordered_map<std::uint64_t, std::uint32_t> step_entity_lines(std::string_view text);

} // namespace keiko
