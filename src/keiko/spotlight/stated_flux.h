#pragma once

#include "keiko/base/diagnostics.h"
#include "keiko/spotlight/photometric_web.h"

#include <string>

namespace keiko {

/// Warnings for what the header of a luminaire file states of the flux and the intensities of its
/// table contradict by more than 1 % of the luminaire's flux: a light output ratio, a share of
/// downward flux, or lamps with less flux than the luminaire. Each names the file and both numbers.
Diagnostics flux_contradictions(const std::string& file, const PhotometricWeb& web);

} // namespace keiko
