#pragma once

#include "keiko/compare/alignment/closest_point_query.h"
#include "keiko/math/affine.h"

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

/// A body as places with normals and the area that each stands for.
using SampleCloud = std::vector<SurfaceSample>;

/// About `count` places of a body; of one whose material is narrower than their distance, the few
/// that a finer search finds. Throws FieldError("align") if it finds none.
SampleCloud surface_cloud(const ClosestPointQuery& body, std::size_t count);

/// Centre of area.
Vec3 centre_of(const SampleCloud& cloud);

/// Start motion of `body` to near `other` for a search for the best one, improved on the clouds,
/// which are not empty; `size` of the other in mm. It is the best of where the body is, its centre
/// on the other's, and the four turns that lay principal axes on each other. Only the nearest
/// `share` of the body's samples counts at a time, by number: trimmed iterated closest points.
/// Throws Cancelled.
Affine coarse_alignment(const SampleCloud& body, const SampleCloud& other, double size,
                        double share, const Job& job = {});

} // namespace keiko
