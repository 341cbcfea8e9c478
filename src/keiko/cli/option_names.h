#pragma once

#include "keiko/base/error.h"

#include <CLI/App.hpp>

#include <string>

namespace keiko::cli {

/// One line that describes the error to a user of `command`. The option that sets the field
/// replaces the field's name ("--out: ..."), if the command has such an option.
std::string option_error_line(const FieldError& error, const CLI::App& command);

} // namespace keiko::cli
