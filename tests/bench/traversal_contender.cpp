#include "tests/bench/traversal_contender.h"

#include "tests/bench/embree_pass.h"

#include <utility>

namespace keiko::bench {
namespace {

Box3 box_around(std::span<const Box3> boxes) {
    Box3 all;
    for (const Box3& box : boxes) all.extend(box);
    return all;
}

std::vector<Box3> moved(std::span<const Box3> boxes, const Vec3& origin) {
    std::vector<Box3> result;
    for (const Box3& box : boxes) result.push_back({box.lower - origin, box.upper - origin});
    return result;
}

} // namespace

TraversalContender::TraversalContender(std::span<const Box3> boxes, bool end_at_hit)
    : ball_(box_around(boxes)),
      boxes_(moved(boxes, ball_.center)),
      end_at_hit_(end_at_hit),
      body_(boxes_) {
    facts_.kind = end_at_hit ? Kind::traversal_to_hit : Kind::traversal;
    facts_.name = end_at_hit ? "empty callback, to the hit" : "empty callback";
    facts_.elements = boxes_.size();
    facts_.bytes = body_.bytes();
    facts_.build_seconds = body_.build_seconds();
}

std::unique_ptr<Pass> TraversalContender::pass(const RaySet& rays, Mode mode) const {
    EmbreeRays prepared(rays, ball_, mode, {.end_at_hit = end_at_hit_});
    return std::make_unique<EmbreePass>(body_, rays, std::move(prepared));
}

} // namespace keiko::bench
