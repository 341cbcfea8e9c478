#pragma once

#include "keiko/intersect/kernels/ray_packet.h"
#include "keiko/math/bounds.h"

#include <memory>
#include <span>
#include <string>
#include <vector>

namespace keiko {

/// A hierarchy of boxes under Embree, asked in double precision: for each box that a ray may
/// touch, a visitor is called. Embree works in single precision, therefore the boxes are taken
/// relative to the scene's centre and padded by what rounding can move a ray or a slab by.
class EmbreeScene {
public:
    /// Receiver of the boxes that rays may touch.
    class Visitor {
    public:
        virtual ~Visitor() = default;
        /// Called for the `box`-th box and the lanes that may touch it. It may lower
        /// RayPacket::high of these lanes and returns those whose it did; -infinity ends a lane's
        /// search.
        virtual LaneMask visit(std::uint32_t box, LaneMask lanes) = 0;
    };

    /// Throws Error when Embree cannot build, or the scene is too large for it. `threads` as in
    /// Job.
    EmbreeScene(std::span<const Box3> boxes, int threads);
    ~EmbreeScene();
    EmbreeScene(const EmbreeScene&) = delete;
    EmbreeScene& operator=(const EmbreeScene&) = delete;

    /// Visits boxes roughly front to back along the rays of a block, for s in [low, high]. The
    /// starts are in or near the ball around the boxes. A coherent block goes through as a
    /// packet. An exception of the visitor ends the search and is rethrown here, for none may
    /// cross Embree.
    void trace(const RayPacket& rays, Visitor& visitor) const;

    /// Box around all boxes, world, mm; empty without any.
    const Box3& bounds() const { return bounds_; }
    /// Middle of bounds(), or the origin without boxes.
    const Vec3& center() const { return center_; }
    /// Half the diagonal of bounds(), mm.
    double radius() const { return radius_; }

private:
    struct Handles;
    /// Relative to the centre.
    std::vector<Box3> padded(std::span<const Box3> boxes) const;

    std::unique_ptr<Handles> handles_;
    Box3 bounds_;
    Vec3 center_{0};
    double radius_ = 0;
};

/// Version of the loaded Embree: "3.13.5".
std::string embree_version();

} // namespace keiko
