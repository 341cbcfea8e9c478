#pragma once

#include "keiko/compare/alignment/closest_point_query.h"
#include "keiko/math/affine.h"

#include <array>
#include <span>
#include <vector>

namespace keiko {

// A body as samples of its surface, and the coarse alignment of bodies by these.

/// A place of a body and how much of it it stands for.
struct SurfaceSample {
    SurfacePoint point; ///< the middle of its cell
    double area = 0;    ///< mm2
    Vec2 cell{0};       ///< extent in parameters of the piece
};

/// Spacing of about `count` places of a body, mm.
double sample_spacing(const ClosestPointQuery& body, std::size_t count);

/// The middles of a piece's cells of `spacing` mm, at least `least` a side, that are material.
std::vector<SurfaceSample> piece_samples(const ClosestPointQuery& body, std::size_t piece,
                                         double spacing, int least);

/// Sums up distances that a small rigid motion shall make smallest, by least squares.
class RigidStep {
public:
    /// Motions turn about `pivot`; `size` in mm makes turns and shifts alike.
    RigidStep(const Vec3& pivot, double size) : pivot_(pivot), size_(size) {}

    /// A place whose distance of `distance` mm grows along the unit vector `direction`.
    void add(const Vec3& place, const Vec3& direction, double distance, double weight);

    /// Motion that brings the places nearest; directions that they leave free stay as they are.
    Affine motion() const;
    /// mm, about how far that moves the body.
    double length() const;

private:
    std::array<double, 6> solution() const;

    Vec3 pivot_;
    double size_;
    std::array<std::array<double, 6>, 6> matrix_{};
    std::array<double, 6> right_{};
};

/// A body as places with normals and the area that each stands for.
using SampleCloud = std::vector<SurfaceSample>;

/// Centre of area.
Vec3 centre_of(const SampleCloud& cloud);

/// Start motion of `body` to near `other` for a search for the best one, improved on the clouds;
/// `size` of the other in mm. It is the best of where the body is, its centre on the other's, and
/// the four turns that lay principal axes on each other. Throws Cancelled.
Affine coarse_alignment(const SampleCloud& body, const SampleCloud& other, double size,
                        const Job& job = {});

} // namespace keiko
