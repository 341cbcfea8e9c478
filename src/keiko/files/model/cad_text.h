#pragma once

#include "keiko/files/model/model_format.h"

#include <cstdint>
#include <string>
#include <string_view>
#include <unordered_map>

namespace keiko {

/// Refuses the text of a STEP, IGES or BREP file that holds a number beyond all doubles (1E999) or
/// a word for none (nan, inf), with which OpenCASCADE computes for ever or makes faces of nothing;
/// and of a STEP or IGES file one that is not written as the format has it (1.5e3 in STEP, 1.2.3),
/// which OpenCASCADE takes for another without a word. Other formats pass. Throws Error with
/// `source`, the line and, where the format has one, the entity.
void require_numbers(std::string_view text, ModelFormat format, const std::string& source);

/// Lines, from 1, on which the entity instances "#12 = ..." of a STEP file begin, by their number.
/// Texts and comments are passed over [ISO10303-21]; of a number given twice the first counts.
std::unordered_map<std::uint64_t, std::uint32_t> step_entity_lines(std::string_view text);

} // namespace keiko
