#pragma once

#include "keiko/io/model_format.h"

#include <string>
#include <string_view>

namespace keiko {

/// Refuses the text of a STEP, IGES or BREP file that holds a number beyond all doubles (1E999) or
/// a word for none (nan, inf), with which OpenCASCADE computes for ever or makes faces of nothing.
/// Other formats pass. Throws Error with `source`, the line and, where the format has one, the
/// entity.
void require_finite_numbers(std::string_view text, ModelFormat format, const std::string& source);

} // namespace keiko
