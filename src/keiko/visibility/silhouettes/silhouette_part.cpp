#include "keiko/visibility/silhouettes/silhouette_part.h"

#include "keiko/visibility/nets/affine_bounds.h"

#include <algorithm>
#include <cmath>
#include <limits>

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

SilhouetteSearch::Result SilhouetteSearch::run(const Solve& solve, const Spread& spread,
                                               int most_boxes) const {
    constexpr double sharpest = 1e-11; ///< of the segment: closer events are one
    Result result;
    struct Open {
        Box2 box;
        ScalarNet f, g;
    };
    std::vector<Open> open{{unit_square, f_, g_}};
    for (int count = 0; !open.empty(); ++count) {
        const auto [box, f, g] = std::move(open.back());
        open.pop_back();
        if (!may_vanish(f) || !may_vanish(g, error_)) continue;
        const Vec2 size = box.extent();
        const double widest = std::max(size.x, size.y);
        GradientBounds a = slopes_of(f), b = slopes_of(g);
        b.add_error(error_, size);
        const LinearizedSystem pair(a.all, b.all);
        if (pair.root_is_outside()) continue;
        if (pair.variation() < LinearizedSystem::proved) {
            const auto found = solve(box.center() + size * 0.5 * pair.nearest_inside(), size);
            if (found && box.padded(LinearizedSystem::overlap * widest).contains(*found)) {
                result.roots.push_back(*found);
                continue;
            }
            if (found && pair.variation() < LinearizedSystem::straight) continue;
        }
        const bool sharp = spread(box) <= sharpest;
        if (sharp || count >= most_boxes) {
            result.unclear.push_back(box.center());
            result.certain = result.certain && sharp;
            continue;
        }
        Box2 low = box, high = box;
        const unsigned axis = GradientBounds{b.all, a.bend + b.bend}.axis_to_halve(size);
        low.upper[axis] = high.lower[axis] = box.center()[axis];
        auto [low_f, high_f] = halved(f, axis);
        auto [low_g, high_g] = halved(g, axis);
        open.push_back({high, std::move(high_f), std::move(high_g)});
        open.push_back({low, std::move(low_f), std::move(low_g)});
    }
    return result;
}

} // namespace keiko
