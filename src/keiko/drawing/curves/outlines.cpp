#include "keiko/drawing/curves/outlines.h"

#include "keiko/inspect/lines/contour_curves.h"

#include <memory>
#include <utility>

namespace keiko {
namespace {

/// The normal at a point of a contour, times the normal curvature along the line of sight, by any
/// factor: it points to where the surface bends.
Vec3 bend(const SurfaceDerivatives& s, const Vec3& sight) {
    const Vec3 normal = s.d[1][0].cross(s.d[0][1]);
    const double area2 = normal.length2();
    if (!(area2 > 0)) return Vec3(0);
    const double a = sight.cross(s.d[0][1]).dot(normal) / area2;
    const double b = s.d[1][0].cross(sight).dot(normal) / area2;
    return normal * (normal.dot(s.d[2][0]) * a * a + 2 * normal.dot(s.d[1][1]) * a * b +
                     normal.dot(s.d[0][2]) * b * b);
}

/// The exact contour: its points, vertices at its cusps among them, and what is between.
struct ExactContour {
    const SurfaceModel& model;
    PatchContour contour;
    LineEye eye;

    LinePoint between(std::size_t i, double share) const {
        const LinePoint &a = contour.line.points[i], &b = contour.line.points[i + 1];
        if (share <= 0) return a;
        if (share >= 1) return b;
        const auto exact = contour.function->between(a, b, share);
        return exact
                   ? *exact
                   : LinePoint{a.uv + (b.uv - a.uv) * share, a.place + (b.place - a.place) * share};
    }
    Vec3 bend_at(const LinePoint& point) const {
        return bend(placed_derivatives(model, contour.instance, contour.patch, point.uv),
                    eye.towards(point.place));
    }
    /// The last point before the bend changes sides on the way to a later one.
    LinePoint cusp(LinePoint before, LinePoint after) const {
        constexpr int halvings = 45;
        const Vec3 side = bend_at(before);
        for (int i = 0; i < halvings; ++i) {
            const auto middle = contour.function->between(before, after, 0.5);
            if (!middle) break;
            (bend_at(*middle).dot(side) < 0 ? after : before) = *middle;
        }
        return before;
    }
};

/// Adds vertices at the cusps, and returns their parameters.
std::vector<double> add_cusps(ExactContour& exact) {
    std::vector<double> cusps;
    std::vector<LinePoint> points;
    Vec3 last(0);
    for (const LinePoint& point : exact.contour.line.points) {
        const Vec3 bend = exact.bend_at(point);
        if (bend.dot(last) < 0) {
            cusps.push_back(static_cast<double>(points.size()));
            points.push_back(exact.cusp(points.back(), point));
        }
        points.push_back(point);
        last = bend;
    }
    exact.contour.line.points = std::move(points);
    return cusps;
}

void add_outline(const std::shared_ptr<ExactContour>& exact, Outlines& outlines) {
    const std::vector<double> cusps = add_cusps(*exact);
    CurveCourse course;
    for (const LinePoint& point : exact->contour.line.points) course.points.push_back(point.place);
    course.between = [exact](std::size_t i, double share) {
        return exact->between(i, share).place;
    };
    const PlacedFace face{exact->contour.instance, exact->contour.face};
    outlines.curves.push_back({CurveKind::outline, course, {face}, 0, cusps});
    outlines.occluding.push_back({face, 2, std::move(course), [exact](std::size_t i, double share) {
                                      return exact->bend_at(exact->between(i, share));
                                  }});
}

} // namespace

Outlines find_outlines(const SurfaceModel& model, const LineEye& eye, double chord_error,
                       const Job& job) {
    Outlines outlines;
    for (PatchContour& contour : patch_contours(model, eye, chord_error, job))
        add_outline(std::make_shared<ExactContour>(ExactContour{model, std::move(contour), eye}),
                    outlines);
    return outlines;
}

} // namespace keiko
