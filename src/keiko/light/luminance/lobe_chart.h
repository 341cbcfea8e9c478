#pragma once

#include "keiko/math/vec.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace keiko {

/// A chart of directions of light in which a lobe is a round bell about 0, 1 its spread: for lobes
/// of half vectors the slope of the half vector, tan alpha. Seen at a grazing angle such a lobe is
/// narrow across the plane of incidence and towards the horizon, which angles to its peak do not
/// tell.
class LobeChart {
public:
    /// Of a lobe about a unit direction; `spread` in radians, small.
    LobeChart(const Vec3& peak, double spread) : peak_(peak), scale_(1 / spread) {}
    /// Of half vectors about the unit `normal`, `spread` twice theirs; `eye` and they inside of a
    /// border of index `n` >= 1.
    LobeChart(const Vec3& peak, double spread, const Vec3& normal, const Vec3& eye, double n = 1)
        : peak_(peak), scale_(2 / spread), facets_(Facets{normal, eye, n}) {}

    const Vec3& peak() const { return peak_; }

    struct Place {
        Vec3 off;  ///< from the peak
        Vec3 rate; ///< of its change as the direction turns
    };
    /// Of a unit direction that turns by `turn` a radian.
    Place at(const Vec3& light, const Vec3& turn) const {
        if (!facets_) return {(light - peak_) * scale_, turn * scale_};
        return facets_->at(light, turn, scale_);
    }

private:
    struct Facets {
        Vec3 normal, eye;
        double n;

        Place at(const Vec3& light, const Vec3& turn, double scale) const {
            constexpr double least_height = 1e-3;
            const Vec3 flat = (light - normal * light.dot(normal)) / n;
            const Vec3 flat_turn = (turn - normal * turn.dot(normal)) / n;
            const double inner = std::sqrt(std::max(least_height, 1 - flat.length2()));
            const double height = std::max(least_height, inner + eye.dot(normal));
            const double rise = -flat.dot(flat_turn) / inner;
            const Vec3 slope = (flat + eye - normal * eye.dot(normal)) / height;
            return {slope * scale, (flat_turn - slope * rise) * (scale / height)};
        }
    };

    Vec3 peak_;
    double scale_;
    std::optional<Facets> facets_; ///< nothing: about the peak itself
};

} // namespace keiko
