#pragma once

#include "keiko/inspect/inspection.h"
#include "keiko/triage/fault_group.h"
#include "keiko/triage/fault_units.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace keiko {

/// A face that is to be rebuilt rather than its seams one by one.
struct BadPatch {
    std::uint32_t face = no_index;   ///< into Inspection::faces
    std::vector<std::size_t> groups; ///< its faults, at least two, rising
};

/// The bad patches of a body: faces with several faults that lie on their seams alone, and that
/// hold most of the length of these. A fault lies on a face alone if `spread_share` of its weight
/// in its best view does, or of half of it for a fault on both sides of the body. Each fault
/// belongs to one patch at most; the patch whose faults weigh most takes them first. `may_belong`:
/// which groups count.
std::vector<BadPatch> bad_patches(const Inspection& inspection, std::span<const FaultUnit> units,
                                  std::span<const FaultGroup> groups,
                                  const std::vector<bool>& may_belong);

} // namespace keiko
