#include "keiko/render/shading/traced_lamp.h"

#include "keiko/geometry/model/outward_side.h"
#include "keiko/geometry/seam/closed_borders.h"
#include "keiko/intersect/traversal/tracer.h"
#include "keiko/render/shading/occluded_visibility.h"

#include <algorithm>
#include <array>
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

/// Places of the faces: beside their borders and in the middles of their patches.
std::vector<Vec3> places_of_faces(const SurfaceModel& model) {
    constexpr double aside = 0.013; // of a border's length
    std::vector<Vec3> places;
    const BoundaryCurves curves(model);
    for (const BoundaryInterval& border : curves.all()) {
        const SurfaceCurve curve = curves.curve(border);
        for (const double t : {0.29, 0.73})
            if (const auto frame = curve.frame(t))
                places.push_back(curve.at(t).position +
                                 frame->inward * (aside * curve.length(0, 1)));
    }
    for (const Instance& instance : model.instances) {
        const Part& part = model.parts[instance.part];
        for (std::uint32_t f = part.first_face; f < part.first_face + part.face_count; ++f)
            for (std::uint32_t k = 0; k < model.faces[f].patch_count; ++k) {
                const auto patch = model.patch(model.faces[f].first_patch + k);
                places.push_back(
                    instance.transform.point(evaluate(patch, {0.47, 0.56}, 0).d[0][0]));
            }
    }
    return places;
}

/// Rays across a model of a size through places of its faces, aslant to its axes.
std::vector<Ray> rays_through_faces(const SurfaceModel& model, double size) {
    const std::array ways{Vec3(0.267, 0.535, 0.802), Vec3(-0.713, 0.391, 0.582),
                          Vec3(0.619, -0.754, 0.219)};
    std::vector<Ray> rays;
    for (const Vec3& place : places_of_faces(model))
        for (const Vec3& way : ways)
            rays.push_back({.origin = place - way * (2 * size), .direction = way});
    return rays;
}

} // namespace

TracedLamp::TracedLamp(SurfaceModel model, const Job& job, LampSides sides)
    : model_(std::move(model)),
      sides_(sides),
      occluders_(model_, Tracer(model_, {}, job), job),
      contour_(model_, job) {}

std::unique_ptr<Visibility> TracedLamp::outline_from(const Vec3& point,
                                                     std::vector<Vec3> region) const {
    // Of quadrics arcs are exact; of other surfaces each halving makes an arc 16 times better.
    constexpr double outline_error = 1e-6;
    if (contour_.is_known())
        return std::make_unique<LampOutline>(
            point, contour_.arcs_from(point, outline_error), sides_,
            [this, point](const Vec3& way) { return sides_along(point, way); }, bounds());
    return std::make_unique<OccludedVisibility>(&occluders_, occluders_.tracer(),
                                                Viewpoint::at(point), std::move(region));
}

std::optional<double> TracedLamp::distance(const Vec3& origin, const Vec3& direction) const {
    const auto hit = occluders_.tracer().nearest(Ray{.origin = origin, .direction = direction});
    return hit ? std::optional(hit->t) : std::nullopt;
}

std::vector<bool> TracedLamp::sides_along(const Vec3& point, const Vec3& direction) const {
    const Ray ray{.origin = point, .direction = direction};
    std::vector<bool> sides;
    for (const Hit& hit : occluders_.tracer().all(ray)) sides.push_back(enters(model_, ray, hit));
    return sides;
}

bool TracedLamp::contains(const Vec3& point) const {
    if (sides_ != LampSides::of_solid || !bounds().contains(point)) return false;
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
    return std::make_shared<const TracedLamp>(std::move(model), Job{}, sides_);
}

bool TracedLamp::is_closed(const Job& job) const {
    if (!borders_close(model_, closing_join(model_), job)) return false;
    const std::vector<Ray> rays = rays_through_faces(model_, bounds().size());
    const std::vector<std::vector<Hit>> hits = occluders_.tracer().all(rays);
    std::vector<bool> is_met(model_.faces.size());
    for (std::size_t i = 0; i < rays.size(); ++i) {
        if (!passes_closed_body(model_, rays[i], hits[i])) return false;
        for (const Hit& hit : hits[i]) is_met[hit.face] = true;
    }
    return std::all_of(model_.instances.begin(), model_.instances.end(), [&](const Instance& of) {
        const Part& part = model_.parts[of.part];
        const auto first = is_met.begin() + part.first_face;
        return std::all_of(first, first + part.face_count, [](bool is) { return is; });
    });
}

} // namespace keiko
