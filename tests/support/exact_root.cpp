#include "tests/support/exact_root.h"

#include <cmath>

namespace keiko::test {
namespace {

/// The two functions that vanish on the ray, and their derivatives, at one place.
struct Across {
    ExactPatch::Point point;
    Long f, g, f_u, f_v, g_u, g_v;

    Long determinant() const { return f_u * g_v - f_v * g_u; }
};

class Newton {
public:
    Newton(const ExactPatch& patch, const Ray& ray)
        : patch_(patch),
          origin_(lengthened(ray.origin)),
          direction_(lengthened(ray.direction).normalized()) {
        const LongVec3 helper =
            std::abs(direction_.x) < 0.6L ? LongVec3(1, 0, 0) : LongVec3(0, 1, 0);
        a_ = direction_.cross(helper).normalized();
        b_ = direction_.cross(a_);
    }

    Across across(Long u, Long v) const {
        const ExactPatch::Point p = patch_.at(u, v);
        const LongVec3 to = p.position - origin_;
        return {p, to.dot(a_), to.dot(b_), p.du.dot(a_), p.dv.dot(a_), p.du.dot(b_), p.dv.dot(b_)};
    }

    /// Parameters that move (f, g) by the given amount.
    static std::pair<Long, Long> solve(const Across& x, Long f, Long g) {
        const Long det = x.determinant();
        return {(f * x.g_v - g * x.f_v) / det, (g * x.f_u - f * x.g_u) / det};
    }

    /// How far along the surface an error of `noise` mm across the ray may move the root.
    static Long displaced(const Across& x, Long noise) {
        Long most = 0;
        for (const auto& [f, g] : {std::pair<Long, Long>{noise, 0}, {0, noise}}) {
            const auto [u, v] = solve(x, f, g);
            most += (x.point.du * u + x.point.dv * v).length();
        }
        return most;
    }

    /// Whether the functions stay regular about the root for a good deal farther than rounding
    /// moves it: then rounding cannot have made the root, nor hidden that there are two.
    bool certain(const Across& x, Long u, Long v, Long noise) const {
        constexpr Long farther = 16;
        for (const auto& [f, g] : {std::pair<Long, Long>{noise, 0}, {0, noise}}) {
            const auto [du, dv] = solve(x, farther * f, farther * g);
            for (const Long sign : {-1.0L, 1.0L}) {
                const Long there = across(u + sign * du, v + sign * dv).determinant();
                if (!(std::abs(there - x.determinant()) < std::abs(x.determinant()) / 2))
                    return false;
            }
        }
        return true;
    }

    /// Bound of the error of f and g, mm.
    Long noise(const Across& x) const {
        return patch_.rounding() + 8 * long_epsilon * (x.point.position - origin_).length();
    }

    const LongVec3& origin() const { return origin_; }
    const LongVec3& direction() const { return direction_; }

private:
    const ExactPatch& patch_;
    LongVec3 origin_, direction_, a_, b_;
};

} // namespace

std::optional<ExactRoot> exact_root(const ExactPatch& patch, const Ray& ray, const Vec2& start) {
    const Newton newton(patch, ray);
    Long u = start.x, v = start.y;
    for (int i = 0; i < 60; ++i) {
        const Across x = newton.across(u, v);
        if (!(std::abs(x.determinant()) > 0)) return std::nullopt;
        const auto [du, dv] = Newton::solve(x, x.f, x.g);
        if (!(std::abs(u - start.x) < 0.5L && std::abs(v - start.y) < 0.5L)) return std::nullopt;
        const Long noise = newton.noise(x);
        const Long error = Newton::displaced(x, noise);
        const Long step = (x.point.du * du + x.point.dv * dv).length();
        if (step <= error) {
            if (!newton.certain(x, u, v, noise)) return std::nullopt;
            const Long speed = lengthened(ray.direction).length();
            const Long sine = x.point.normal().dot(newton.direction());
            const Long along = (x.point.position - newton.origin()).dot(newton.direction());
            return ExactRoot{u, v, x.point.position, along / speed, sine, 2 * error};
        }
        u -= du;
        v -= dv;
    }
    return std::nullopt;
}

Long off_line(const Ray& ray, const LongVec3& point) {
    const LongVec3 direction = lengthened(ray.direction).normalized();
    return (point - lengthened(ray.origin)).cross(direction).length();
}

} // namespace keiko::test
