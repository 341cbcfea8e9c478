#pragma once

#include "keiko/geometry/trim/trim_region.h"
#include "keiko/intersect/traversal/tracer.h"

#include "tests/support/exact_root.h"
#include "tests/support/ray_class.h"

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace keiko::test {

/// A ray and an intersection of it that is known beforehand.
struct AimedRay {
    Ray ray;
    RayClass kind = RayClass::random;
    std::size_t placed = 0; ///< index of the patch, of RayScene::patches
    ExactRoot root;
    /// Side of the material: inside: must be among all hits; outside: must not; mixed: within the
    /// tolerance of a trim curve or at the surface's own end, where either is right.
    TrimSide side = TrimSide::inside;
};

/// Outcome of a tracer for an AimedRay.
enum class Verdict {
    found,
    undecided, ///< not among the hits, but one of them is flagged as tangential
    lost,
    wrong, ///< a hit off its ray, hits out of order, or a hit where there is no material
};

/// A model, its tracer, and the same surfaces in long double.
class RayScene {
public:
    explicit RayScene(SurfaceModel model, const TracerOptions& options = {});

    /// A ray through a random point of a random patch. Nothing where the point has no normal or
    /// no ray of doubles through it meets the surface beyond doubt (`exact_root`).
    std::optional<AimedRay> aim(Random& random, RayClass kind) const;
    Verdict judge(const AimedRay& aimed) const;
    /// Report of a failure's hits: how many, how far off the closest, its bound.
    std::string describe(const AimedRay& aimed) const;
    /// Whether every root that brute force over all patches finds is among the hits.
    Verdict judge_by_brute_force(const Ray& ray) const;

    const SurfaceModel& model() const { return model_; }
    const Tracer& tracer() const { return tracer_; }

private:
    struct PlacedPatch {
        std::uint32_t instance, patch;
        ExactPatch exact;
    };
    std::optional<AimedRay> aimed(const Ray& ray, RayClass kind, std::size_t placed,
                                  const Vec2& uv) const;
    /// At the rim of its patch the root may be the neighbour's.
    bool settle_at_rim(AimedRay& aimed, const Vec2& uv) const;
    std::vector<std::size_t> neighbours(std::size_t placed, const Vec2& uv) const;
    TrimSide side_of(const PlacedPatch& placed, const ExactRoot& root) const;
    bool covers(const Hit& hit, const PlacedPatch& placed, const ExactRoot& root) const;
    bool sound(const Ray& ray, const std::vector<Hit>& hits) const;

    SurfaceModel model_;
    Tracer tracer_;
    std::vector<PlacedPatch> patches_;
    std::vector<TrimRegion> regions_; ///< of each face
    double size_;
};

} // namespace keiko::test
