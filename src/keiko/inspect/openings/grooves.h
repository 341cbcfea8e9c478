#pragma once

#include "keiko/inspect/openings/opening.h"
#include "keiko/inspect/seams/model_borders.h"
#include "keiko/inspect/seams/seam_measure.h"
#include "keiko/scene/criteria_preset.h"

#include <array>
#include <span>
#include <vector>

namespace keiko {

/// A gap or a kink between two faces that bend into flanges or walls.
struct Groove {
    std::array<PlacedFace, 2> sides{}; ///< the faces that would continue each other
    double width = 0;                  ///< mm across, from crease to crease
    double turn = 0;                   ///< degrees, by which one face turns from the other
    double length = 0;                 ///< mm, on the creases of the first face
    Vec3 place{0};                     ///< world, mm: the middle between the creases
};

/// The grooves of a model, one for each pair of placed faces, at its widest. Their creases run side
/// by side within `limits.join` mm, for longer than `limits.from` mm altogether. They are more than
/// `limits.gap` apart. Else the faces turn by more than `preset.angle` and at most
/// `preset.feature_angle` degrees. No material closes the gap, and the two faces have no seam with
/// each other there. `pieces`: MeasuredSeams::pieces.
std::vector<Groove> grooves(const ModelBorders& borders, std::span<const MeasuredSeam> seams,
                            std::span<const Seam> pieces, const OpeningLimits& limits,
                            const CriteriaPreset& preset);

} // namespace keiko
