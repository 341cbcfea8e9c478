#pragma once

#include "keiko/geometry/model/surface_model.h"
#include "keiko/intersect/traversal/tracer.h"

#include "tests/bench/contender.h"

#include <memory>

namespace keiko::bench {

/// Keiko's Tracer, one ray or 1024 rays (a tile of a picture) a call, whole hits out.
class KeikoContender : public Contender {
public:
    explicit KeikoContender(const SurfaceModel& model);
    std::unique_ptr<Pass> pass(const RaySet& rays, Mode mode) const override;

    const Tracer& tracer() const { return tracer_; }
    /// The Tracer's own count leaves out its box hierarchy, which Embree holds.
    void add_hierarchy(std::size_t bytes) { facts_.bytes += bytes; }

private:
    Tracer tracer_;
};

/// Keiko's Tracer stopped before it evaluates hits (t and parameters only), which is what a
/// triangle tracer's hit is.
class CrossingContender : public Contender {
public:
    /// `tracer` must outlive this.
    explicit CrossingContender(const Tracer& tracer);
    std::unique_ptr<Pass> pass(const RaySet& rays, Mode mode) const override;

private:
    const Tracer& tracer_;
};

} // namespace keiko::bench
