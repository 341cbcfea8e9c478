#pragma once

#include "keiko/base/job.h"
#include "keiko/math/bounds.h"
#include "keiko/patch/seam.h"

#include <array>
#include <map>
#include <span>
#include <string>
#include <vector>

namespace keiko {

/// What is in a model file.
struct ModelFacts {
    std::string source, format;
    std::string unit; ///< of the file; empty: it names none and is read as mm
    std::size_t parts = 0, instances = 0, faces = 0, placed_faces = 0;
    std::size_t patches = 0, trimmed_faces = 0;
    std::size_t rational_patches = 0;
    std::size_t approximated_faces = 0;
    double largest_approximation = 0;                  ///< mm
    std::map<std::string, std::size_t> kinds;          ///< faces of each surface kind
    std::map<std::array<int, 2>, std::size_t> degrees; ///< patches of each degree u x v
    Box3 bounds;                                       ///< world, mm, of the control points
    std::size_t seams = 0;
    double border_length = 0; ///< mm, of all borders of all placed faces
    double free_length = 0;   ///< mm, of borders that meet no other
    std::vector<LostFace> lost_faces;
    Diagnostics diagnostics; ///< healing among them
};

/// `seams`: those of pair_seams.
ModelFacts model_facts(const SurfaceModel& model, std::span<const Seam> seams, const Job& job = {});

} // namespace keiko
