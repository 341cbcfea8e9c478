#pragma once

#include "keiko/geometry/model/repair.h"
#include "keiko/geometry/model/surface_model.h"
#include "keiko/math/bounds.h"

#include <cstdint>
#include <functional>
#include <vector>

namespace keiko::cad {

/// The repairs of one face as they are made; those of one kind become one.
class RepairLog {
public:
    /// `size` in mm; 0 where the kind has none.
    void add(RepairKind kind, double size = 0);
    /// Adds a remark of the CAD reader on the face.
    void add_remark(const std::string& words);

    /// One entry for each kind and each text of a remark, in the order of their first.
    const std::vector<Repair>& repairs() const { return repairs_; }
    /// True if nothing had to be repaired or was remarked.
    bool empty() const { return repairs_.empty(); }
    /// How many of a kind.
    std::uint32_t count(RepairKind kind) const;

private:
    std::vector<Repair> repairs_; ///< in the order of their first
};

/// A Bezier piece of a p-curve, homogeneous, in face parameters.
struct LoopCurve {
    std::vector<Vec3> points;      ///< control points, degree + 1 of them
    std::uint32_t edge = no_index; ///< of the part; none for a connector
};

/// Pieces head to tail: of one edge use, of a wire, or, closed, of a trim loop.
using Chain = std::vector<LoopCurve>;

/// The parameter plane of a face.
struct ParameterSpace {
    Vec2 period{0}; ///< by which p-curves may be moved; 0: not periodic
    Vec2 wrap{0};   ///< what a curve once around is long: the period, or the domain of a closed
                    ///< surface that is not periodic; 0: open
    Box2 natural;   ///< domain of the surface, infinite where the surface is
    double apex_v = Box2::infinity; ///< of a cone, which has no natural end there
    Vec2 scale{1};                  ///< extent of the face, for relative gaps
    /// How far, relative to `scale`, patches may be continued beyond the natural domain to follow
    /// p-curves that leave it: not at all over the pole of a sphere.
    double continuation = 0.01;
    /// A point of the surface, mm; empty: the parameter plane itself.
    std::function<Vec3(const Vec2&)> point;

    /// Size of a gap relative to the face.
    double relative(const Vec2& gap) const;
    /// Distance in mm between two places of the surface.
    double distance(const Vec2& a, const Vec2& b) const;
};

/// Begin of the first piece of a chain, which must not be empty.
Vec2 begin_of(const Chain& chain);
/// End of the last piece of a chain, which must not be empty.
Vec2 end_of(const Chain& chain);
/// Moves a chain in the parameter plane.
void shift(Chain& chain, const Vec2& offset);
/// Makes a chain run the other way: the order of its pieces, and each of them.
void reverse(Chain& chain);
/// A straight piece that belongs to no edge.
LoopCurve connector(const Vec2& from, const Vec2& to);
/// Box that holds the chain, tight to a 1e-9 part of its extent.
Box2 tight_bounds(const Chain& chain);

/// Gaps up to this part of the face's extent are rounding: left alone and not logged.
constexpr double small_gap = 1e-6;

/// The edge uses of one wire joined into chains (one as a rule). Uses a whole period away are
/// moved, except the two uses of one edge that meet at a pole, where the side along the pole is
/// missing. When the given order does not chain, the uses are sorted by their begins, and those
/// that run against the others reversed. Remaining gaps are bridged by connectors. Each repair is
/// added to `log`.
std::vector<Chain> chain_wire(std::vector<Chain> uses, const ParameterSpace& space, RepairLog& log);

/// Closed loops of a face and the rectangle of its parameters that its patches must cover.
struct ClosedLoops {
    std::vector<Chain> loops; ///< each ends where it begins
    Box2 domain;              ///< rectangle of parameters
};

/// Closes the chains of a face, one a wire, so that the even-odd rule gives its material. Chains
/// once around a periodic surface are paired to a band, or closed along the pole or border on their
/// left. Small openings are bridged. Loops are moved by whole periods to where the largest lies,
/// and doubled where they cross its border. Without chains the natural domain is the face. What was
/// done is added to `log`. Throws Error for a chain around an infinite surface that bounds nothing.
ClosedLoops close_loops(std::vector<Chain> chains, const ParameterSpace& space, RepairLog& log);

/// How many of a face's closed loops have their material on the right: outer loops that run
/// clockwise and holes that run anticlockwise. Their nesting decides which are holes.
std::size_t backward_loops(const std::vector<Chain>& loops);

} // namespace keiko::cad
