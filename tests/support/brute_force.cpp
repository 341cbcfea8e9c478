#include "tests/support/brute_force.h"

#include <cmath>

namespace keiko::test {
namespace {

struct Axes {
    Vec3 origin, a, b;
};

/// Any two directions that span the plane across the ray.
Axes across(const Ray& ray) {
    const Vec3 d = ray.direction.normalized();
    const Vec3 helper = std::abs(d.x) < 0.6 ? Vec3(1, 0, 0) : Vec3(0, 1, 0);
    const Vec3 a = d.cross(helper).normalized();
    return {ray.origin, a, d.cross(a)};
}

std::vector<Vec4> half(const std::vector<Vec4>& points, int rows, int columns, bool along_u,
                       bool first) {
    std::vector<Vec4> result = points;
    const int n = along_u ? rows : columns, lines = along_u ? columns : rows;
    for (int line = 0; line < lines; ++line) {
        const auto at = [&](int i) -> Vec4& {
            return result[static_cast<std::size_t>(along_u ? i * columns + line
                                                           : line * columns + i)];
        };
        for (int level = 1; level < n; ++level) {
            if (first)
                for (int i = n - 1; i >= level; --i) at(i) = (at(i - 1) + at(i)) * 0.5;
            else
                for (int i = 0; i + level < n; ++i) at(i) = (at(i) + at(i + 1)) * 0.5;
        }
    }
    return result;
}

class Search {
public:
    Search(const BezierPatchView& patch, const Ray& ray) : patch_(patch), axes_(across(ray)) {
        descend({patch.points.begin(), patch.points.end()}, {Vec2(0), Vec2(1)}, 0);
    }
    std::vector<Vec2> roots;

private:
    void descend(const std::vector<Vec4>& points, const Box2& box, int depth) {
        Box2 seen;
        for (const Vec4& p : points) seen.extend(seen_from_ray(Vec3(p.x, p.y, p.z) / p.w));
        if (!seen.padded(1e-9).contains(Vec2(0))) return;
        if (depth == 20) return refine(box);
        const bool along_u = depth % 2 == 0;
        Box2 low = box, high = box;
        const unsigned axis = along_u ? 0 : 1;
        low.upper[axis] = high.lower[axis] = box.center()[axis];
        const int rows = patch_.degree_u + 1, columns = patch_.degree_v + 1;
        descend(half(points, rows, columns, along_u, true), low, depth + 1);
        descend(half(points, rows, columns, along_u, false), high, depth + 1);
    }

    Vec2 seen_from_ray(const Vec3& p) const {
        const Vec3 v = p - axes_.origin;
        return {v.dot(axes_.a), v.dot(axes_.b)};
    }

    void refine(const Box2& box) {
        Vec2 uv = box.center();
        for (int i = 0; i < 20; ++i) {
            const SurfaceDerivatives s = evaluate(patch_, uv, 1);
            const Vec2 f = seen_from_ray(s.position());
            const Vec2 du(s.du().dot(axes_.a), s.du().dot(axes_.b));
            const Vec2 dv(s.dv().dot(axes_.a), s.dv().dot(axes_.b));
            const double det = du.x * dv.y - du.y * dv.x;
            if (!(std::abs(det) > 0)) return;
            uv -= Vec2(f.x * dv.y - f.y * dv.x, du.x * f.y - du.y * f.x) / det;
            if (!box.padded(0.01).contains(uv)) return;
        }
        const bool inside = Box2{Vec2(0), Vec2(1)}.contains(uv);
        if (!inside || !(seen_from_ray(evaluate(patch_, uv, 0).position()).length() < 1e-9)) return;
        for (const Vec2& known : roots)
            if ((known - uv).length() < 1e-6) return;
        roots.push_back(uv);
    }

    BezierPatchView patch_;
    Axes axes_;
};

} // namespace

std::vector<Vec2> brute_force_roots(const BezierPatchView& patch, const Ray& ray) {
    return Search(patch, ray).roots;
}

} // namespace keiko::test
