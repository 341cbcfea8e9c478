#pragma once

#include "keiko/render/antialias/edge_cell.h"
#include "keiko/render/shading/integrator.h"
#include "keiko/scene/camera.h"

#include <memory_resource>
#include <span>
#include <unordered_map>
#include <vector>

namespace keiko {

/// Single camera rays through places of the picture, px, that sample the visible surface; their
/// samples are kept.
class EdgeSamples {
public:
    /// No samples yet; keeps references to both.
    EdgeSamples(const Integrator& integrator, const PreparedCamera& camera)
        : integrator_(integrator), camera_(camera) {}

    /// One sample a place, in order.
    std::vector<const PixelSample*> at(std::span<const Vec2> places);
    /// One sample a place, in order; places that were requested before get no ray again.
    std::vector<const PixelSample*> shared_at(std::span<const Vec2> places);

    /// Statistics of the hits of all rays traced so far.
    HitStatistics paths() const;

private:
    const Integrator& integrator_;
    const PreparedCamera& camera_;
    std::vector<SampleBatch> views_;
    struct PlaceHash {
        std::size_t operator()(const Vec2& place) const;
    };
    std::pmr::monotonic_buffer_resource memory_; ///< of the samples: none is discarded
    std::pmr::unordered_map<Vec2, const PixelSample*, PlaceHash> known_{&memory_};
};

/// The sides that edges cross of each cell in turn, halved until the place is accurate to a
/// sixty-fourth of a pixel or no edge is found there. Neighbouring cells share the result.
std::vector<EdgeCrossing> outline_crossings(EdgeSamples& probes, std::span<const SeenCell> cells);

} // namespace keiko
