#pragma once

#include "keiko/api/render.h"

#include <CLI/CLI.hpp>

#include <optional>
#include <string>

namespace keiko::cli {

// Values of options that several commands have.

/// The direction of a text "X,Y,Z", unit. Throws Error naming `option` for another text and for 0.
Vec3 direction(const std::string& option, const std::string& text);

/// The range of a text "MIN:MAX"; nullopt unless both are numbers, MIN below MAX.
std::optional<ValueRange> value_range(const std::string& text);

/// Adds --mesher to a command, the name of a Mesher. `name` is its default.
void add_mesher(CLI::App& command, std::string& name);

} // namespace keiko::cli
