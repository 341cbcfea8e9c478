#pragma once

#include "keiko/compare/alignment/closest_point_query.h"

#include <limits>
#include <optional>

namespace keiko {

/// Closest points of places that follow each other closely: from one to the next a distance grows
/// by no more than the way, which bounds the search. Refers to the query.
class ClosestPointWalk {
public:
    /// `reach`: mm, beyond which nothing is found.
    ClosestPointWalk(const ClosestPointQuery& query, double reach) : query_(query), reach_(reach) {}

    /// The closest point of the next place; nullopt if the body is `reach` mm away or farther.
    std::optional<ClosestSurfacePoint> next(const Vec3& place) {
        const auto foot = foot_of(place);
        last_ = place;
        last_distance_ = foot ? foot->distance : std::numeric_limits<double>::infinity();
        return foot;
    }

private:
    std::optional<ClosestSurfacePoint> foot_of(const Vec3& place) const {
        constexpr double rounding = 1e-6; // mm
        const double bound = last_distance_ + (place - last_).length() + rounding;
        if (bound < reach_)
            if (auto foot = query_.foot(place, bound)) return foot;
        return query_.foot(place, reach_);
    }

    const ClosestPointQuery& query_;
    double reach_;
    Vec3 last_{0};
    double last_distance_ = std::numeric_limits<double>::infinity(); ///< mm
};

} // namespace keiko
