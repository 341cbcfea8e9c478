#include "keiko/render/shading/traced_lamp.h"

#include "keiko/geometry/model/outward_side.h"
#include "keiko/intersect/traversal/tracer.h"
#include "keiko/render/shading/occluded_visibility.h"

#include <cmath>
#include <utility>

namespace keiko {
namespace {

/// True if a ray enters the body at a hit by the side of the face that is outside.
bool enters(const SurfaceModel& model, const Ray& ray, const Hit& hit) {
    return hit.normal.dot(ray.direction) * outward_side(model, hit.instance, hit.patch, hit.uv) < 0;
}

/// True if the hits of a ray go in and out by turns, as through a closed body.
bool passes_closed_body(const SurfaceModel& model, const Ray& ray, const std::vector<Hit>& hits) {
    bool within = false;
    for (const Hit& hit : hits) {
        if (enters(model, ray, hit) == within) return false;
        within = !within;
    }
    return !within;
}

} // namespace

TracedLamp::TracedLamp(SurfaceModel model, const Job& job)
    : model_(std::move(model)), occluders_(model_, Tracer(model_, {}, job), job) {}

std::unique_ptr<Visibility> TracedLamp::outline_from(const Vec3& point,
                                                     std::vector<Vec3> region) const {
    return std::make_unique<OccludedVisibility>(&occluders_, occluders_.tracer(),
                                                Viewpoint::at(point), std::move(region));
}

std::optional<double> TracedLamp::distance(const Vec3& origin, const Vec3& direction) const {
    const auto hit = occluders_.tracer().nearest(Ray{.origin = origin, .direction = direction});
    return hit ? std::optional(hit->t) : std::nullopt;
}

bool TracedLamp::contains(const Vec3& point) const {
    if (!bounds().contains(point)) return false;
    const Ray ray{.origin = point, .direction = Vec3(0.267, 0.535, 0.802)}; // aslant to any axis
    const auto hit = occluders_.tracer().nearest(ray);
    return hit && !enters(model_, ray, *hit);
}

Vec3 TracedLamp::in_front(const Vec3& point, const Vec3& normal) const {
    const double near = 1e-6 * bounds().size();
    if (!bounds().padded(near).contains(point)) return point;
    const Vec3 above = point + normal * near;
    const Ray back{.origin = above, .direction = -normal, .t_max = 2 * near};
    return occluders_.tracer().any(back) ? above : point;
}

std::shared_ptr<const LuminousBody> TracedLamp::moved(const Affine& motion) const {
    SurfaceModel model = model_;
    for (Instance& instance : model.instances) instance.transform = motion * instance.transform;
    return std::make_shared<const TracedLamp>(std::move(model));
}

bool TracedLamp::is_closed() const {
    constexpr int side = 8;
    constexpr double irregular = 0.618033988749895; // so that few rays meet an edge
    const Box3& box = bounds();
    const double length = box.size();
    for (unsigned axis = 0; axis < 3; ++axis)
        for (int i = 0; i < side; ++i)
            for (int k = 0; k < side; ++k) {
                const unsigned u = (axis + 1) % 3, v = (axis + 2) % 3;
                const double turn = irregular * (side * i + k + 1);
                Vec3 at = box.lower, to(0, 0, 0);
                at[u] += box.extent()[u] * (i + 0.5) / side;
                at[v] += box.extent()[v] * (k + turn - std::floor(turn)) / side;
                at[axis] -= length;
                to[axis] = 1;
                const Ray ray{.origin = at, .direction = to};
                if (!passes_closed_body(model_, ray, occluders_.tracer().all(ray))) return false;
            }
    return true;
}

} // namespace keiko
