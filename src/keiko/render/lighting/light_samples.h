#pragma once

#include "keiko/render/lighting/error_budget.h"
#include "keiko/render/lighting/shading_grid.h"
#include "keiko/render/shading/integrator.h"

#include <memory_resource>
#include <optional>
#include <span>
#include <vector>

namespace keiko {

/// What each light of a rig brings to the shading points of a grid, and what they see of it; found
/// where and for which lights it is asked for. Lights are told by their numbers in
/// Integrator::lights(), rising; places have shading points.
class LightSamples {
public:
    /// Both are only looked at.
    LightSamples(const Integrator& integrator, const ShadingGrid& grid);

    /// All of them.
    std::span<const std::size_t> numbers() const { return numbers_; }
    /// Finds what some lights bring to a place, by what is known to be seen of them there, for sure
    /// or not; where nothing is, it is found.
    void find(int x, int y, std::span<const std::size_t> lights);
    /// The same by what is seen for sure.
    void find_for_sure(int x, int y, std::span<const std::size_t> lights);
    /// Whether it is known what is seen of a light, for sure or not.
    bool is_seen(int x, int y, std::size_t light) const {
        const Spot& here = spots_[grid_.index(x, y)];
        return !here.empty() && here[light].is_seen;
    }
    /// Takes it that so much is seen of a light, where it is not known.
    void take(int x, int y, std::size_t light, const LightVisibility& seen);

    /// What a light brings to a place where that has been found.
    const DirectLight& light(int x, int y, std::size_t number) const {
        return spots_[grid_.index(x, y)][number].light;
    }
    DirectLight sum(int x, int y, std::span<const std::size_t> lights) const;
    const LightVisibility& seen(int x, int y, std::size_t number) const {
        return spots_[grid_.index(x, y)][number].seen;
    }
    /// What a light would bring to a place if so much were seen of it.
    DirectLight if_seen(int x, int y, std::size_t light, const LightVisibility& seen) const;

private:
    struct OfLight {
        bool is_seen = false, is_sure = false, is_lit = false; ///< what is known
        LightVisibility seen{};
        DirectLight light{};
    };
    using Spot = std::pmr::vector<OfLight>; ///< by number; empty until it is asked for
    Spot& point(int x, int y);
    /// Makes those of some lights that `keep` the ones that are asked for.
    template <class Keep>
    void ask_for(std::span<const std::size_t> lights, const Keep& keep);
    /// At the lights that are asked for.
    void look(int x, int y);
    /// Those of some that are not lit yet, by what is seen of them.
    void light_up(int x, int y, std::span<const std::size_t> lights);

    const Integrator& integrator_;
    const ShadingGrid& grid_;
    std::vector<std::size_t> numbers_;
    std::pmr::monotonic_buffer_resource memory_; ///< of the shading points
    std::pmr::vector<Spot> spots_;
    Lights asked_;                     ///< for
    std::vector<LightId> asked_lamps_; ///< the same
};

/// A light of which what is seen is linear between the corners of a rectangle.
struct LinearlySeen {
    std::size_t light;
    Rectangle between;
};

/// Lights that are not known yet over a rectangle.
struct UnresolvedLights {
    Lights lit;
    Lights seen; ///< those of them of which it is not known either what is seen
    std::vector<LinearlySeen> linearly_seen{}; ///< the others, and some that are known
};

/// What is seen of a light at a place if it is linear between the corners of a rectangle, where it
/// is known. Nothing where they do not see the same number of parts of it.
std::optional<LightVisibility> seen_between_corners(const LightSamples& lights,
                                                    const ShadingGrid& grid,
                                                    const LinearlySeen& linear, const Pixel& p);

/// Finds what open lights bring to a place.
void find(const UnresolvedLights& open, const ShadingGrid& grid, const Pixel& p,
          LightSamples& lights);

/// Lights, of some that have been found there, that corners and middles of a rectangle of a grid
/// all see as a whole.
Lights classify_prisms(const LightSamples& found, const Rectangle& r, const Lights& lights);

/// Lights, of some, of which it is not proved that all places of a rectangle see the same: all of
/// them or nothing.
Lights possibly_occluded_lights(const Integrator& integrator, const ShadingGrid& grid,
                                const Rectangle& r, const Lights& lights);

} // namespace keiko
