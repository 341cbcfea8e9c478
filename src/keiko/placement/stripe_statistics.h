#pragma once

#include "keiko/placement/lamp_field.h"
#include "keiko/placement/placement_score.h"

#include <span>

namespace keiko {

/// What the stripes of lamps are like in the pictures, over all places that mirror them. Spacings
/// are from stripe to stripe, px.
struct StripeStatistics {
    /// Below which a tenth, half and nine tenths of the weight lie; 0 where nothing is known.
    double narrow = 0, median = 0, wide = 0;
    double in_range = 0;   ///< share of the weight whose spacing is wanted, 0 to 1
    double uniformity = 0; ///< exp(-standard deviation of ln spacing), 1 for even stripes
};

/// Of lamps on these planes; a place that several planes reach counts for the first.
StripeStatistics stripe_statistics(std::span<const ViewSample> samples,
                                   std::span<const CPlane> planes, const StripeSpacing& wanted);

} // namespace keiko
