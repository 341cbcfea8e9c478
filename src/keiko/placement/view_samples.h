#pragma once

#include "keiko/base/export.h"
#include "keiko/base/job.h"
#include "keiko/geometry/bezier/differential_geometry.h"
#include "keiko/geometry/model/surface_model.h"
#include "keiko/geometry/rays/ray.h"
#include "keiko/intersect/hit/hit.h"
#include "keiko/intersect/traversal/tracer.h"
#include "keiko/scene/camera.h"

#include <span>
#include <vector>

namespace KEIKO_API keiko {

/// reflect_ray for hits of any tracer: second derivatives that the hit lacks are taken from the
/// model.
Ray mirrored_ray(const SurfaceModel& model, const Hit& hit, const Ray& camera_ray);

/// The hit's unit normal on the side the ray comes from.
Vec3 facing_normal(const Hit& hit, const Ray& ray);

/// S and its derivatives to order 2 at the hit, in world coordinates.
SurfaceDerivatives world_derivatives(const SurfaceModel& model, const Hit& hit);

/// Direction of a surface feature in the picture, and its strength.
struct FeatureDirection {
    Vec2 along{0};       ///< unit, picture x and y; zero if there is none
    double strength = 0; ///< 1/mm: absolute curvature across it less that along it
};

/// Direction of fillets, edges and character lines: the principal direction of least curvature.
/// `mirrored` starts at the place; its differentials give the projection to the picture.
FeatureDirection feature_direction(const SurfaceDerivatives& surface, const Ray& mirrored);

/// Measure by which a place in the picture is weighted.
enum class SampleWeight {
    solid_angle, ///< the solid angle it covers
    pixels       ///< every pixel the same, as in [NishitaTubes]
};

/// A place of the surface in a picture, and its reflected ray.
struct ViewSample {
    std::uint32_t view = 0;               ///< which of the cameras
    std::uint32_t instance = 0, face = 0; ///< of the hit, into the model's arrays
    Vec2 pixel{0};                        ///< place in the picture
    int edge = 1;                         ///< pixels, of the square that it represents
    double weight = 0;                    ///< share of the picture, by SampleWeight
    Vec3 eye{0};                          ///< origin of the camera ray
    Vec3 normal{0};                       ///< unit, on the side of the camera
    Ray mirror;                           ///< from the surface along the mirror direction
    bool blocked = false;                 ///< the reflected ray hits the body again
    FeatureDirection feature;             ///< of the surface there

    /// The place on the surface, mm.
    const Vec3& position() const { return mirror.origin; }
};

/// Options of sample_views.
struct SamplingOptions {
    int samples = 40000; ///< approximate number of pixels sampled in each picture
    SampleWeight weight = SampleWeight::solid_angle; ///< by which places count
    std::vector<std::uint32_t> faces; ///< faces of the model that count; empty: all of them
};

/// Samples of the body through a uniform grid of pixels of each camera, in the order of cameras,
/// rows and columns; the same for any thread count.
std::vector<ViewSample> sample_views(const Tracer& tracer, const SurfaceModel& model,
                                     std::span<const Camera> cameras,
                                     const SamplingOptions& options, const Job& job = {});

} // namespace keiko
