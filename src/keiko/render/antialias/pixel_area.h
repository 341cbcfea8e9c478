#pragma once

#include "keiko/base/memory.h"
#include "keiko/scene/camera.h"

#include <span>

namespace keiko {

/// A part of the picture that one camera ray stands for: as a parallelogram around its centre, px.
struct PixelArea {
    Vec2 centre{0};
    Vec2 right{0}, down{0}; ///< edges
    double area = 0;        ///< of the part itself, px2
};

/// A convex polygon, its corners in order; room for what two cuts make of six of them.
using Polygon = InplaceVector<Vec2, 24>;

/// `size`: width and height.
PixelArea rectangle_part(const Vec2& corner, const Vec2& size);
/// The parallelogram with the centre and the second moments of a convex polygon that has an area;
/// corners in order, of either sense.
PixelArea polygon_part(std::span<const Vec2> corners);

/// What of a convex polygon lies between two lines across a unit direction, `begin` and `end` along
/// it, px; of six corners at the most.
Polygon strip_of(std::span<const Vec2> corners, const Vec2& across, double begin, double end);

/// The mean over a convex polygon of what is linear in the triangles at its first corner; `values`
/// at the corners.
double polygon_mean(std::span<const Vec2> corners, std::span<const double> values);

/// The ray through the centre, with the part as its footprint.
Ray ray_of(const PreparedCamera& camera, const PixelArea& part);

} // namespace keiko
