#pragma once

#include "keiko/light/luminance/clear_coat.h"
#include "keiko/light/luminance/flake_kernel.h"
#include "keiko/light/luminance/stretched_albedo.h"
#include "keiko/maps/surface_maps.h"
#include "keiko/scene/material.h"

#include <optional>

namespace keiko {

/// A material prepared for shading: its sharp reflection, its lobes, and its diffuse base; or
/// glass.
class Paint {
public:
    /// Paint of a material; tabulates the albedo of its lobes. Metals and glass have no base and no
    /// flakes.
    explicit Paint(const Material& material);

    /// This paint of a material where maps vary it. The lobes of another width keep its albedo.
    Paint varied(const Material& material, const MapValues& values) const;

    /// Share of the light that a smooth interface reflects at an angle to the normal of this
    /// cosine, 0 to 1; 0 for a rough one.
    Rgb mirrored(double cosine) const;
    /// The glass that passes what is not mirrored; empty for paints and metals.
    const std::optional<Glass>& glass() const { return glass_; }
    /// Refractive index of the coat or the glass.
    double refractive_index() const { return refractive_index_; }
    /// The base below its coat.
    const ClearCoat& base() const { return base_; }
    /// Share of what the interface reflects that is kept: 1 unless a map says less.
    const Rgb& gloss_share() const { return gloss_share_; }
    /// Share of what passes glass that is kept: 1 unless a map says less.
    const Rgb& passed_share() const { return passed_share_; }
    /// Lobe of a rough interface; empty for a smooth one.
    const std::optional<Gloss>& gloss() const { return gloss_; }
    /// Lobe of the flakes, if there are any.
    const std::optional<Flakes>& flakes() const { return flakes_; }
    /// cd/m2 that it emits in all directions.
    const Rgb& emitted() const { return emitted_; }
    /// True if it reflects any light other than sharply.
    bool takes_light() const { return takes_light_; }
    /// Width in radians of a square of directions that stands for the widest lobe.
    double lobe_width() const;
    /// Which way the scratches of a brushed border run; null without any.
    const ScratchDirection* scratches() const { return scratches_ ? &*scratches_ : nullptr; }
    /// Share of uniform light from all sides that the lobes reflect to a viewer under `cosine`.
    /// `doubled`: of a brushed border, see StretchedAlbedo.
    Rgb gloss_albedo(double cosine, double doubled = 0) const;
    /// Factor of the light of base() for such a viewer, whose mean is 1: a brushed coat passes more
    /// of it in some directions than in others.
    double passed_by_brushed(double cosine, double doubled) const;

private:
    std::optional<Glass> glass_;
    double refractive_index_;
    std::optional<Gloss> gloss_;
    std::optional<Flakes> flakes_;
    std::optional<ScratchDirection> scratches_;
    std::shared_ptr<const StretchedAlbedo> stretched_albedo_; ///< of a brushed border
    std::shared_ptr<const AlbedoTable> gloss_albedo_, flake_albedo_;
    Reflectance mirror_;
    ClearCoat base_;
    bool takes_light_;
    Rgb emitted_;
    Rgb gloss_share_{1}, passed_share_{1};
};

} // namespace keiko
