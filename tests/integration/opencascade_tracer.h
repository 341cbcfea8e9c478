#pragma once

#include "keiko/patch/ray.h"

#include <filesystem>
#include <memory>
#include <vector>

namespace keiko::test {

/// A hit as OpenCASCADE finds it.
struct PeerHit {
    double t = 0;
    Vec3 position{0};
    bool on_border = false; ///< OpenCASCADE's own state ON
    double tolerance = 0;   ///< largest edge tolerance of the face, mm
};

/// Rays against a CAD file through IntCurvesFace_Intersector, face by face behind boxes: the
/// second implementation that Keiko's hits are compared with.
class OpenCascadeTracer {
public:
    explicit OpenCascadeTracer(const std::filesystem::path& file);
    ~OpenCascadeTracer();

    /// Every hit with t > 0 by rising t; the ray's direction must be unit.
    std::vector<PeerHit> all(const Ray& ray);
    /// Distance of a point from the material of the nearest face, mm, by BRepExtrema; slow.
    double distance(const Vec3& point) const;

private:
    struct Shape;
    std::unique_ptr<Shape> shape_;
};

} // namespace keiko::test
