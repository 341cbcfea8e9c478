#pragma once

#include "keiko/files/model/model_format.h"

#include <string>
#include <string_view>

namespace keiko {

/// Refuses the text of a STEP, IGES or BREP file that holds a number beyond all doubles (1E999) or
/// a word for none (nan, inf), with which OpenCASCADE computes for ever or makes faces of nothing;
/// and of a STEP or IGES file one that is not written as the format has it (1.5e3 in STEP, 1.2.3),
/// which OpenCASCADE takes for another without a word. Other formats pass. Throws Error with
/// `source`, the line and, where the format has one, the entity.
void require_numbers(std::string_view text, ModelFormat format, const std::string& source);

} // namespace keiko
