#pragma once

#include "keiko/keiko.h"

#include <CLI/App.hpp>

#include <string>

namespace keiko::cli {

/// What a body's own mirror image is asked of.
class SymmetryOption {
public:
    /// Adds --symmetry and --symmetry-limit to a command.
    void add_to(CLI::App& command);
    /// In place of what the preset has. Throws Error for what is no plane, and for a limit without
    /// one.
    void apply_to(CriteriaPreset& preset) const;

private:
    std::string plane_;
    double limit_ = 0; ///< mm; 0: the preset's own, or that of SymmetryLimit
};

} // namespace keiko::cli
