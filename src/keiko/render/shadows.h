#pragma once

#include "keiko/luminance/visible.h"
#include "keiko/rig/glossy_luminance.h"
#include "keiko/rig/illuminance.h"
#include "keiko/rig/rig_light.h"
#include "keiko/trace/occluders.h"
#include "keiko/trace/shadow_pencil.h"

#include <optional>
#include <vector>

namespace keiko {

/// What an apex sees past the surfaces of a scene, as the luminance core asks for it. Candidates
/// are collected when the first question comes.
class SeenPast final : public Visible {
public:
    /// `region`: corners of a convex body that holds every segment to be asked for. `row`: segments
    /// that are likely to be asked for, best in their order, found together with the first of
    /// them. With `facing` only what lies before the surface of that normal counts, the rest is
    /// hidden. Without occluders everything is seen; they and the tracer are only looked at.
    /// `pencil`, of the apex as its light: answers for the row in their place. Not for two threads
    /// at once.
    SeenPast(const Occluders* occluders, const Tracer& tracer, const Apex& apex,
             std::vector<Vec3> region, std::vector<Segment> row = {},
             const std::optional<Vec3>& facing = {}, const ShadowPencil* pencil = nullptr)
        : occluders_(occluders),
          tracer_(tracer),
          apex_(apex),
          region_(std::move(region)),
          row_(std::move(row)),
          facing_(facing),
          pencil_(pencil) {}

    IntervalSet intervals(const Segment& segment) const override;
    std::vector<IntervalSet> intervals(std::span<const Segment> segments) const override;
    std::vector<std::optional<bool>> seen_as_whole(std::span<const Prism> prisms) const override;

private:
    const ApexView& view() const;
    std::optional<std::size_t> place_in_row(const Segment& segment) const;

    const Occluders* occluders_;
    const Tracer& tracer_;
    Apex apex_;
    std::vector<Vec3> region_;
    std::vector<Segment> row_;
    std::optional<Vec3> facing_;
    const ShadowPencil* pencil_;
    mutable std::optional<ApexView> view_;
    mutable std::vector<IntervalSet> of_row_; ///< once one of the row was asked for
    mutable std::size_t next_ = 0;            ///< after the one of the row that was asked for last
};

/// A point of a surface or in space under lights of a rig of which it is known what it sees.
class LitPoint {
public:
    /// Unit normal on the side to be lit; `lights` by source, then by lamp; `seen` of each, as
    /// ShadowedRig::seen_from has it for the same model. Rig and lights are only looked at.
    LitPoint(const LightRig& rig, const Vec3& point, const Vec3& normal, TubeModel model,
             std::span<const RigLight> lights, std::vector<SeenLight> seen)
        : rig_(rig),
          point_(point),
          normal_(normal),
          model_(model),
          lights_(lights),
          seen_(std::move(seen)) {}

    /// lx from each light, in order.
    std::vector<Rgb> illuminance_by_light(const ClearCoat* coat = nullptr) const;
    /// cd/m2 that the lobe of a kernel, made for the point's normal, sends to its eye of each
    /// light.
    template <class Kernel>
    std::vector<Rgb> glossy_by_light(const Kernel& kernel) const {
        return by_light([&](const LightSource& source, std::span<const int> lamps,
                            std::span<const SeenLight> seen) {
            return glossy_luminance_by_lamp(source, lamps, seen, rig_.medium, point_, kernel);
        });
    }

private:
    /// What `of_source` of a source, some of its lamps and what is seen of them comes to.
    template <class OfSource>
    std::vector<Rgb> by_light(const OfSource& of_source) const {
        std::vector<Rgb> all;
        each_source(
            lights_, [&](std::size_t source, std::span<const int> lamps, std::size_t first) {
                for (const Rgb& value : of_source(rig_.sources[source], lamps,
                                                  std::span(seen_).subspan(first, lamps.size())))
                    all.push_back(value);
            });
        return all;
    }

    const LightRig& rig_;
    Vec3 point_, normal_;
    TubeModel model_;
    std::span<const RigLight> lights_;
    std::vector<SeenLight> seen_;
};

/// The sources of a rig as lights that the surfaces of a scene stand in the way of.
class ShadowedRig {
public:
    /// Without occluders nothing casts shadows. All are only looked at.
    ShadowedRig(const LightRig& rig, const Occluders* occluders, const Tracer& tracer)
        : rig_(rig), occluders_(occluders), tracer_(tracer), lights_(lights_of(rig)) {}

    /// All of them, by source, then by lamp.
    const std::vector<RigLight>& lights() const { return lights_; }
    /// What a point with a unit normal on the side to be lit sees of some lights, by source, then
    /// by lamp; of a point on a surface, its own root. `axes`: see seen_lights(); rigs with a
    /// medium have them always.
    std::vector<SeenLight> seen_from(const Vec3& point, const Vec3& normal,
                                     const std::optional<Root>& root,
                                     std::span<const RigLight> lights, TubeModel model,
                                     bool axes = true) const;

private:
    const LightRig& rig_;
    const Occluders* occluders_;
    const Tracer& tracer_;
    std::vector<RigLight> lights_;
};

} // namespace keiko
