#pragma once

#include "keiko/inspect/joints/joint_run.h"

#include <vector>

namespace keiko {

/// Runs that continue each other, from end to end.
struct JointChain {
    std::size_t body = 0, other = 0;    ///< as JointRun
    std::vector<JointStation> stations; ///< in order
    bool closed = false;                ///< it ends at its beginning
};

/// Chains of all runs, each in one. Runs of the same two bodies continue each other where their
/// ends are within `join` mm, their directions turn no corner, and both have the same outside.
std::vector<JointChain> chained(std::vector<JointRun> runs, double join);

} // namespace keiko
