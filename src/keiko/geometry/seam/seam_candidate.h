#pragma once

#include "keiko/base/units.h"
#include "keiko/geometry/seam/border_run.h"
#include "keiko/math/vec.h"

#include <array>
#include <cmath>
#include <cstdint>
#include <span>
#include <vector>

namespace keiko {

// Stretches along which borders face each other, and which of them are seams.

/// Two points of two borders that face each other.
struct FacingPoints {
    double t = 0, s = 0;  ///< on the first and on the second border
    double distance = 0;  ///< mm
    bool overlap = false; ///< one of them lies on the other's material: no gap, a sliver's far side
};

/// A maximal stretch along which two borders face each other within the join distance and run
/// alike.
struct Stretch {
    std::vector<FacingPoints> points; ///< at least two; t strictly rising, s rising or falling so
};

/// All stretches of `a` along `b`. Ends are exact: an end of either curve, or the place where the
/// distance passes `join` mm.
std::vector<Stretch> stretches_alongside(const Border& a, const Border& b, double join);

/// Share of the join distance below which distances do not distinguish two candidates.
constexpr double indistinct_share = 1e-3;

/// Radians: a seam that turns by more than this has a corner, where another seam begins.
constexpr double seam_corner = degrees_to_radians(30);

/// True if a line that changes from one direction to another turns a corner; false if one of them
/// is 0.
inline bool is_corner(const Vec3& before, const Vec3& after) {
    static const double cosine = std::cos(seam_corner);
    return before.dot(after) < cosine * before.length() * after.length();
}

/// A stretch and the two borders that it joins; border a is the earlier.
struct SeamCandidate {
    std::uint32_t a = 0;     ///< number of border a
    std::uint32_t b = 0;     ///< number of border b, greater than a
    Stretch stretch;         ///< t on border a, s on border b
    bool is_slender = false; ///< much longer than it is wide; else a touch of two corners
    bool is_narrow = false;  ///< both are borders of one face, which is narrow between them
};

/// The facing points that another candidate provides along a stretch of one border.
struct SeamOffer {
    const SeamCandidate* candidate; ///< the other candidate
    bool as_a;                      ///< the border is its border a, else its border b

    /// The parameter of facing points on the border.
    double parameter(const FacingPoints& p) const { return as_a ? p.t : p.s; }
};

/// Distance of two points by which candidates compete: a far side of a sliver faces the neighbour
/// across the sliver's own material, which counts more.
double cost(const FacingPoints& p);
/// True if a length is much larger than a width.
constexpr bool slender(double length, double width) {
    constexpr double slenderness = 4;
    return length >= slenderness * width;
}
/// Cost of an offer at a parameter of its border, or infinity beyond its ends.
double cost_at(const SeamOffer& offer, double x);
/// Distance in mm of an offer at a parameter of its border, only where material lies between;
/// otherwise infinity.
double width_at(const SeamOffer& offer, double x);

/// A stretch of two borders that may be a seam, or a part of one: files may cut borders into any
/// number of curves, and a partner's border may end in the middle of others.
struct SeamPiece {
    /// Begin or end on one of its borders, and the outward direction there.
    struct Tip {
        Vec3 position{0}; ///< world, mm
        Vec3 onward{0};   ///< away from the piece, of any length
    };
    /// Instance and face of either side.
    std::array<std::uint32_t, 4> faces{};
    std::array<std::array<Tip, 2>, 2> ends{}; ///< the first and the last, on both borders
    double length = 0;                        ///< mm, along the shorter border
    bool same_direction = true;               ///< of both borders, in the order of their loops
    double widest = 0;                        ///< mm between the borders
    bool fills_border = false; ///< almost the whole of the shorter border, of two faces or of one
                               ///< that the file closes there

    /// True if both borders are of one placed face.
    bool is_of_one_face() const { return faces[0] == faces[2] && faces[1] == faces[3]; }
};

/// Seams among the pieces, one flag a piece. A seam is longer than it is wide, and longer than
/// `join` mm or as long as a whole border; borders of two faces that touch need a fifth of `join`.
/// A scrap is a seam together with those that continue it at its ends, of the same faces or of the
/// next ones. It also is one where it fills the hole between two seams of its faces. The result
/// thus does not depend on how a border is cut into curves, nor on its teeth. Where a border turns
/// back, as in the hooks of careless trims, nothing continues it.
std::vector<bool> seams_among(std::span<const SeamPiece> pieces, double join);

} // namespace keiko
