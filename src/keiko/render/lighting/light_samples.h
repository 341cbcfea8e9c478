#pragma once

#include "keiko/render/lighting/error_budget.h"
#include "keiko/render/lighting/shading_grid.h"
#include "keiko/render/shading/integrator.h"

#include <memory_resource>
#include <optional>
#include <span>
#include <vector>

namespace keiko {

/// Light and visibility of each light of a rig at the shading points of a grid, computed where they
/// are requested. Lights are given by their numbers in Integrator::lights(), rising; places have
/// shading points.
class LightSamples {
public:
    /// Keeps references to both.
    LightSamples(const Integrator& integrator, const ShadingGrid& grid);

    /// Computes the light of some lights at a place from their known visibility there, certain or
    /// not; if it is unknown, it is computed.
    void find(int x, int y, std::span<const std::size_t> lights);
    /// Computes the light of some lights at a place from their certain visibility.
    void find_for_sure(int x, int y, std::span<const std::size_t> lights);
    /// True if the visibility of a light is known, certain or not.
    bool is_seen(int x, int y, std::size_t light) const {
        const Spot& here = spots_[grid_.index(x, y)];
        return !here.empty() && here[light].is_seen;
    }
    /// Assumes this visibility of a light where none has been computed.
    void take(int x, int y, std::size_t light, const LightVisibility& seen);

    /// Light of one source at a place where it has been computed.
    const DirectLight& light(int x, int y, std::size_t number) const {
        return spots_[grid_.index(x, y)][number].light;
    }
    /// Sum of the light of some sources at a place where all of it has been computed.
    DirectLight sum(int x, int y, std::span<const std::size_t> lights) const;
    /// Visibility of a light at a place where it is known; see is_seen().
    const LightVisibility& seen(int x, int y, std::size_t number) const {
        return spots_[grid_.index(x, y)][number].seen;
    }
    /// Light of one source at a place for an assumed visibility.
    DirectLight if_seen(int x, int y, std::size_t light, const LightVisibility& seen) const;

private:
    struct OfLight {
        bool is_seen = false, is_sure = false, is_lit = false; ///< what is known
        LightVisibility seen{};
        DirectLight light{};
    };
    using Spot = std::pmr::vector<OfLight>; ///< by number; empty until it is requested
    Spot& point(int x, int y);
    /// Requests the lights of some that `keep` accepts.
    template <class Keep>
    void ask_for(std::span<const std::size_t> lights, const Keep& keep);
    /// Computes the visibility of the requested lights.
    void look(int x, int y);
    /// Computes the light of those not lit yet, from their visibility.
    void light_up(int x, int y, std::span<const std::size_t> lights);

    const Integrator& integrator_;
    const ShadingGrid& grid_;
    std::pmr::monotonic_buffer_resource memory_; ///< of the shading points
    std::pmr::vector<Spot> spots_;
    Lights asked_;                     ///< requested
    std::vector<LightId> asked_lamps_; ///< the same
};

/// Light whose visibility is linear between the corners of a rectangle.
struct LinearlySeen {
    std::size_t light; ///< its number
    Rectangle between; ///< whose corners' visibilities are known
};

/// Lights that are still unknown over a rectangle.
struct UnresolvedLights {
    Lights lit;                                ///< all whose light is unknown
    Lights seen;                               ///< those of them whose visibility is unknown too
    std::vector<LinearlySeen> linearly_seen{}; ///< the others, and some that are known
};

/// Visibility of a light at a place, interpolated linearly between the corners of a rectangle,
/// where it is known. nullopt if the corners do not see the same number of parts of it.
std::optional<LightVisibility> seen_between_corners(const LightSamples& lights,
                                                    const ShadingGrid& grid,
                                                    const LinearlySeen& linear, const Pixel& p);

/// Computes the light of open lights at a place.
void find(const UnresolvedLights& open, const ShadingGrid& grid, const Pixel& p,
          LightSamples& lights);

/// Subset of some lights, computed there, that are visible as a whole from all corners and middles
/// of a rectangle of a grid.
Lights fully_visible_lights(const LightSamples& found, const Rectangle& r, const Lights& lights);

/// Subset of some lights that are not proved to have one visibility from all places of a rectangle:
/// all of a light or nothing.
Lights possibly_occluded_lights(const Integrator& integrator, const ShadingGrid& grid,
                                const Rectangle& r, const Lights& lights);

} // namespace keiko
