#pragma once

#include "keiko/base/export.h"
#include "keiko/math/vec.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace KEIKO_API keiko {

/// Axis-parallel box of `V` (Vec2 or Vec3); a default box is empty and contains nothing.
template <class V>
struct Bounds {
    /// Corner of the empty box.
    static constexpr double infinity = std::numeric_limits<double>::infinity();

    V lower{infinity};  ///< corner of the least coordinates
    V upper{-infinity}; ///< corner of the largest coordinates

    /// True if no point lies in it.
    bool empty() const {
        for (unsigned i = 0; i < V::dimensions(); ++i)
            if (!(lower[i] <= upper[i])) return true;
        return false;
    }
    /// Middle of the box.
    V center() const { return (lower + upper) * 0.5; }
    /// Lengths of its edges.
    V extent() const { return upper - lower; }
    /// Length of the diagonal, 0 when empty: the size of a thing in the sense of tolerances.
    double size() const { return empty() ? 0 : extent().length(); }

    /// True if a point lies in the box or on it.
    bool contains(const V& p) const {
        for (unsigned i = 0; i < V::dimensions(); ++i)
            if (!(lower[i] <= p[i] && p[i] <= upper[i])) return false;
        return true;
    }
    /// True if two boxes have a point in common.
    bool overlaps(const Bounds& other) const {
        for (unsigned i = 0; i < V::dimensions(); ++i)
            if (!(lower[i] <= other.upper[i] && other.lower[i] <= upper[i])) return false;
        return true;
    }
    /// The point of the box nearest to `p`; requires a box that is not empty.
    V nearest(const V& p) const {
        V result = p;
        for (unsigned i = 0; i < V::dimensions(); ++i)
            result[i] = std::clamp(p[i], lower[i], upper[i]);
        return result;
    }
    /// The common part of two boxes.
    Bounds intersection(const Bounds& other) const {
        Bounds both;
        for (unsigned i = 0; i < V::dimensions(); ++i) {
            both.lower[i] = std::max(lower[i], other.lower[i]);
            both.upper[i] = std::min(upper[i], other.upper[i]);
        }
        return both;
    }
    /// Enlarges the box to hold a point.
    void extend(const V& p) {
        for (unsigned i = 0; i < V::dimensions(); ++i) {
            lower[i] = std::min(lower[i], p[i]);
            upper[i] = std::max(upper[i], p[i]);
        }
    }
    /// Enlarges the box to hold another.
    void extend(const Bounds& other) {
        if (other.empty()) return;
        extend(other.lower);
        extend(other.upper);
    }
    /// The box with a margin on all sides.
    Bounds padded(double margin) const { return {lower - V(margin), upper + V(margin)}; }

    bool operator==(const Bounds&) const = default;
};

using Box2 = Bounds<Vec2>; ///< Box in a plane.
using Box3 = Bounds<Vec3>; ///< Box in space.

/// The parameters of a patch.
inline const Box2 unit_square{Vec2(0), Vec2(1)};

/// Nearest float not above / not below `x`: boxes handed to single precision only ever grow.
inline float round_down(double x) {
    const auto f = static_cast<float>(x);
    return static_cast<double>(f) > x ? std::nextafter(f, -std::numeric_limits<float>::infinity())
                                      : f;
}
/// Nearest float not below `x`.
inline float round_up(double x) {
    const auto f = static_cast<float>(x);
    return static_cast<double>(f) < x ? std::nextafter(f, std::numeric_limits<float>::infinity())
                                      : f;
}

} // namespace keiko
