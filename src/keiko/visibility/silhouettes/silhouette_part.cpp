#include "keiko/visibility/silhouettes/silhouette_part.h"

#include <algorithm>

namespace keiko {

SilhouettePart::SilhouettePart(const Box2& uv, HomogeneousNet points, DegreeReducedScalar edge_on,
                               const Vec2& shares)
    : uv_(uv),
      points_(std::move(points)),
      bounds_(affine_bounds(points_)),
      edge_on_(std::move(edge_on)),
      shares_(shares),
      slopes_(slopes_of(edge_on_.net)) {
    slopes_.add_error(edge_on_.error, shares);
}

bool SilhouettePart::may_be_in(const ViewVolume& volume, ViewVolume::Sides sides,
                               const NetFrame& frame, int most_halvings) {
    if (!volume.may_hold(bounds_, frame, sides)) return false;
    if (most_halvings == 0) return true;
    std::vector<SilhouettePart>& parts = halves();
    return std::any_of(parts.begin(), parts.end(), [&](SilhouettePart& half) {
        return half.may_be_in(volume, sides, frame, most_halvings - 1);
    });
}

std::vector<SilhouettePart>& SilhouettePart::halves() {
    if (halves_) return *halves_;
    halves_.emplace();
    halves_->reserve(2);
    const unsigned axis = slopes_.axis_to_halve(shares_);
    std::array<ScalarNet, 2> nets = halved(edge_on_.net, axis);
    std::array<HomogeneousNet, 2> points = halved(points_, axis);
    Vec2 shares = shares_;
    shares[axis] /= 2;
    Box2 low = uv_, high = uv_;
    low.upper[axis] = high.lower[axis] = uv_.center()[axis];
    const std::array boxes{low, high};
    for (std::size_t k = 0; k < 2; ++k)
        if (may_vanish(nets[k], edge_on_.error))
            halves_->emplace_back(boxes[k], std::move(points[k]),
                                  DegreeReducedScalar{std::move(nets[k]), edge_on_.error}, shares);
    return *halves_;
}

} // namespace keiko
