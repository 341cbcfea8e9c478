#pragma once

#include "keiko/base/job.h"
#include "keiko/geometry/model/surface_model.h"
#include "keiko/scene/material.h"
#include "keiko/texels/texel_shell.h"

#include <span>
#include <vector>

namespace keiko {

/// All texels of a scene.
class SceneTexels {
public:
    /// Texels over the faces of a model whose materials, one a face, have some. Copies what it
    /// needs. Throws Cancelled.
    SceneTexels(const SurfaceModel& model, std::span<const Material> materials,
                const Job& job = {});

    /// The shells, by instance and face.
    const std::vector<TexelShell>& shells() const { return shells_; }
    /// Boxes of the shells, mm.
    std::vector<Box3> boxes() const;
    /// Distance from a place beyond which there is none, mm; 0 without any.
    double reach_from(const Vec3& place) const;
    /// Optical depth of all along a segment, or more than `most` where it is more.
    double optical_depth(const Segment& segment, double most) const;

private:
    std::vector<std::shared_ptr<const TexelSpec>> specs_;
    std::vector<TexelShell> shells_;
};

/// True if one of some materials has texels.
bool have_texels(std::span<const Material> materials);

} // namespace keiko
