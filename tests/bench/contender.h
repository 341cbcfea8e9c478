#pragma once

#include "tests/bench/ray_set.h"

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace keiko::bench {

/// How rays are handed over: one a call, or 16 (Embree) or a span (Keiko) a call.
enum class Mode { single, packets };

inline const char* name_of(Mode mode) {
    return mode == Mode::single ? "single" : "packets";
}

/// Result of a contender for one ray.
struct Answer {
    double t = 0;
    Vec3 normal{0}; ///< unit, of either side
};
using Answers = std::vector<std::optional<Answer>>;

/// One set of rays made ready for one contender, to be traced over and over.
class Pass {
public:
    virtual ~Pass() = default;
    /// Makes ready for another run; not timed.
    virtual void reset() {}
    /// Traces every `stride()`-th ray; this is what is timed.
    virtual void run() = 0;
    /// Results of the last run, one a traced ray; empty for contenders that find nothing.
    virtual Answers answers() const { return {}; }
    virtual std::size_t stride() const { return 1; }
};

enum class Kind { keiko, crossings, opencascade, mesh, grid, traversal, traversal_to_hit };

/// Description of a contender, and what it cost to make.
struct ContenderFacts {
    Kind kind = Kind::keiko;
    std::string name{};
    double deflection = 0;    ///< mm, as requested
    double deviation = 0;     ///< mm, that it is off the surface, p99.9
    std::size_t elements = 0; ///< sub-patches, faces, triangles, boxes
    std::size_t bytes = 0;    ///< of all that tracing needs, the box hierarchy included
    double mesh_seconds = 0;  ///< of processor time
    double build_seconds = 0; ///< of processor time: hierarchy, or Keiko's Tracer
    std::string remark{};
    bool exact_enough = true; ///< grids: the zebra error that was looked for is reached
};

/// Something that rays can be traced against.
class Contender {
public:
    virtual ~Contender() = default;
    const ContenderFacts& facts() const { return facts_; }
    virtual std::vector<Mode> modes() const { return {Mode::single, Mode::packets}; }
    /// `rays` must outlive the pass.
    virtual std::unique_ptr<Pass> pass(const RaySet& rays, Mode mode) const = 0;

protected:
    ContenderFacts facts_;
};

} // namespace keiko::bench
