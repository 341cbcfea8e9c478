#pragma once

#include "keiko/render/lighting/quadratic_fit.h"
#include "keiko/render/lighting/shading_grid.h"
#include "keiko/render/reflection/shading_point.h"

#include <array>
#include <functional>
#include <span>
#include <vector>

namespace keiko {

/// A shading point to be lit, in a tile.
struct LitPlace {
    Pixel pixel;               ///< of the tile
    const ShadingPoint* point; ///< not null
    Rgb seen;                  ///< luminance of its sample besides
};

/// Numbers of places in a tile, rising.
using Places = std::vector<std::size_t>;
/// Places of a region as a plane before them shows them.
using Chart = std::vector<ChartPlace>;

/// Sets of places that chains of neighbours join: places of one pixel, or of pixels side by side,
/// that `alike(number, number)` holds for.
std::vector<Places> regions_of(std::span<const LitPlace> places,
                               const std::function<bool(std::size_t, std::size_t)>& alike);

/// For each place, whether a pixel beside it shows other regions alone, or its own shows others
/// too. Things may stand there on its region.
std::vector<bool> beside_others(std::span<const LitPlace> places, std::span<const Places> regions);

/// A region's places before the plane across the mean of their normals, positions from -1 to 1. No
/// place is tilted unless `tilted`.
Chart chart_of(std::span<const LitPlace> places, const Places& region, bool tilted);

/// The places of a region on both sides of the middle of the widest of their coordinates. Normals
/// count four times as much as positions. The second is empty where all are in one place.
std::array<Places, 2> halves(const Places& region, const Chart& chart);

/// Numbers in a chart of `count` of its places as far from each other as can be, `preferred` ones
/// rather than others.
std::vector<std::size_t> spread_places(const Chart& chart, std::size_t count,
                                       const std::vector<bool>& preferred);

} // namespace keiko
