#pragma once

#include "keiko/luminance/visible.h"
#include "keiko/rig/glossy_luminance.h"
#include "keiko/rig/illuminance.h"
#include "keiko/trace/occluders.h"

#include <optional>
#include <vector>

namespace keiko {

/// What an apex sees past the surfaces of a scene, as the luminance core asks for it. Candidates
/// are collected when the first question comes.
class SeenPast final : public Visible {
public:
    /// `region`: corners of a convex body that holds every segment to be asked for. Without
    /// occluders everything is seen; they and the tracer are only looked at.
    SeenPast(const Occluders* occluders, const Tracer& tracer, const Apex& apex,
             std::vector<Vec3> region)
        : occluders_(occluders), tracer_(tracer), apex_(apex), region_(std::move(region)) {}

    IntervalSet intervals(const Segment& segment) const override;

private:
    const Occluders* occluders_;
    const Tracer& tracer_;
    Apex apex_;
    std::vector<Vec3> region_;
    mutable std::optional<ApexView> view_;
};

/// The sources of a rig as lights that the surfaces of a scene stand in the way of, at points of a
/// surface, whose own root is known, or in space.
class ShadowedRig {
public:
    /// Without occluders nothing casts shadows. All are only looked at.
    ShadowedRig(const LightRig& rig, const Occluders* occluders, const Tracer& tracer)
        : rig_(rig), occluders_(occluders), tracer_(tracer) {}

    /// lx from one source at a point, as illuminance_from.
    Rgb from_source(std::size_t source, const Vec3& point, const Vec3& normal,
                    const std::optional<Root>& root, TubeModel model,
                    const ClearCoat* coat = nullptr) const;
    /// From all of them, without the rig's ambient light.
    Rgb illuminance(const Vec3& point, const Vec3& normal, const std::optional<Root>& root,
                    TubeModel model, const ClearCoat* coat = nullptr) const;
    /// cd/m2 that the lobe of a kernel sends to its eye, as glossy_luminance.
    template <class Kernel>
    Rgb glossy(const Vec3& point, const std::optional<Root>& root, const Kernel& kernel) const {
        Rgb sum;
        for (const LightSource& source : rig_.sources)
            sum += glossy_luminance_from(source, rig_.medium, point, kernel,
                                         seen_from(point, root, source));
        return sum;
    }

private:
    SeenPast seen_from(const Vec3& point, const std::optional<Root>& root,
                       const LightSource& source) const;

    const LightRig& rig_;
    const Occluders* occluders_;
    const Tracer& tracer_;
};

} // namespace keiko
