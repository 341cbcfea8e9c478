#include "keiko/trace/newton.h"

#include <algorithm>
#include <cmath>

namespace keiko {
namespace {

/// Newton is at its goal here long before; a start that needs more is a bad one.
constexpr int most_steps = 12;

} // namespace

std::optional<NewtonRoot> newton(const PlanarNet& net, const Vec2& start, const Box2& box,
                                 double slack) {
    const Vec2 leeway = box.extent() * 0.5;
    const Box2 near{box.lower - leeway, box.upper + leeway};
    Vec2 uv = start;
    for (int i = 0; i < most_steps; ++i) {
        const PlanarPoint p = evaluate(net, uv);
        const double scale = 1 / p.determinant();
        const Vec2 step((p.dv.y * p.value.x - p.dv.x * p.value.y) * scale,
                        (p.du.x * p.value.y - p.du.y * p.value.x) * scale);
        uv -= step;
        if (!near.contains(uv)) return std::nullopt;

        // What rounding of the coefficients can move the root by.
        const double blur = 2 * slack * std::abs(scale);
        const Vec2 noise(blur * (std::abs(p.dv.x) + std::abs(p.dv.y)) + 4e-16,
                         blur * (std::abs(p.du.x) + std::abs(p.du.y)) + 4e-16);
        // A step of a share s of the box leaves about C s^2 of it, where C is the change of the
        // derivatives over the box against their least value; 64 is on the safe side of any box
        // that passes the uniqueness test and is not at its edge.
        const Vec2 extent = box.extent();
        const double share = std::max(std::abs(step.x) / extent.x, std::abs(step.y) / extent.y);
        const Vec2 remaining = extent * (64 * share * share);
        if (!(remaining.x <= noise.x && remaining.y <= noise.y)) continue;

        const Vec2 error = noise + remaining;
        const Box2 grown{box.lower - error, box.upper + error};
        if (!grown.contains(uv)) return std::nullopt;
        return NewtonRoot{uv, error};
    }
    return std::nullopt;
}

} // namespace keiko
