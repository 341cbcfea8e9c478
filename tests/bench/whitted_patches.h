#pragma once

#include "keiko/geometry/model/surface_model.h"
#include "keiko/geometry/rays/ray.h"

#include <optional>
#include <vector>

namespace keiko::bench {

/// Rays against patches by division in four: a piece whose bounding sphere a ray misses is dropped,
/// and one whose sphere is small enough is a hit [Whitted1980]. Trims do not count.
class WhittedPatches {
public:
    /// Weights must be positive. A sphere of `tolerance` mm is a hit.
    WhittedPatches(const SurfaceModel& model, double tolerance);

    /// Length along a ray of unit direction to the first hit.
    std::optional<double> first(const Ray& ray) const;

private:
    struct Piece {
        int degree_u = 0, degree_v = 0;
        std::vector<Vec4> points{}; ///< homogeneous, world
        Vec3 center{0};             ///< of the sphere around them
        double radius = 0;
    };

    static Piece piece_of(int degree_u, int degree_v, std::vector<Vec4> points);
    static std::vector<Piece> quarters(const Piece& piece);

    std::vector<Piece> patches_;
    double tolerance_;
};

} // namespace keiko::bench
