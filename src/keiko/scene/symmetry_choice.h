#pragma once

#include "keiko/scene/criteria_preset.h"
#include "keiko/scene/mirror_plane.h"

#include <optional>
#include <string_view>

namespace keiko {

/// What is taken for the plane of symmetry of a body.
struct SymmetryChoice {
    enum class Kind {
        automatic, ///< a plane that is found
        off,       ///< none
        plane      ///< `plane`
    };
    Kind kind = Kind::off;
    MirrorPlane plane{};
    double distance = SymmetryLimit{}.distance; ///< mm from its image up to which it is symmetric

    /// "auto", "off" or a plane as MirrorPlane has it; throws Error for anything else.
    static SymmetryChoice parse(std::string_view text);
};

} // namespace keiko
