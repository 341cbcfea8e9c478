#pragma once

#include "keiko/geometry/model/surface_model.h"
#include "keiko/import/cad/cad_document.h"
#include "keiko/math/vec.h"

#include <cstddef>
#include <string>
#include <vector>

namespace keiko::cad {

/// A place where our trims and OpenCASCADE's classifier give different answers.
struct TrimDisagreement {
    std::string face;                  ///< as SurfaceModel::describe says
    Vec2 at{0};                        ///< face parameters
    bool ours = false;                 ///< whether we take it for material
    bool valid_face = true;            ///< by OpenCASCADE's own check
    bool curves_agree_with_us = false; ///< by the crossings of the file's own p-curves
    double border_distance = 0;        ///< mm, of the nearest trim curve
};

/// Random places on all faces of a model, each judged twice.
struct TrimTally {
    std::size_t samples = 0;
    std::size_t at_border = 0; ///< within the tolerance of an edge: either answer is right
    std::size_t undecided = 0; ///< "on" or "unknown", says OpenCASCADE
    std::vector<TrimDisagreement> disagreements;
};

/// Compares a model with the document it was converted from at about `samples` seeded places,
/// evenly over its trimmed faces and over the box of each face's loops.
TrimTally compare_trims(const CadDocument& document, const SurfaceModel& model,
                        std::size_t samples);

} // namespace keiko::cad
