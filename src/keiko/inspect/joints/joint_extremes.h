#pragma once

#include "keiko/inspect/joints/joint_run.h"

#include <optional>
#include <span>

namespace keiko {

/// The most extreme sections of stations in order, sought between them too by golden-section
/// search. `other`: the body of the second panel. nullopt if no station has a section. What is
/// hidden is estimated from the second differences of the stations.
std::optional<JointExtremes> joint_extremes(const JointRuns& runs,
                                            std::span<const JointStation> stations,
                                            std::size_t other);

} // namespace keiko
