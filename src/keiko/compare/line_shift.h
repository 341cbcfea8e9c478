#pragma once

#include "keiko/base/export.h"
#include "keiko/inspect/lines/joined_lines.h"

#include <vector>

namespace KEIKO_API keiko {

/// How a lamp's line lies in one revision of a part to the lines of the same lamp in the other.
struct LineShift {
    /// Indices of the line's C-plane and of the lamp on it.
    std::uint32_t plane = 0, lamp = 0;
    double length = 0;            ///< mm, of the line
    double alone = 0;             ///< mm of it that have no line of the lamp beside them
    double mean = 0, largest = 0; ///< mm on the part, of the rest
    Vec3 place{0};                ///< on the line, where that is largest; world, mm
};

/// Options of line_shifts.
struct LineShiftOptions {
    double reach = 50;   ///< mm: lines farther apart are not the same line
    double noise = 0.02; ///< mm: about twice the error of the chords
    double step = 2;     ///< mm between the places that are asked
};

/// Every line of `lines`, in order, held against the lines of the same lamps in `others`: the
/// distance of its places to the nearest chord there. Where the nearest is the end of a line
/// ahead or behind, not beside, the place is alone. The same for any thread count. Throws
/// Cancelled.
std::vector<LineShift> line_shifts(const JoinedLines& lines, const JoinedLines& others,
                                   const LineShiftOptions& options = {}, const Job& job = {});

} // namespace keiko
