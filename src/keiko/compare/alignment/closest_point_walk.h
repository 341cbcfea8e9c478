#pragma once

#include "keiko/compare/alignment/closest_point_query.h"

#include <optional>

namespace keiko {

/// Closest points of places that follow each other closely: each search begins where the last one
/// ended. From one place to the next a distance grows by no more than the way, which bounds the
/// search. Refers to the query.
class ClosestPointWalk {
public:
    /// `reach`: mm, beyond which nothing is found.
    ClosestPointWalk(const ClosestPointQuery& query, double reach) : query_(query), reach_(reach) {}

    /// The closest point of the next place; nullopt if the body is `reach` mm away or farther.
    std::optional<ClosestSurfacePoint> next(const Vec3& place) {
        foot_ = foot_of(place);
        last_ = place;
        return foot_;
    }

private:
    std::optional<ClosestSurfacePoint> foot_of(const Vec3& place) const {
        if (!foot_) return query_.foot(place, reach_);
        constexpr double rounding = 1e-6; // mm
        const double bound = foot_->distance + (place - last_).length() + rounding;
        if (bound < reach_)
            if (auto foot = query_.foot_from(*foot_, place, bound)) return foot;
        return query_.foot(place, reach_); // borders, whose distance is not proved, may be missed
    }

    const ClosestPointQuery& query_;
    double reach_;
    Vec3 last_{0};
    std::optional<ClosestSurfacePoint> foot_; ///< of the last place
};

} // namespace keiko
