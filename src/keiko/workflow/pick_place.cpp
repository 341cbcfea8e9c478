#include "keiko/workflow/pick_place.h"

#include "keiko/geometry/bezier/subpatch.h"
#include "keiko/inspect/basics/patch_box.h"
#include "keiko/inspect/basics/placed_face.h"
#include "keiko/inspect/curvature/curvature_range.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace keiko {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// Ranges of the principal curvatures, the larger first.
struct PrincipalRanges {
    Interval k1{-infinity, infinity}, k2{-infinity, infinity};
};

/// The parameters around a place, within the patch.
Box2 box_around(const Vec2& uv, double reach) {
    return {{std::max(uv.x - reach, 0.0), std::max(uv.y - reach, 0.0)},
            {std::min(uv.x + reach, 1.0), std::min(uv.y + reach, 1.0)}};
}

/// The certified box of a hit's patch parameters, which holds the exact place, and boxes about it.
/// Ranges over smaller boxes are narrower, but lose more digits.
std::vector<Box2> boxes_of(const Hit& hit) {
    constexpr std::array reaches{1e-2, 1e-3, 3e-4, 1e-4, 3e-5}; // of the patch's parameters
    const Box2& root = hit.root.uv;
    std::vector<Box2> boxes{root};
    for (const double reach : reaches) {
        const Box2 box = box_around(hit.uv, reach);
        if (box.lower.x <= root.lower.x && box.lower.y <= root.lower.y &&
            root.upper.x <= box.upper.x && root.upper.y <= box.upper.y)
            boxes.push_back(box);
    }
    return boxes;
}

/// Control points about the middle of two opposite corners, where numbers are small.
void centre(std::vector<Vec4>& points) {
    const Vec3 middle = (euclidean(points.front()) + euclidean(points.back())) / 2;
    for (Vec4& p : points) p -= Vec4(middle.x * p.w, middle.y * p.w, middle.z * p.w, 0);
}

/// Ranges with respect to du x dv at the exact place of a hit: the common part of those over each
/// of its boxes.
PrincipalRanges ranges_at(const SurfaceModel& model, const Hit& hit) {
    const BezierPatchView own = model.patch(hit.patch);
    const PlacedPatch placed(model, hit.patch, model.instances[hit.instance].transform);
    const BezierPatchView patch{own.degree_u, own.degree_v, placed.points};
    const double rounding = placed.rounding + PatchBox(patch).rounding();
    PrincipalRanges ranges;
    for (const Box2& box : boxes_of(hit)) {
        std::vector<Vec4> points = subpatch(patch, box);
        centre(points);
        const CurvatureRange found =
            curvature_range({patch.degree_u, patch.degree_v, points}, rounding);
        ranges.k1 = ranges.k1.intersection(found.k1.range);
        ranges.k2 = ranges.k2.intersection(found.k2.range);
    }
    return ranges;
}

} // namespace

std::optional<PickedPlace> pick_place(const Scene& scene, const Tracer& seen, const Camera& camera,
                                      const Vec2& pixel) {
    const Ray ray = camera.ray(pixel.x, pixel.y);
    const std::optional<Hit> hit = seen.nearest(ray);
    if (!hit) return std::nullopt;
    const Vec3 normal = hit->normal.dot(ray.direction) > 0 ? -hit->normal : hit->normal;
    PickedPlace picked{scene.face_id(hit->face),
                       hit->position,
                       hit->position_bound,
                       hit->flags == HitFlags::none,
                       normal,
                       0.0,
                       0.0};
    if (hit->face >= scene.model.faces.size()) return picked; // the ground is a plane
    const PrincipalRanges ranges = ranges_at(scene.model, *hit);
    const bool turned = normal.dot(hit->dpdu.cross(hit->dpdv)) < 0;
    picked.k1 = turned ? -ranges.k2 : ranges.k1;
    picked.k2 = turned ? -ranges.k1 : ranges.k2;
    return picked;
}

} // namespace keiko
