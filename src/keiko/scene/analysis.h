#pragma once

#include "keiko/base/export.h"
#include "keiko/light/rig/light_rig.h"
#include "keiko/scene/camera.h"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace KEIKO_API keiko {

/// A view of an analysis, and what it shows.
struct AnalysisView {
    std::string name;           ///< 1 to 64 letters, digits, hyphens and underscores
    Camera camera;              ///< with the size of the picture
    std::string look = "lamps"; ///< "lamps", "faces", or a mode as name_of has it; "=C" may follow
    /// Normal of the planes of the look "curvature:section", finite and not 0; none: along y.
    std::optional<Vec3> across{};
};

/// A face that is left out of pictures.
struct HiddenFace {
    std::uint32_t face = 0;      ///< Face::id in the body of the analysis
    std::string name;            ///< Face::name, or empty
    std::optional<Vec3> place{}; ///< mm, on the face, away from its borders
};

/// A remark of a user on a place of the part.
struct AnalysisNote {
    std::string text;       ///< 1 to 1000 bytes
    Vec3 place{0};          ///< mm
    std::uint32_t face = 0; ///< Face::id at the place; 0: none
};

/// Views, lamps and notes of a user on a body, which are repeated on its next revision.
struct Analysis {
    std::string file;                  ///< that it was read from; empty: none
    std::vector<AnalysisView> views;   ///< the first is shown first; names differ
    std::vector<std::string> sections; ///< planes, "y=120", each once
    std::optional<LightRig> rig{};     ///< none: chosen as without an analysis
    std::vector<HiddenFace> hidden;    ///< in any order
    std::vector<AnalysisNote> notes;   ///< in the order of the user
};

} // namespace keiko
