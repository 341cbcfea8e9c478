#include "keiko/inspect/structure/loop_crossings.h"

#include "keiko/geometry/bernstein/de_casteljau.h"
#include "keiko/geometry/bvh/box_tree.h"
#include "keiko/inspect/structure/curve_crossings.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>

namespace keiko {
namespace {

/// A piece of a p-curve that runs one way along its chord, so that it does not cross itself.
struct LoopPiece {
    std::size_t loop = 0, curve = 0; ///< numbers, of the face and of the loop
    double begin = 0, end = 1;       ///< parameters of the curve
    std::vector<Vec3> points;

    Box3 box() const {
        const Box2 flat = hull_bounds(BezierCurveView{points});
        return {Vec3(flat.lower.x, flat.lower.y, 0), Vec3(flat.upper.x, flat.upper.y, 0)};
    }
    /// A line square to the chord meets the curve no more often than its control polygon.
    bool runs_one_way() const {
        const auto at = [&](std::size_t i) { return Vec2(points[i].x, points[i].y) / points[i].z; };
        const Vec2 chord = at(points.size() - 1) - at(0);
        for (std::size_t i = 0; i + 1 < points.size(); ++i)
            if (!((at(i + 1) - at(i)).dot(chord) >= 0)) return false;
        return true;
    }
};

void add_pieces(LoopPiece piece, int depth, std::vector<LoopPiece>& pieces) {
    constexpr int most_depth = 8;
    if (depth == most_depth || piece.runs_one_way()) {
        pieces.push_back(std::move(piece));
        return;
    }
    const auto parts = bernstein_parts(piece.points);
    const double middle = (piece.begin + piece.end) / 2;
    add_pieces({piece.loop, piece.curve, piece.begin, middle, parts[0]}, depth + 1, pieces);
    add_pieces({piece.loop, piece.curve, middle, piece.end, parts[1]}, depth + 1, pieces);
}

/// Ways along a loop, mm, by polylines.
class LoopWays {
public:
    LoopWays(const BoundaryCurves& curves, const std::vector<BoundaryInterval>& loop) {
        for (const BoundaryInterval& border : loop) {
            const SurfaceCurve curve = curves.curve(border);
            Vec3 last = curve.at(0).position;
            for (std::size_t k = 0; k < steps; ++k) {
                ways_.push_back(length_);
                const Vec3 next = curve.at(double(k + 1) / steps).position;
                length_ += (next - last).length(), last = next;
            }
        }
        ways_.push_back(length_);
    }
    double length() const { return length_; }
    /// mm from the begin of the loop to a place of a curve.
    double at(std::size_t curve, double t) const {
        const double place = std::clamp(t, 0.0, 1.0) * steps;
        const std::size_t step = std::min<std::size_t>(static_cast<std::size_t>(place), steps - 1);
        const std::size_t i = curve * steps + step;
        return ways_[i] + (ways_[i + 1] - ways_[i]) * (place - static_cast<double>(step));
    }
    /// mm between two places by the shorter way round.
    double between(double a, double b) const {
        const double way = std::abs(a - b);
        return std::min(way, length_ - way);
    }

private:
    static constexpr std::size_t steps = 16;

    std::vector<double> ways_;
    double length_ = 0;
};

class LoopSearch {
public:
    LoopSearch(const ModelBorders& borders, const Loops& loops) : borders_(borders), loops_(loops) {
        for (std::size_t k = 0; k < loops.size(); ++k) {
            ways_.emplace_back(borders.curves, loops[k]);
            for (std::size_t i = 0; i < loops[k].size(); ++i) {
                const BezierCurveView curve = borders.model.trim_curve(loops[k][i].curve);
                add_pieces({k, i, 0, 1, {curve.points.begin(), curve.points.end()}}, 0, pieces_);
            }
        }
    }

    std::optional<LoopCrossing> largest(double least) {
        find_crossings(least);
        std::optional<LoopCrossing> largest;
        for (const Crossing& crossing : crossings_) {
            const double length = length_of(crossing);
            if (!(length > least) || (largest && length <= largest->length)) continue;
            const Place& at = crossing.places[0];
            const SurfaceCurve curve = borders_.curves.curve(loops_[at.loop][at.curve]);
            largest = LoopCrossing{.length = length,
                                   .of_two_loops = crossing.places[1].loop != at.loop,
                                   .unknown = false,
                                   .place = curve.at(std::clamp(at.t, 0.0, 1.0)).position};
        }
        return largest ? largest : unknown_;
    }

private:
    struct Place {
        std::size_t loop, curve;
        double t, way; ///< parameter, and mm along the loop
    };
    struct Crossing {
        Place places[2];
    };

