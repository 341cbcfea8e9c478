#pragma once

#include "keiko/inspect/flaws/face_surface.h"

#include <vector>

namespace keiko {

/// A sample of a placed face.
struct FaceSample {
    Vec3 position{0}; ///< world, mm
    /// 1/mm, normal curvature along the lines of constant v and of constant u; positive where the
    /// surface bends towards its outward normal.
    double bend_u = 0, bend_v = 0;
    bool material = false;
};

/// A placed face over all its knot spans, sampled uniformly.
class FaceGrid {
public:
    /// `spacing`: approximate distance between samples, mm.
    FaceGrid(const FaceSurface& face, double spacing);

    std::size_t columns() const { return u_.size(); } ///< along u
    std::size_t rows() const { return v_.size(); }    ///< along v
    const FaceSample& sample(std::size_t column, std::size_t row) const {
        return samples_[row * u_.size() + column];
    }
    /// Place of a sample on the face.
    Vec2 place(std::size_t column, std::size_t row) const { return {u_[column], v_[row]}; }

private:
    std::vector<double> u_, v_;       ///< of the samples
    std::vector<FaceSample> samples_; ///< v outer
};

} // namespace keiko
