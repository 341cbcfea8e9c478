#pragma once

#include "keiko/geometry/seam/seam_gap.h"
#include "keiko/intersect/traversal/tracer.h"

#include "tests/support/random.h"

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace keiko::test {

/// Outcomes of rays against a closed model.
struct ClosureCounts {
    std::size_t rays = 0, hits = 0;
    std::size_t tangential = 0; ///< a hit is flagged: one touch may count once or twice
    std::size_t edge_on = 0; ///< along an edge's outline, where parallel rays beside it differ by 2
    std::size_t leaks = 0;   ///< all rays around have one more hit
    std::size_t doubled = 0; ///< all rays around have one hit less
    /// Like doubled, by rays that pass between the two borders of a measured seam: they come in
    /// through the opening that the file leaves, and meet one of its two faces. Also all that is
    /// odd of rays that pass an opening wider than is sealed, or at a lower angle than seams are
    /// sealed against.
    std::size_t through_steps = 0;
    std::size_t unclear = 0;      ///< odd, and none of these
    std::size_t out_of_order = 0; ///< even, but somewhere left more often than entered
    std::size_t aimed = 0, aimed_lost = 0;

    std::string text() const;
};

/// A point of a shared edge, or the vertex where it begins, and the surface there.
struct EdgePoint {
    Vec3 position{0}, normal{0}; ///< world
};

/// A model that encloses a volume: whatever enters must leave again.
class ClosedModel {
public:
    explicit ClosedModel(SurfaceModel model);

    /// A chord through the model's box, from well outside.
    Ray random_ray(Random& random) const;
    /// nullopt where the surface has no normal.
    std::optional<EdgePoint> random_edge_point(Random& random) const;

    void count_parity(const Ray& ray, ClosureCounts& counts) const;
    /// A ray through the point from anywhere that is not nearly in the surface: it must hit there.
    void count_aimed(const EdgePoint& point, Random& random, ClosureCounts& counts) const;

private:
    struct BorderCurve {
        std::uint32_t instance, face, curve;
    };
    /// Numbers of hits of four rays parallel to it, so far off in mm.
    std::array<std::size_t, 4> hits_beside(const Ray& ray, double away) const;
    bool passes_step(const Ray& ray) const;
    bool passes_opening(const Ray& ray) const;
    void classify_odd(const Ray& ray, std::size_t hits, ClosureCounts& counts) const;
    bool leaves(const Hit& hit, const Ray& ray) const;
    bool in_order(const std::vector<Hit>& hits, const Ray& ray) const;
    void report(const char* what, const Ray& ray) const;

    SurfaceModel model_;
    Tracer tracer_;
    double size_ = 0;        ///< mm
    double widest_seam_ = 0; ///< mm
    std::vector<BorderCurve> borders_;
    std::optional<EdgePoint> edge_point(const BorderCurve& border, double t) const;
    void add_strip(const BorderCurve& border, const SeamGap& gap);

    /// Piece that spans the opening between two borders, for a step of the way along them; world.
    struct Strip {
        std::array<std::array<Vec3, 3>, 2> triangles;
        std::optional<Vec3> normal; ///< of the face beside it
        bool open = false;          ///< wider than is sealed
    };
    std::vector<Strip> strips_;
};

} // namespace keiko::test
