#pragma once

#include "keiko/base/job.h"
#include "keiko/radiosity/element_subdivision.h"
#include "keiko/radiosity/radiosity_solution.h"
#include "keiko/scene/radiosity_spec.h"

#include <array>
#include <functional>
#include <span>
#include <vector>

namespace keiko {

/// Direct light, lx, of the front and the back of an element.
using DirectLightOf = std::function<std::array<Rgb, 2>(const ElementMesh&, std::uint32_t triangle)>;

/// Direct light, lx, of elements, of their fronts and backs. Elements are cut where they are longer
/// than `spec.element`, or than half of their distance from `near`. They are cut, too, where the
/// light of neighbours differs by more than `spec.contrast` of the brighter one, or of the mean of
/// all lit faces if that is brighter, down to `spec.smallest`. `light` is called from several
/// threads. Throws Cancelled, and FieldError for too many elements.
std::vector<std::array<Rgb, 2>> light_elements(ElementSubdivision& elements,
                                               const RadiositySpec& spec, const Box3& near,
                                               const DirectLightOf& light, const Job& job = {});

/// Reflected light of elements under direct light, by progressive refinement with a hemicube for
/// each that shoots. `reflectances`: a face of the model. Hashes are left empty. A stop of the job
/// ends it early with a solution whose `remaining` says so.
RadiositySolution solve_elements(const ElementMesh& elements,
                                 std::span<const std::array<Rgb, 2>> direct,
                                 std::span<const Rgb> reflectances, const RadiositySpec& spec,
                                 const Job& job = {});

} // namespace keiko
