#pragma once

#include "keiko/math/bounds.h"
#include "keiko/math/interval_set.h"
#include "keiko/visibility/nets/scalar_net.h"

#include <vector>

namespace keiko {

/// A box of a patch in which one parameter of a function's zeros is a function of the other: along
/// the first it rises all over, or falls all over.
class ContourCell {
public:
    /// Cells of a function over [0, 1]^2 that hold all of its zeros. Where halving does not tell
    /// them apart, as at a crossing of zeros, a cell is 2^-14 wide and joins them by their order.
    static std::vector<ContourCell> all(ScalarNet function);

    /// Parts of the second parameter, 0 to 1 in the cell, over which there is a zero.
    std::vector<ParameterInterval> parts() const;
    /// Place of the patch where the function is zero, at a second parameter of such a part.
    Vec2 zero(double along) const;
    /// Derivatives of the function by u and v of the patch.
    Vec2 gradient(const Vec2& uv) const;

private:
    ContourCell(ScalarNet function, const Box2& box, bool swapped)
        : net_(std::move(function)), box_(box), swapped_(swapped) {}
    static void split(ScalarNet function, const Box2& box, int depth,
                      std::vector<ContourCell>& cells);

    ScalarNet net_; ///< rising or falling by its first parameter
    Box2 box_;
    bool swapped_; ///< its first parameter is v
};

} // namespace keiko
