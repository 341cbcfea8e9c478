#include "keiko/inspect/lines/line_inflections.h"

#include "keiko/inspect/basics/placed_face.h"

#include <cmath>

namespace keiko {
namespace {

/// A place of the line and its curvature there.
struct Bent {
    LinePoint at;
    double bend = 0;
};

/// The place of the line next to parameters of the patch, by steps across it.
std::optional<Bent> on_line(const SurfaceModel& model, const SurfaceLine& piece,
                            const LampLevels& lamps, Vec2 uv) {
    constexpr int most_steps = 10;
    constexpr double close = 1e-10; // mm
    for (int i = 0; i < most_steps; ++i) {
        const SurfaceDerivatives s = placed_derivatives(model, piece.instance, piece.patch, uv);
        const auto course = line_course(lamps.field, lamps.level(piece.lamp), s);
        if (!course) return std::nullopt;
        const double off = -course->value / course->density;
        if (std::abs(off) < close || i + 1 == most_steps)
            return Bent{{uv, s.position()}, course->bend};
        const Vec3 step = course->left() * off;
        const double uu = s.du().length2(), uv_ = s.du().dot(s.dv()), vv = s.dv().length2();
        const double along_u = s.du().dot(step), along_v = s.dv().dot(step);
        const double area = uu * vv - uv_ * uv_;
        uv += Vec2(along_u * vv - along_v * uv_, along_v * uu - along_u * uv_) / area;
    }
    return std::nullopt;
}

} // namespace

LineInflection inflection_between(const SurfaceModel& model, const SurfaceLine& piece,
                                  const LampLevels& lamps, const LinePoint& before,
                                  const LinePoint& behind) {
    auto near = on_line(model, piece, lamps, before.uv),
         far = on_line(model, piece, lamps, behind.uv);
    LinePoint found = before;
    constexpr int halvings = 45;
    for (int i = 0; near && far && i < halvings; ++i) {
        const auto middle = on_line(model, piece, lamps, (near->at.uv + far->at.uv) / 2);
        if (!middle) break;
        found = middle->at;
        (middle->bend * near->bend > 0 ? near : far) = middle;
    }
    return {(found.place - before.place).length(), found.place};
}

} // namespace keiko
