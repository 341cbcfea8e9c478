#pragma once

#include "keiko/geometry/rays/ray.h"
#include "keiko/intersect/hit/hit.h"
#include "keiko/maps/scene_maps.h"
#include "keiko/render/reflection/shading_point.h"
#include "keiko/render/shading/paint.h"

#include <memory>
#include <vector>

namespace keiko {

/// Paint of one place of a material with maps.
struct MappedPaint {
    Paint paint;
    /// True if maps vary its normal or its lobes. Its light is not that between its neighbours.
    bool uneven = false;
};

/// True if the light of a shading point must not be interpolated.
inline bool is_uneven(const ShadingPoint& point) {
    return point.mapped && point.mapped->uneven;
}

/// A pixel's step along the surface, mm, of finite length also where the ray touches it.
Vec3 bounded(const Vec3& step);

/// The maps of a picture's scene at the hits of its rays.
class MappedHits {
public:
    /// Maps of a scene, or none where `maps` is null. Keeps references to all.
    MappedHits(const SceneMaps* maps, std::span<const Material> materials)
        : maps_(maps), materials_(materials) {}

    /// True if the face has maps.
    bool has(std::uint32_t face) const { return maps_ && maps_->of_face(face); }
    /// Paint at a ray's hit on a face with maps; `base` is that of its material.
    std::shared_ptr<const MappedPaint> paint(const Paint& base, const Ray& ray,
                                             const Hit& hit) const;
    /// True if the material at a ray's hit emits its light to this side: faces shine outwards,
    /// unless both ways. Where the scene has no maps sides are unknown, and all shine.
    bool shines(const Ray& ray, const Hit& hit) const;
    /// Turns the normal of a hit on a face with maps, and adds the curvature of heights. The normal
    /// stays on the side of the ray, and what it mirrors above the surface: heights that would not
    /// allow it count less.
    void bend(const Ray& ray, Hit& hit) const;

private:
    MapPlace place_of(const Ray& ray, const Hit& hit) const;
    bool is_from_inside(const Ray& ray, const Hit& hit) const {
        return hit.normal.dot(ray.direction) *
                   maps_->outward_side(hit.instance, hit.patch, hit.face, hit.uv) >
               0;
    }

    const SceneMaps* maps_;
    std::span<const Material> materials_;
};

} // namespace keiko
