#include "keiko/inspect/overlaps/sheet_approach.h"

#include "keiko/base/units.h"
#include "keiko/geometry/bezier/differential_geometry.h"
#include "keiko/geometry/bezier/subpatch.h"

#include <algorithm>

namespace keiko {
namespace {

/// A place of a part that moves within it.
struct Place {
    const FaceSheet::Part* part;
    Vec2 uv;
    SurfaceDerivatives s;

    explicit Place(const FaceSheet::Part& of) : part(&of) { move_to(of.uv.center()); }

    void move_to(const Vec2& to) {
        uv = Vec2(std::clamp(to.x, part->uv.lower.x, part->uv.upper.x),
                  std::clamp(to.y, part->uv.lower.y, part->uv.upper.y));
        s = evaluate(part->view, uv, 1);
    }
    /// The tangent by `axis`, mm over the whole part.
    Vec3 tangent(unsigned axis) const {
        return (axis == 0 ? s.du() : s.dv()) * part->uv.extent()[axis];
    }
    void step(const Vec2& by) { move_to(uv + by * part->uv.extent()); }
};

/// The shortest step of both places that takes `gap` away, to first order: with J the tangents of a
/// and less those of b, J^T x where J J^T x = -gap. Parallel tangent planes make J J^T singular, so
/// that a small multiple of the unit matrix is added.
Vec3 multiplier(const Place& a, const Place& b, const Vec3& gap) {
    Vec3 rows[3] = {Vec3(0), Vec3(0), Vec3(0)};
    for (const Place* place : {&a, &b})
        for (const unsigned axis : {0U, 1U}) {
            const Vec3 t = place->tangent(axis);
            for (unsigned k = 0; k < 3; ++k) rows[k] += t * t[k];
        }
    const double damping = 1e-6 * (rows[0].x + rows[1].y + rows[2].z) + 1e-300;
    for (unsigned k = 0; k < 3; ++k) rows[k][k] += damping;
    const double determinant = rows[0].dot(rows[1].cross(rows[2]));
    // Cramer's rule; the matrix is symmetric.
    return (rows[1].cross(rows[2]) * -gap.x + rows[2].cross(rows[0]) * -gap.y +
            rows[0].cross(rows[1]) * -gap.z) /
           determinant;
}

double gap_of(const Place& a, const Place& b) {
    return (a.s.position() - b.s.position()).length();
}

void approach_by_newton(Place& a, Place& b) {
    constexpr int steps = 10;
    for (int k = 0; k < steps; ++k) {
        const Vec3 x = multiplier(a, b, a.s.position() - b.s.position());
        const Place last_a = a, last_b = b;
        a.step({a.tangent(0).dot(x), a.tangent(1).dot(x)});
        b.step({-last_b.tangent(0).dot(x), -last_b.tangent(1).dot(x)});
        if (gap_of(a, b) < gap_of(last_a, last_b)) continue;
        a = last_a, b = last_b;
        return;
    }
}

void move_to_foot(Place& place, const Vec3& p) {
    const std::vector<Vec4> points = subpatch(place.part->view, place.part->uv);
    const BezierPatchView piece{place.part->view.degree_u, place.part->view.degree_v, points};
    const PieceProjection foot = piece_projection(piece, p);
    place.move_to(place.part->uv.lower + place.part->uv.extent() * foot.uv);
}

void approach_in_turn(Place& a, Place& b) {
    constexpr int steps = 4;
    for (int k = 0; k < steps; ++k) {
        const Place last_a = a, last_b = b;
        move_to_foot(b, a.s.position());
        move_to_foot(a, b.s.position());
        if (gap_of(a, b) < gap_of(last_a, last_b)) continue;
        a = last_a, b = last_b;
        return;
    }
}

double angle_between_planes(const Place& a, const Place& b) {
    const Vec3 n = a.s.du().cross(a.s.dv()), m = b.s.du().cross(b.s.dv());
    if (!(n.length() > 0 && m.length() > 0)) return 0;
    const double angle = radians_to_degrees(angle_between(n, m));
    return std::min(angle, 180 - angle);
}

} // namespace

SheetApproach sheet_approach(const FaceSheet::Part& a, const FaceSheet::Part& b) {
    Place at_a(a), at_b(b);
    approach_by_newton(at_a, at_b);
    const double rounding = 1e-9; // mm: they share the place
    if (gap_of(at_a, at_b) > rounding) approach_in_turn(at_a, at_b);
    return {at_a.uv, at_b.uv, gap_of(at_a, at_b), angle_between_planes(at_a, at_b),
            (at_a.s.position() + at_b.s.position()) / 2};
}

} // namespace keiko
