#pragma once

#include "keiko/base/field_error.h"

#include <CLI/App.hpp>

#include <string>

namespace keiko::cli {

/// One line that describes the error to a user of `command`: the library's field is replaced by the
/// option that sets it ("--out: ..."), and stands as it is if the command has no such option.
std::string option_error_line(const FieldError& error, const CLI::App& command);

} // namespace keiko::cli
