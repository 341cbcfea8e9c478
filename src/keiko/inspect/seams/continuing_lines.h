#pragma once

#include "keiko/inspect/seams/seam_chain.h"

#include <cstdint>
#include <mutex>
#include <span>
#include <vector>

namespace keiko {

/// The lines of other faces that go on where a line ends, so that a feature line can be followed
/// over the borders of patches. Safe for several threads.
class ContinuingLines {
public:
    /// `chains`: the lines, by indices into `seams`. All must outlive it. `join` in mm.
    ContinuingLines(const BoundaryCurves& curves, std::span<const Seam> seams,
                    std::span<const std::vector<std::uint32_t>> chains, double join)
        : curves_(curves), seams_(seams), chains_(chains), join_(join) {}

    /// The pieces of the lines that go on at an end of a line, and at theirs: of 16 lines at most.
    std::vector<SeamProbe> beyond(std::uint32_t line) const;

private:
    using Ends = std::vector<std::array<SeamEnd, 2>>;

    const std::vector<Ends>& ends() const;
    bool go_on(std::uint32_t from, std::uint32_t into) const;

    const BoundaryCurves& curves_;
    std::span<const Seam> seams_;
    std::span<const std::vector<std::uint32_t>> chains_;
    double join_;
    mutable std::once_flag made_;
    mutable std::vector<Ends> ends_; ///< of the pieces of each line; few models ask for them
};

} // namespace keiko
