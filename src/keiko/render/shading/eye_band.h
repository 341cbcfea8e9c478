#pragma once

#include "keiko/render/reflection/reflected_grid.h"
#include "keiko/render/reflection/sample_batch.h"

#include <vector>

namespace keiko {

/// A grid of camera rays that are followed and then, as long as its pixels are not refined, the
/// grids below it. Each of those takes over two rows of the one above: neighbours of its own rows
/// that need no rays again.
class EyeBand {
public:
    /// Band with the size of the first grid; others are no higher.
    EyeBand(int width, int height) : mirrors(width, height) {}

    /// Allocates the results of the rays of a grid: all samples are `unseen`, except those of rows
    /// taken over.
    void begin(const TileRays& grid, const PixelSample& unseen);

    /// Prefetches the memory that is soon written for a place.
    void announce(std::size_t place) const;

    SampleBatch view;         ///< samples of the grid that was begun last
    ReflectionBuffer mirrors; ///< its reflected rays and their hits

private:
    std::vector<Hits> above_; ///< what rows taken over point to
};

} // namespace keiko
