#pragma once

#include "keiko/math/bounds.h"
#include "keiko/patch/ray.h"

#include <memory>
#include <span>

namespace keiko {

/// A hierarchy of boxes under Embree, asked in double precision: for each box that a ray may
/// touch, a visitor is called. Embree works in single precision, therefore the boxes are taken
/// relative to the scene's centre and padded by what rounding can move a ray or a slab by.
class EmbreeScene {
public:
    /// Answers for one box: what is the largest distance still of interest (as passed to trace
    /// when nothing was found, less after a hit, negative to stop).
    class Visitor {
    public:
        virtual ~Visitor() = default;
        virtual double visit(std::uint32_t box) = 0;
    };

    /// Throws Error when Embree cannot build. `threads` as in Job.
    EmbreeScene(std::span<const Box3> boxes, int threads);
    ~EmbreeScene();
    EmbreeScene(const EmbreeScene&) = delete;
    EmbreeScene& operator=(const EmbreeScene&) = delete;

    /// Visits boxes roughly front to back along start + s * direction, s in [0, length].
    /// `direction` is unit and `start` in or near the ball around the boxes. An exception of the
    /// visitor ends the search and is rethrown here, for none may cross Embree.
    void trace(const Vec3& start, const Vec3& direction, double length, Visitor& visitor) const;

    const Box3& bounds() const { return bounds_; }
    const Vec3& center() const { return center_; }
    double radius() const { return radius_; }

private:
    struct Handles;
    std::unique_ptr<Handles> handles_;
    Box3 bounds_;
    Vec3 center_{0};
    double radius_ = 0;
};

} // namespace keiko
