#pragma once

#include "keiko/base/export.h"
#include "keiko/inspect/seams/seam_measure.h"

#include <cstdint>
#include <span>
#include <vector>

namespace KEIKO_API keiko {

/// Seams of two revisions that run along each other: mostly one of each; several where one of them
/// divides what the other has in one.
struct SeamGroup {
    std::vector<std::uint32_t> before, after; ///< ascending, never empty
};

/// Which seams of two revisions belong together.
struct SeamMatching {
    std::vector<SeamGroup> groups;             ///< by the first of `before`
    std::vector<std::uint32_t> removed, added; ///< ascending: without a partner
};

/// Shorter than 0.01 mm: where a trim turns in a hook that another program may well leave out.
inline bool is_sliver(const MeasuredSeam& seam) {
    return seam.length < 0.01;
}

/// Pairs seams by where they run, each once. The first are those within a hundredth of `reach` (mm)
/// of each other all along, nearest first. Then come those whose faces have the same names, then
/// the nearest within `reach`. What is left over joins the pair that it runs along. Slivers are
/// left out.
SeamMatching match_seams(std::span<const MeasuredSeam> before, std::span<const MeasuredSeam> after,
                         double reach);

} // namespace keiko
