#include "keiko/inspect/structure/curve_crossings.h"

#include "keiko/geometry/bernstein/de_casteljau.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace keiko {
namespace {

/// A piece of a curve over a range of its parameter.
struct Piece {
    std::vector<Vec3> points;
    double begin = 0, end = 1;

    Vec2 first() const { return Vec2(points.front().x, points.front().y) / points.front().z; }
    Vec2 last() const { return Vec2(points.back().x, points.back().y) / points.back().z; }
    Box2 box() const { return hull_bounds(BezierCurveView{points}); }
    std::array<Piece, 2> halves() const {
        const auto parts = bernstein_parts(points);
        const double middle = (begin + end) / 2;
        return {Piece{{parts[0].begin(), parts[0].end()}, begin, middle},
                Piece{{parts[1].begin(), parts[1].end()}, middle, end}};
    }
};

/// True if the control points leave the chord by no more than a hundredth of it, in its direction
/// too.
bool is_straight(const Piece& piece) {
    const Vec2 from = piece.first(), chord = piece.last() - from;
    const double square = chord.dot(chord);
    if (!(square > 0)) return false;
    return std::all_of(piece.points.begin(), piece.points.end(), [&](const Vec3& p) {
        const Vec2 off = Vec2(p.x, p.y) / p.z - from;
        constexpr double share = 0.01;
        const double along = off.dot(chord) / square;
        return std::abs(chord.cross(off)) <= share * square && along > -share && along < 1 + share;
    });
}

class CrossingSearch {
public:
    CrossingSearch(const BezierCurveView& a, const BezierCurveView& b) : a_(a), b_(b) {}

    CurveCrossings run() {
        search({{a_.points.begin(), a_.points.end()}}, {{b_.points.begin(), b_.points.end()}}, 0);
        return std::move(found_);
    }

private:
    void search(const Piece& a, const Piece& b, int depth) {
        constexpr std::size_t most_tests = 4000;
        if (!a.box().overlaps(b.box())) return;
        if (++tests_ > most_tests) {
            found_.complete = false;
            return;
        }
        const bool straight_a = is_straight(a), straight_b = is_straight(b);
        if (straight_a && straight_b) return try_crossing(a, b);
        constexpr int most_depth = 60;
        if (depth == most_depth) return;
        const bool cut_a = !straight_a && (straight_b || a.box().size() >= b.box().size());
        for (const Piece& half : (cut_a ? a : b).halves())
            cut_a ? search(half, b, depth + 1) : search(a, half, depth + 1);
    }

    /// Adds the crossing of two nearly straight pieces if they have one.
    void try_crossing(const Piece& a, const Piece& b) {
        double s = (a.begin + a.end) / 2, t = (b.begin + b.end) / 2;
        constexpr int steps = 12;
        for (int k = 0; k < steps; ++k) {
            const auto p = evaluate(a_, s, 1), q = evaluate(b_, t, 1);
            const double determinant = p[1].cross(q[1]);
            // Parallel curves touch or lie on each other.
            if (!(std::abs(determinant) > 1e-7 * p[1].length() * q[1].length())) return;
            const Vec2 gap = q[0] - p[0];
            s += gap.cross(q[1]) / determinant, t += gap.cross(p[1]) / determinant;
            if (!(s >= -1 && s <= 2 && t >= -1 && t <= 2)) return;
        }
        // A crossing on the border of two pieces is found by both.
        constexpr double shared = 1e-9;
        if (!(s >= a.begin - shared && s <= a.end + shared && t >= b.begin - shared &&
              t <= b.end + shared))
            return;
        const Vec2 rest = evaluate(a_, s, 0)[0] - evaluate(b_, t, 0)[0];
        if (!(rest.length() <= 1e-9 * (a.box().size() + b.box().size()))) return;
        found_.found.push_back({s, t});
    }

    BezierCurveView a_, b_;
    std::size_t tests_ = 0;
    CurveCrossings found_;
};

} // namespace

CurveCrossings curve_crossings(const BezierCurveView& a, const BezierCurveView& b) {
    return CrossingSearch(a, b).run();
}

} // namespace keiko
