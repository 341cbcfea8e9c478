#pragma once

#include "keiko/api/place.h"

#include <CLI/App.hpp>

#include <string>

namespace keiko::cli {

/// The plane that a body, and the lamps over it, are symmetric about.
class SymmetryOption {
public:
    /// Adds --symmetry to a command that places lamps.
    void add_to_placement(CLI::App& command);
    /// Adds --symmetry and --symmetry-limit to one that judges a body; `also_places`: lamps too.
    void add_to(CLI::App& command, bool also_places);
    /// What lamps are symmetric about: automatic where nothing is asked for. Throws Error for what
    /// is no plane.
    SymmetryChoice choice() const;
    /// In place of what the preset has: a plane is judged, off is not. Throws Error for what is no
    /// plane, and for a limit without one.
    void apply_to(CriteriaPreset& preset) const;
    /// What is found is worth a look, where "auto" is asked for and the preset judges no plane.
    void look_in(CriteriaPreset& preset) const;

private:
    std::string plane_;
    double limit_ = 0; ///< mm; 0: the preset's own, or that of SymmetryLimit
};

} // namespace keiko::cli
