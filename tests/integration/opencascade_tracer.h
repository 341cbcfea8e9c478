#pragma once

#include "keiko/geometry/model/surface_model.h"
#include "keiko/geometry/rays/ray.h"

#include <filesystem>
#include <memory>
#include <optional>
#include <vector>

class TopoDS_Shape;

namespace keiko::test {

/// Reads a STEP, IGES or BREP file; the extension names its kind.
TopoDS_Shape read_shape(const std::filesystem::path& file);

/// The patches of a model that has no trims, each as a face of its own.
TopoDS_Shape shape_of_patches(const SurfaceModel& model);

/// A hit as OpenCASCADE finds it.
struct PeerHit {
    double t = 0;
    Vec3 position{0};
    bool on_border = false; ///< OpenCASCADE's own state ON
    double tolerance = 0;   ///< largest edge tolerance of the face, mm
    std::size_t face = 0;   ///< in the order of the shape
    Vec2 uv{0};             ///< of the face's surface
};

/// Rays against a CAD file through IntCurvesFace_Intersector, face by face behind boxes: the
/// second implementation that Keiko's hits are compared with, in correctness and in speed.
class OpenCascadeTracer {
public:
    explicit OpenCascadeTracer(const std::filesystem::path& file);
    explicit OpenCascadeTracer(const TopoDS_Shape& shape);
    ~OpenCascadeTracer();

    /// Every hit with t > 0 by rising t; the ray's direction must be unit.
    std::vector<PeerHit> all(const Ray& ray);
    /// The first hit with t > t_min. Faces are met in the order of a box hierarchy, near ones
    /// first, and asked no farther than the nearest hit yet.
    std::optional<PeerHit> nearest(const Ray& ray);
    /// Unit normal of the surface at a hit, of either side; 0 at a pole.
    Vec3 normal(const PeerHit& hit) const;
    /// Distance of a point from the material of the nearest face, mm, by BRepExtrema; slow.
    double distance(const Vec3& point) const;
    std::size_t face_count() const;

private:
    struct Shape;
    std::unique_ptr<Shape> shape_;
};

} // namespace keiko::test
