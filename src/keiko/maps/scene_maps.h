#pragma once

#include "keiko/geometry/model/outward_side.h"
#include "keiko/geometry/model/surface_model.h"
#include "keiko/maps/environment.h"
#include "keiko/maps/surface_maps.h"
#include "keiko/scene/material.h"

#include <memory>
#include <optional>
#include <span>
#include <vector>

namespace keiko {

/// Parameters of faces, 0 to 1 over all patches of each.
class FaceParameters {
public:
    /// Parameters of the faces of a model.
    explicit FaceParameters(const SurfaceModel& model);

    /// Parameters at a place of a patch, where the surface has these tangents; of patches beyond
    /// those of the model the patch's own. Without gradients at poles.
    ProjectedPlace at(std::uint32_t patch, const Vec2& uv, const Vec3& dpdu,
                      const Vec3& dpdv) const;
    /// True if one of a patch's parameters alone runs against that of its face.
    bool is_turned(std::uint32_t patch, const Vec2& uv) const;

private:
    struct Range {
        ParameterMap map;
        double begin = 0, size = 1; ///< of the face

        double at(double t) const { return (map.to_face(t) - begin) / size; }
        double slope(double t) const { return map.derivative(t) / size; }
    };
    struct PatchRanges {
        Range u, v;
    };

    std::vector<PatchRanges> of_patch_;
};

/// All maps of a scene and its surroundings, prepared.
class SceneMaps {
public:
    /// Maps of the materials of each face of a model, or of that and others behind it. Throws
    /// Error for a picture that cannot be read.
    SceneMaps(std::span<const Material> materials, const SurfaceModel& model,
              const std::optional<EnvironmentSpec>& environment = {});

    /// 1 if the normal of a placed patch at its own parameters points to the outer side of its
    /// face, else -1.
    double outward_side(std::uint32_t instance, std::uint32_t patch, std::uint32_t face,
                        const Vec2& uv) const {
        return keiko::outward_side(parameters_.is_turned(patch, uv), reversed_[face],
                                   mirrored_[instance]);
    }
    /// Maps of a face; null without any.
    const SurfaceMaps* of_face(std::uint32_t face) const { return of_face_[face].get(); }
    /// The surroundings; null without any.
    const Environment* environment() const { return environment_ ? &*environment_ : nullptr; }
    /// Parameters of the faces.
    const FaceParameters& parameters() const { return parameters_; }

private:
    std::vector<std::shared_ptr<const SurfaceMaps>> of_face_;
    std::vector<bool> reversed_, mirrored_; ///< by face, by instance
    FaceParameters parameters_;
    std::optional<Environment> environment_;
};

} // namespace keiko
