#pragma once

#include "keiko/math/bounds.h"
#include "keiko/math/interval_set.h"
#include "keiko/visibility/nets/scalar_net.h"

#include <vector>

namespace keiko {

/// A box of a patch in which one parameter of a function's zeros is a function of the other: along
/// the first it rises all over, or falls all over. Not so where halving ended before.
class ContourCell {
public:
    /// Cells of a function over [0, 1]^2 that hold all of its zeros. Where 28 halvings, of both
    /// parameters together, do not tell them apart, as at a crossing of zeros, a cell joins them by
    /// their order.
    static std::vector<ContourCell> all(ScalarNet function);

    /// Parts of the second parameter, 0 to 1 in the cell, over which there is a zero.
    const std::vector<ParameterInterval>& parts() const { return parts_; }
    /// True if zeros enter and leave the cell in pairs, and are between the ends of each part in
    /// its middle. False only where halving ended before it was.
    bool is_sound() const { return is_sound_; }
    /// Place of the patch where the function is zero, at a second parameter of such a part.
    Vec2 zero(double along) const;
    /// Derivatives of the function by u and v of the patch.
    Vec2 gradient(const Vec2& uv) const;

private:
    ContourCell(ScalarNet function, const Box2& box, bool swapped);
    static void split(ScalarNet function, const Box2& box, int depth,
                      std::vector<ContourCell>& cells);
    /// Places of the second parameter where zeros enter or leave, rising.
    std::vector<double> ends() const;
    /// True if the function has opposite signs over a part's middle.
    bool has_zero_amid(const ParameterInterval& part) const;

    ScalarNet net_; ///< rising or falling by its first parameter
    Box2 box_;
    bool swapped_; ///< its first parameter is v
    std::vector<ParameterInterval> parts_;
    bool is_sound_ = true;
};

} // namespace keiko