    Place place(const LoopPiece& piece, double s) const {
        const double t = piece.begin + (piece.end - piece.begin) * s;
        return {piece.loop, piece.curve, t, ways_[piece.loop].at(piece.curve, t)};
    }

    LoopCrossing unknown_at(const LoopPiece& a, const LoopPiece& b) const {
        const SurfaceCurve curve = borders_.curves.curve(loops_[a.loop][a.curve]);
        return {.length = 0,
                .of_two_loops = a.loop != b.loop,
                .unknown = true,
                .place = curve.at((a.begin + a.end) / 2).position};
    }

    void find_crossings(double least) {
        std::vector<Box3> boxes;
        for (const LoopPiece& piece : pieces_) boxes.push_back(piece.box());
        const BoxTree tree(boxes);
        for (std::size_t i = 0; i < pieces_.size(); ++i)
            for (const std::uint32_t k : tree.overlapping(boxes[i])) {
                if (k <= i) continue;
                const LoopPiece &a = pieces_[i], &b = pieces_[k];
                const CurveCrossings crossings = curve_crossings({a.points}, {b.points});
                if (!crossings.complete && !unknown_) unknown_ = unknown_at(a, b);
                for (const CurveCrossing& at : crossings.found) {
                    const Place p = place(a, at.a), q = place(b, at.b);
                    const bool same = p.loop == q.loop;
                    if (same && ways_[p.loop].between(p.way, q.way) <= least) continue;
                    if (passes_through(p, q)) crossings_.push_back({{p, q}});
                }
            }
    }

    /// Directions in which a loop leaves one of its places, backwards and forwards.
    std::array<Vec2, 2> branches(const Place& at) const {
        const std::vector<BoundaryInterval>& loop = loops_[at.loop];
        constexpr double end = 1e-7; // of a curve's parameter
        const std::size_t count = loop.size();
        const bool first = at.t<end, last = at.t> 1 - end;
        const auto derivative = [&](std::size_t curve, double t) {
            return evaluate(borders_.model.trim_curve(loop[curve % count].curve), t, 1)[1];
        };
        const double t = std::clamp(at.t, 0.0, 1.0);
        const Vec2 in = first ? derivative(at.curve + count - 1, 1) : derivative(at.curve, t);
        const Vec2 out = last ? derivative(at.curve + 1, 0) : derivative(at.curve, t);
        return {in * -1.0, out};
    }

    /// True if the branches of one place lie on both sides of those of the other. Loops that meet
    /// in a corner may touch alone.
    bool passes_through(const Place& p, const Place& q) const {
        const std::array<Vec2, 2> own = branches(p), other = branches(q);
        const auto angle_from_own = [&](const Vec2& way) {
            const double angle = std::atan2(own[0].x * way.y - own[0].y * way.x, own[0].dot(way));
            return angle < 0 ? angle + 2 * std::numbers::pi : angle;
        };
        const double across = angle_from_own(own[1]);
        const double a = angle_from_own(other[0]), b = angle_from_own(other[1]);
        constexpr double touching = 1e-7; // radians
        for (const double angle : {a, b})
            if (std::min({angle, std::abs(angle - across), 2 * std::numbers::pi - angle}) <
                touching)
                return false;
        return (a < across) != (b < across);
    }

    double length_of(const Crossing& crossing) const {
        const Place &p = crossing.places[0], &q = crossing.places[1];
        if (p.loop == q.loop) return ways_[p.loop].between(p.way, q.way);
        double nearest = ways_[p.loop].length();
        for (const Crossing& other : crossings_) {
            const Place& at = other.places[0];
            if (at.loop != p.loop || other.places[1].loop != q.loop || &other == &crossing)
                continue;
            nearest = std::min(nearest, ways_[p.loop].between(at.way, p.way));
        }
        return nearest;
    }

    const ModelBorders& borders_;
    const Loops& loops_;
    std::vector<LoopWays> ways_;
    std::vector<LoopPiece> pieces_;
    std::vector<Crossing> crossings_;
    std::optional<LoopCrossing> unknown_; ///< the first
};

} // namespace

std::optional<LoopCrossing> loop_crossing(const ModelBorders& borders, const Loops& loops,
                                          double least) {
    return LoopSearch(borders, loops).largest(least);
}

} // namespace keiko
