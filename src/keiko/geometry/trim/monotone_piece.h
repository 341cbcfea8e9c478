#pragma once

#include "keiko/base/export.h"
#include "keiko/geometry/bezier/bezier.h"

#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

namespace KEIKO_API keiko {

/// A stretch of a plane Bezier curve along which x and y each only rise or only fall. Its box is
/// the box of its two ends; this also holds for each of its own stretches.
class MonotonePiece {
public:
    /// Homogeneous control points over [begin, end] of the curve `curve`.
    MonotonePiece(std::vector<Vec3> points, std::uint32_t curve, double begin, double end);

    /// The point at t = 0.
    const Vec2& first() const { return first_; }
    /// The point at t = 1.
    const Vec2& last() const { return last_; }
    /// Box of the piece.
    const Box2& box() const { return box_; }
    /// Index the piece was made with, e.g. into SurfaceModel::trim_curves.
    std::uint32_t curve() const { return curve_; }
    /// Parameter of the whole curve at this piece's parameter t in [0, 1].
    double curve_parameter(double t) const { return begin_ + t * (end_ - begin_); }

    /// Point at this piece's parameter t in [0, 1].
    Vec2 point(double t) const;
    /// Bounds of the magnitudes of the second derivatives of x and of y by t; infinite where a
    /// weight is not positive.
    const Vec2& bend() const { return bend_; }
    /// True if the ray from `p` towards +x crosses the piece. An end at exactly p.y belongs to the
    /// side above, so that a closed chain is crossed an odd or an even number of times for any p.
    bool crossed_from(const Vec2& p) const;
    /// Crossings of the piece with the line on which coordinate `axis` (0 is x, 1 is y) is `at`, to
    /// rounding: the other coordinate. If the piece runs along the line, both of its ends.
    std::vector<double> crossings(unsigned axis, double at) const;
    /// True if any point of the piece lies in the box.
    bool touches(const Box2& box) const;
    /// Parameters t, from the lower to the upper, between which the piece lies in the box, to
    /// rounding; nullopt if it does not touch it.
    std::optional<std::pair<double, double>> stretch_in(const Box2& box) const;
    /// False for boxes beside the strip along its chord that holds the control points: it touches
    /// none of them. Much faster.
    bool may_touch(const Box2& box) const;

private:
    /// Signed distance of a place, relative to the first end, from the chord's line, times the
    /// chord's length.
    double beside_chord(const Vec2& place) const;
    /// The largest difference of this distance between two places that are `size` apart.
    double across(const Vec2& size) const;
    void find_strip();
    void find_bend();
    /// A stretch [a, b] (in either order) with its ends' points.
    struct Bracket {
        double a, b;
        Vec2 at_a, at_b;
    };
    /// Brackets the place where coordinate `axis` is `at`, which must lie between the ends. It ends
    /// when t is known to rounding, or when the bracket decides the side of the piece for a place
    /// there whose other coordinate is `beside`.
    template <unsigned axis>
    Bracket bracket(double at, double beside) const;
    /// Narrows [from, to] to where coordinate `axis` lies between `lower` and `upper`, which the
    /// ends do not both lie below or above.
    template <unsigned axis>
    void narrow(double lower, double upper, double& from, double& to) const;

    std::vector<Vec3> points_;
    std::vector<double> binomials_; ///< one a point
    Vec2 first_, last_;
    Box2 box_;
    Vec2 bend_{0};
    double strip_low_ = 0, strip_high_ = 0; ///< beside_chord() of the control points
    std::uint32_t curve_;
    double begin_, end_;
};

/// The curve cut at every extremum of x and y. Neighbours share their end point bit for bit.
std::vector<MonotonePiece> monotone_pieces(const BezierCurveView& curve, std::uint32_t index);

} // namespace keiko
