#pragma once

#include "keiko/visibility/nets/scalar_net.h"

#include <functional>
#include <optional>

namespace keiko {

/// The search for common zeros of two functions on a piece where one look proves nothing: the
/// piece is split until on each part the functions are proved to have at most one, or none.
class SilhouetteSearch {
public:
    /// f and g over the searched box, [0, 1]^2 of its own parameters; `error`: bound of what g may
    /// be off by.
    SilhouetteSearch(ScalarNet f, ScalarNet g, double error = 0)
        : f_(std::move(f)), g_(std::move(g)), error_(error) {}

    /// Newton's method for the exact functions from a place in a box of this extent; nothing when
    /// it fails.
    using Solve = std::function<std::optional<Vec2>(const Vec2& start, const Vec2& extent)>;
    /// How far an event can be moved along the segment, in its parameter, by moving within a box.
    using Spread = std::function<double(const Box2&)>;
    struct Result {
        std::vector<Vec2> roots;
        std::vector<Vec2> unclear; ///< boxes' middles where an event cannot be told from several
        bool certain = true;       ///< false when unclear boxes are wide
    };
    Result run(const Solve& solve, const Spread& spread, int most_boxes) const;

private:
    ScalarNet f_, g_;
    double error_;
};

} // namespace keiko
