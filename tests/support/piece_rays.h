#pragma once

#include "keiko/drawing/line_body.h"
#include "keiko/scene/view.h"

#include "tests/support/drawn_body.h"
#include "tests/support/random.h"
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace keiko::test {

/// Chord error of drawings in tests, as a share of the body's size.
constexpr double usual_chord_error = LineBodyOptions().chord_error;

/// A body drawn in a view from a direction.
inline DrawnBody drawn(const SurfaceModel& model, const Vec3& towards_eye, Projection projection,
                       double chord_error = usual_chord_error) {
    const Box3 box = hull_bounds(model);
    Camera camera = frame_direction(towards_eye, box);
    camera.projection = projection;
    camera.orthographic_height = box.size();
    return {model, camera, chord_error * box.size()};
}

/// How many places of pieces of curves a ray calls otherwise than their piece, how many it does not
/// decide, and how many of these it calls otherwise where rays beside it differ.
struct RayTally {
    std::size_t places = 0, wrong = 0, undecided = 0, forgiven = 0;

    RayTally& operator+=(const RayTally& other) {
        places += other.places, wrong += other.wrong;
        undecided += other.undecided, forgiven += other.forgiven;
        return *this;
    }
};

/// Obstacle on a line of sight to a point of a curve.
enum class Sight {
    free,    ///< nothing
    hidden,  ///< a surface
    seam,    ///< a seam, whose gap the tracer closes
    unclear, ///< a surface that it only grazes, or so near that the point may lie in it
};

/// Obstacle on a line of sight, by a rule of its own. `least`: depth of the point below a surface
/// that hides it, as a share of the body's size.
inline Sight sight_of(const Vec3& point, const ModelCurve& curve, const DrawnBody& body,
                      double least = 0) {
    constexpr double itself = 1e-9, near = 1e-5, grazing = 0.01; // of the size; a cosine
    const Ray ray = body.projection.sight_line(point, 2 * body.sight.size() + 1);
    const double length = ray.direction.length();
    Sight sight = Sight::free;
    std::vector<Hit> hits = body.tracer.all(ray);
    if (const auto first = body.tracer.nearest(ray)) hits.push_back(*first); // see Tracer::nearest
    for (const Hit& hit : hits) {
        const double before = (1 - hit.t) * length / body.sight.size();
        if (before < itself) continue;
        const double cosine = std::abs(ray.direction.dot(hit.normal)) / length;
        const double below = before * cosine;
        const bool seam = has(hit.flags, HitFlags::seam);
        if (cosine > grazing && before > near && below > least &&
            below * body.sight.size() > 2 * curve.reach && !seam)
            return Sight::hidden;
        sight = seam ? Sight::seam : sight == Sight::free ? Sight::unclear : sight;
    }
    return sight;
}

/// Whether lines of sight a tenth beside of what middle_and_ends() keeps meet the same: none of
/// them a seam, and none a surface where that of the point is free. Rays along the gap of a seam
/// decide nothing.
inline bool is_steady(const Vec3& point, const ModelCurve& curve, const DrawnBody& body) {
    constexpr double beside = 2e-6; // of the size
    const bool hidden = sight_of(point, curve, body) == Sight::hidden;
    const CameraAxes& axes = body.projection.axes();
    for (const double far : {beside, 2 * beside})
        for (const Vec3& way : {axes.right, -axes.right, axes.up, -axes.up}) {
            const Vec3 place = point + way * (far * body.sight.size());
            const Sight sight = sight_of(place, curve, body, 2 * far);
            if (sight == Sight::seam) return false;
            if (sight == (hidden ? Sight::free : Sight::hidden)) return false;
        }
    return true;
}

/// Whether a point of a curve is visible, by rays.
enum class RayVerdict {
    agrees,    ///< with what was expected
    wrong,     ///< the contrary, and rays beside it do not differ
    forgiven,  ///< the contrary, but rays beside it differ: just beside an end of a piece, say,
               ///< where the curve goes behind its own face
    undecided, ///< by a seam or a surface that is unclear
};

inline RayVerdict verdict_of(const Vec3& point, const ModelCurve& curve, const DrawnBody& body,
                             bool expected) {
    const Sight sight = sight_of(point, curve, body);
    if (sight == Sight::seam || sight == Sight::unclear) return RayVerdict::undecided;
    if ((sight == Sight::free) == expected) return RayVerdict::agrees;
    return is_steady(point, curve, body) ? RayVerdict::wrong : RayVerdict::forgiven;
}

/// Places of a piece: just beside its begin, in its middle, just beside its end.
inline std::array<double, 3> middle_and_ends(const CurvePiece& piece, const ModelCurve& curve,
                                             double size) {
    constexpr double way = 2e-5; // of the body's size
    const double longest = 0.1 * (piece.end - piece.begin);
    const auto step = [&](double t) {
        return std::min(longest, way * size / curve.course.derivative(t).length());
    };
    return {piece.begin + step(piece.begin), (piece.begin + piece.end) / 2,
            piece.end - step(piece.end)};
}

/// Rays at the middle of a piece, just beside its ends, and at `more` random places between.
inline RayTally rays_along(const CurvePiece& piece, const ModelCurve& curve, const DrawnBody& body,
                           std::size_t more, Random& random) {
    const auto ends = middle_and_ends(piece, curve, body.sight.size());
    std::vector<double> places(ends.begin(), ends.end());
    for (; more > 0; --more) places.push_back(uniform(random, ends.front(), ends.back()));
    RayTally tally;
    for (const double t : places) {
        ++tally.places;
        const RayVerdict verdict = verdict_of(curve.course.at(t), curve, body, piece.visible);
        if (verdict == RayVerdict::forgiven) ++tally.forgiven;
        if (verdict == RayVerdict::forgiven || verdict == RayVerdict::undecided) ++tally.undecided;
        if (verdict != RayVerdict::wrong) continue;
        ++tally.wrong;
        ADD_FAILURE() << name_of(curve.kind) << " of face " << curve.faces[0].face << " at "
                      << curve.course.at(t) << " is not " << piece.visible << ", at " << t
                      << " of the piece from " << piece.begin << " to " << piece.end << " of "
                      << curve.course.end();
    }
    return tally;
}

/// Rays along all pieces of all curves of a view.
inline RayTally rays_along(const DrawnBody& body, std::size_t more) {
    Random random(7);
    RayTally sum;
    for (const ModelCurve* curve : body.curves())
        for (const CurvePiece& piece : pieces_by_rays(*curve, body.image.along(*curve), body.sight))
            sum += rays_along(piece, *curve, body, more, random);
    return sum;
}

} // namespace keiko::test
