#pragma once

#include "car_trims.h"
#include "fixture.h"

namespace keiko::fixtures {

/// Known facts of the concept car: counts, size, continuity, symmetry, quality of the trims.
std::vector<GroundTruth> car_truths(const Skin& body, const Skin& greenhouse, const CarTrims& trims,
                                    const std::vector<NamedFace>& faces);

} // namespace keiko::fixtures
