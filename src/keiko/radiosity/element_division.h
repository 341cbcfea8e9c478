#pragma once

#include "keiko/base/job.h"
#include "keiko/math/rgb.h"
#include "keiko/radiosity/element_subdivision.h"
#include "keiko/radiosity/elements.h"
#include "keiko/radiosity/radiosity_solution.h"
#include "keiko/scene/radiosity_spec.h"

#include <cstddef>
#include <functional>
#include <span>
#include <vector>

namespace keiko {

/// Direct light, lx, at a point from each lamp at the level 1.
using DirectLightOf = std::function<std::vector<Rgb>(const LightPoint&)>;

/// Direct light of the faces of elements.
struct DirectLights {
    /// lx of each lamp at the level 1: of all fronts, then of all backs.
    std::vector<std::vector<Rgb>> by_lamp;
};

/// Most elements that a scene may have.
constexpr std::size_t most_elements = 10000;

/// Makes elements of triangles and lights them. An element may be `spec.element` large, or half as
/// large as its distance from `near`; longer triangles are cut. Neighbours on a
/// face are then joined to elements, so long as their normals are within 45 degrees of the mean or
/// they are smaller than `spec.smallest`. Elements are halved where the light of neighbours differs
/// by more than `spec.contrast` of the brighter one, or of the mean of all lit faces if that is
/// brighter. That ends at `spec.smallest` and at `most_elements`. `levels`: of the lamps. `light`
/// is called from several threads. Throws Cancelled, and FieldError for too many elements before
/// that.
DirectLights divide_and_light(ElementSubdivision& triangles, const SurfaceModel& model,
                              const RadiositySpec& spec, const Box3& near,
                              std::span<const Rgb> levels, const DirectLightOf& light,
                              const Job& job = {});

} // namespace keiko
