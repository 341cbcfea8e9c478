#pragma once

#include "keiko/geometry/model/surface_model.h"

#include <numbers>
#include <vector>

namespace keiko::test {

/// A patch to be put into a model: control points are homogeneous, u outer.
struct PatchData {
    int degree_u = 1, degree_v = 1;
    std::vector<Vec4> points;
    ParameterMap map_u, map_v;
};

/// A trim curve to be put into a model: homogeneous points in face parameters.
struct CurveData {
    std::vector<Vec3> points;
    std::uint32_t edge = no_index;
};

using LoopData = std::vector<CurveData>;

/// A model of one part, placed once, that faces are added to.
class ShapeBuilder {
public:
    ShapeBuilder();
    /// Adds a face with its patches and loops.
    ShapeBuilder& face(const std::vector<PatchData>& patches,
                       const std::vector<LoopData>& loops = {});
    /// Adds an edge; returns its index.
    std::uint32_t edge(double tolerance);
    /// Replaces the placements by these.
    ShapeBuilder& place(const std::vector<Affine>& transforms);
    const SurfaceModel& model() const { return model_; }

private:
    SurfaceModel model_;
};

/// Bilinear patch with corners S(0,0), S(1,0), S(0,1), S(1,1); face parameters = patch parameters.
PatchData bilinear(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d);
/// The rectangle [x0, x1] x [y0, y1] at height z; face parameters are x and y.
PatchData rectangle(double x0, double x1, double y0, double y1, double z);
/// Eight rational biquadratic octants about `center`, poles on the z axis; face parameters are
/// longitude and latitude.
std::vector<PatchData> sphere(const Vec3& center, double radius);
/// Four rational quarters of a cylinder about the z axis, z from 0 to `height`.
std::vector<PatchData> cylinder(double radius, double height);
/// Sixteen rational biquadratic patches about the z axis.
std::vector<PatchData> torus(double major, double minor);

/// Straight p-curve.
CurveData line(const Vec2& from, const Vec2& to, std::uint32_t edge = no_index);
/// Closed polygon of straight p-curves.
LoopData polygon(const std::vector<Vec2>& corners, std::uint32_t edge = no_index);
/// Circle of four rational quadratic arcs.
LoopData circle(const Vec2& center, double radius, std::uint32_t edge = no_index);

} // namespace keiko::test
