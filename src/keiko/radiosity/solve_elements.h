#pragma once

#include "keiko/base/job.h"
#include "keiko/geometry/model/surface_model.h"
#include "keiko/intersect/traversal/tracer.h"
#include "keiko/radiosity/element_division.h"
#include "keiko/radiosity/element_mesh.h"
#include "keiko/radiosity/radiosity_solution.h"
#include "keiko/scene/radiosity_spec.h"

#include <span>

namespace keiko {

/// A scene whose surfaces reflect light onto each other; keeps references to everything.
struct ReflectingScene {
    const SurfaceModel& model;         ///< visible
    const Tracer& tracer;              ///< of what reflects and hides light
    std::span<const Rgb> reflectances; ///< a face of the model, below 1
};

/// Reflected light of elements under direct light, lamp by lamp, by form factors of `spec.rays`
/// rays each; then that at the corners of all triangles. `levels`: of the lamps, for the balance.
/// Hashes are left empty. A stop of the job ends it early with a solution whose `remaining` says
/// so.
RadiositySolution solve_elements(const ReflectingScene& scene, const ElementMesh& mesh,
                                 const DirectLights& direct, std::span<const Rgb> levels,
                                 const RadiositySpec& spec, const Job& job = {});

/// Triangles of a mesh as a solution has them.
std::vector<SolvedTriangle> solved_triangles(const ElementMesh& mesh);

} // namespace keiko
