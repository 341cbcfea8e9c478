#pragma once

#include "keiko/api/place.h"

#include <CLI/App.hpp>

#include <string>

namespace keiko::cli {

/// The plane about which a body, and the lamps over it, are symmetric.
class SymmetryOption {
public:
    /// Adds --symmetry to a command that places lamps.
    void add_to_placement(CLI::App& command);
    /// Adds --symmetry and --symmetry-limit to a command that judges a body; `also_places`: it
    /// places lamps too.
    void add_to(CLI::App& command, bool also_places);
    /// Symmetry of the lamps: automatic if not requested. Throws Error for an invalid plane.
    SymmetryChoice choice() const;
    /// Replaces the preset's symmetry: a plane is judged, "off" is not. Throws Error for an invalid
    /// plane, and for a limit without one.
    void apply_to(CriteriaPreset& preset) const;
    /// Makes a symmetry that is found deserve a look, if "auto" is requested and the preset judges
    /// no plane.
    void look_in(CriteriaPreset& preset) const;

private:
    std::string plane_;
    double limit_ = 0; ///< mm; 0: the preset's own, or that of SymmetryLimit
};

} // namespace keiko::cli
