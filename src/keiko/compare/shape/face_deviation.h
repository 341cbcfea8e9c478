#pragma once

#include "keiko/compare/shape/deviation.h"
#include "keiko/compare/shape/deviation_sample.h"

#include <span>

namespace keiko {

/// How each of so many faces lies to the other body, by its samples. In what direction the other
/// lies is not asked nearer than `noise` mm.
std::vector<FaceDeviation> face_deviations(std::span<const DeviationSample> samples,
                                           std::size_t faces, double noise);

} // namespace keiko
