#pragma once

#include "keiko/api/check.h"

#include <CLI/App.hpp>

#include <optional>
#include <string>
#include <vector>

namespace keiko::cli {

/// The part of a body that a command judges.
class ScopeOptions {
public:
    /// Adds --faces, --layers, --colors and --zone to a command.
    void add_to(CLI::App& command);
    /// The scope; all of the body without the options. Throws Error for what is no colour.
    Scope scope() const;

private:
    std::vector<std::string> faces_, layers_, colors_, zones_;
};

/// Prints the sentences on the part of the body that was judged, and on its zones.
void print_scope(const std::optional<JudgedScope>& scope, const CriteriaPreset& preset);

} // namespace keiko::cli
