#pragma once

#include "keiko/intersect/traversal/tracer.h"
#include "keiko/light/fog/medium.h"
#include "keiko/render/caustics/light_chart.h"
#include "keiko/scene/caustic_spec.h"
#include "keiko/scene/material.h"

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace keiko {

/// Way of light: a step at each surface, in their order.
class LightWay {
public:
    /// Effect of a surface on light.
    enum class Step : std::uint8_t { mirrors, bends, passes };

    /// Number of surfaces.
    int length() const { return length_; }
    /// Step at one of them.
    Step at(int surface) const { return static_cast<Step>(steps_ >> (2 * surface) & 3U); }
    /// The way with one more surface; of 12 at the most.
    LightWay after(Step step) const {
        LightWay way = *this;
        way.steps_ |= static_cast<std::uint32_t>(step) << (2 * length_);
        ++way.length_;
        return way;
    }
    /// True if all it did was to cross panes, as light does that counts as direct.
    bool is_direct() const {
        for (int i = 0; i < length_; ++i)
            if (at(i) != Step::passes) return false;
        return true;
    }
    bool operator==(const LightWay&) const = default; ///< True for the same steps.

private:
    std::uint32_t steps_ = 0;
    int length_ = 0;
};

/// Place at which light that came by mirrors or solid glass meets a surface that is not glass.
struct LightLanding {
    LightWay way;                         ///< to here
    std::uint32_t instance = 0, face = 0; ///< of the surface, into the model's arrays
    Vec3 position{0}, normal{0};          ///< mm; unit, on the side that the light comes from
    Vec3 direction{0};                    ///< unit, of the light
    Vec3 dx{0}, dy{0};                    ///< change of the position with the first ray's, mm
    Vec3 first{0};                        ///< mm, place of the first surface on the way
    Rgb weight;                           ///< share of the light that arrives
};

/// Follows light from surface to surface: smooth metals and coats mirror it, glass bends it. Rough
/// ones end its way, and so do the limits of the specification.
class LightPaths {
public:
    /// `materials`: one a face of the tracer's model. Keeps references to all.
    LightPaths(const Tracer& tracer, std::span<const Material> materials,
               const std::optional<Medium>& medium, const CausticSpec& spec)
        : tracer_(tracer), materials_(materials), medium_(medium), spec_(spec) {}

    /// All landings of a ray of a chart, where light arrives by more than panes, each
    /// branch after what it is mirrored from.
    std::vector<LightLanding> landings(const LightChart& chart, const Vec2& at) const;
    /// The landing of a ray by a way, however little light it brings; nullopt if the ray does not
    /// go it.
    std::optional<LightLanding> landing(const LightChart& chart, const Vec2& at,
                                        const LightWay& way) const;

private:
    struct Leg;
    struct Branch;
    struct Arrival;
    void follow(const Leg& leg, const LightWay* only, std::vector<Arrival>& found) const;
    std::vector<Branch> branches(const Leg& leg, const Hit& hit) const;
    void go_on(const Leg& leg, const Hit& hit, const LightWay* only,
               std::vector<Arrival>& found) const;
    std::vector<LightLanding> followed(const LightChart& chart, const Vec2& at,
                                       const LightWay* only) const;
    std::optional<Vec3> position(const LightChart& chart, const Vec2& at,
                                 const LightLanding& like) const;
    std::optional<Vec3> change(const LightChart& chart, const Vec2& at, const Vec2& step,
                               const LightLanding& like) const;
    bool differentiate(const LightChart& chart, const Vec2& at, LightLanding& landing) const;
    Rgb left_on(const Leg& leg, const Hit& hit) const;

    const Tracer& tracer_;
    std::span<const Material> materials_;
    const std::optional<Medium>& medium_;
    CausticSpec spec_;
};

/// For each material whether it casts caustics: true for smooth ones that are solid glass or mirror
/// at least `min_weight` of what falls on them straight.
std::vector<bool> casting_faces(std::span<const Material> materials, double min_weight);

} // namespace keiko
