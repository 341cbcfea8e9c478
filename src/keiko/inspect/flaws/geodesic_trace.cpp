#include "keiko/inspect/flaws/geodesic_trace.h"

#include "keiko/base/job.h"

#include <cmath>

namespace keiko {
namespace {

/// State of a trace: its place, direction and curvature.
struct Walker {
    SheetPoint at;
    SurfaceDerivatives there;
    TangentFrame frame;
    SecondForm bend;
};

std::optional<Walker> standing(const FaceAdjacency& faces, const SheetPoint& at,
                               const SurfaceDerivatives& there, const Vec3& direction,
                               const Vec3& upward, double step) {
    auto frame = faces.frame(at, there, direction);
    if (!frame) return std::nullopt;
    if (frame->z.dot(upward) < 0) frame->y *= -1, frame->z *= -1;
    constexpr double aside = 0.01; // of a step
    const auto bend = faces.bend(at, there, *frame, aside * step);
    if (!bend) return std::nullopt;
    return Walker{at, there, *frame, *bend};
}

/// The arc of a circle, projected to its tangent.
std::optional<Walker> ahead(const FaceAdjacency& faces, const Walker& from, double step) {
    const double turn = from.bend.xx * step;
    if (std::abs(turn) > 1) return std::nullopt;
    const auto at =
        faces.moved(from.frame, from.at, from.there, Vec2(step * (1 - turn * turn / 6), 0));
    if (!at) return std::nullopt;
    const auto s = faces.evaluate(*at, 2);
    if (!s) return std::nullopt;
    const Vec3 chord = (s->position() - from.frame.origin).normalized();
    const Vec3& last = from.frame.x;
    return standing(faces, *at, *s, chord * (2 * chord.dot(last)) - last, from.frame.z, step);
}

void add_border(const FaceAdjacency& faces, const Walker& from, double step,
                std::vector<WalkPoint>& points) {
    std::optional<Walker> last;
    double near = 0, far = step;
    constexpr int halvings = 6;
    for (int i = 0; i < halvings; ++i) {
        const double middle = (near + far) / 2;
        const auto next = ahead(faces, from, middle);
        (next ? near : far) = middle;
        if (next) last = next;
    }
    if (last)
        points.push_back(
            {last->at, last->frame.origin, points.back().length + near, last->bend, last->frame.z});
}

} // namespace

GeodesicTrace walk_straight(const FaceAdjacency& faces, const SheetPoint& from,
                            const Vec3& direction, double step, double reach, bool to_border) {
    GeodesicTrace walk;
    const auto start = faces.evaluate(from, 2);
    const auto frame = start ? faces.frame(from, *start, direction) : std::nullopt;
    if (!frame) return walk;
    auto walker = standing(faces, from, *start, direction, frame->z, step);
    for (int i = 0; walker; ++i) {
        check_stop();
        walk.points.push_back(
            {walker->at, walker->frame.origin, i * step, walker->bend, walker->frame.z});
        if ((i + 1) * step > reach) return walk;
        const auto next = ahead(faces, *walker, step);
        if (!next && to_border) add_border(faces, *walker, step, walk.points);
        walker = next;
    }
    walk.ended = true;
    return walk;
}

} // namespace keiko
