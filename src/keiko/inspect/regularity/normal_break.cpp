#include "keiko/inspect/regularity/normal_break.h"

#include "keiko/base/units.h"

#include <algorithm>
#include <cmath>

namespace keiko {
namespace {

constexpr double fold = 175; ///< degrees

double degrees_between(const Vec3& a, const Vec3& b) {
    return radians_to_degrees(angle_between(a, b));
}

Vec2 clamped(const Vec2& uv) {
    return {std::clamp(uv.x, 0.0, 1.0), std::clamp(uv.y, 0.0, 1.0)};
}

/// The place in a box around a place, and in the patch, at which the field is least.
Vec2 least_normal(const NormalPatch& patch, const Box2& box) {
    constexpr int rounds = 12, half = 2;
    Vec2 best = box.center(), step = box.extent() / (2 * half);
    double least = value_at(patch.field(), best).length2();
    for (int round = 0; round < rounds; ++round, step *= 0.5) {
        const Vec2 middle = best;
        for (int i = -half; i <= half; ++i)
            for (int j = -half; j <= half; ++j) {
                const Vec2 uv = clamped(middle + Vec2(i * step.x, j * step.y));
                const double now = value_at(patch.field(), uv).length2();
                if (now < least) least = now, best = uv;
            }
    }
    return best;
}

struct Normal {
    Vec2 uv;
    Vec3 unit;
};

/// The normals of the material around a place, in their order around it.
std::vector<Normal> ring(const NormalPatch& patch, const Vec2& middle, const Vec2& reach,
                         const IsMaterial& is_material) {
    constexpr std::array<std::array<int, 2>, 8> around{
        {{1, 0}, {1, 1}, {0, 1}, {-1, 1}, {-1, 0}, {-1, -1}, {0, -1}, {1, -1}}};
    std::vector<Normal> normals;
    for (const auto& [i, j] : around) {
        const Vec2 uv = clamped(middle + Vec2(i * reach.x, j * reach.y));
        const auto normal = patch.normal(uv);
        if (normal && is_material(uv)) normals.push_back({uv, *normal});
    }
    return normals;
}

/// Largest angle between two of the normals, degrees.
double largest_turn(const std::vector<Normal>& normals) {
    double most = 0;
    for (const Normal& a : normals)
        for (const Normal& b : normals) most = std::max(most, degrees_between(a.unit, b.unit));
    return most;
}

/// Distance on the surface by way of three places in between, mm.
double way_along(const NormalPatch& patch, const Vec2& a, const Vec2& b) {
    double way = 0;
    constexpr int steps = 4;
    Vec3 last = patch.position(a);
    for (int i = 1; i <= steps; ++i) {
        const Vec3 next = patch.position(a + (b - a) * (static_cast<double>(i) / steps));
        way += (next - last).length(), last = next;
    }
    return way;
}

/// The place `near` mm or more from another up to which the normal stays within 90 degrees of
/// `unit` and there is material; nullopt if it does not. `step`: direction, and the first length
/// tested.
std::optional<Vec3> far_end(const NormalPatch& patch, const Vec2& from, Vec2 step, const Vec3& unit,
                            double near, const IsMaterial& is_material) {
    constexpr int most_doublings = 40;
    const auto stays = [&](const Vec2& uv) {
        const auto normal = patch.normal(uv);
        return normal && unit.dot(*normal) > 0 && is_material(uv);
    };
    for (int i = 0; i < most_doublings; ++i, step *= 2.0) {
        const Vec2 to = from + step;
        if (to != clamped(to) || !stays(to)) return std::nullopt;
        if (way_along(patch, from, to) >= near) return patch.position(to);
    }
    return std::nullopt;
}

/// The part of a patch about a place in which the normal stays on one side.
struct SameSide {
    bool is_long = false; ///< `near` mm in the direction of a step, or along one of the parameters
    bool is_wide = false; ///< and square to that
};

SameSide same_side(const NormalPatch& patch, const Vec2& from, const Vec2& step, const Vec3& unit,
                   double near, const IsMaterial& is_material) {
    const double length = step.length();
    const Vec3 start = patch.position(from);
    std::vector<Vec3> ways;
    for (const Vec2& way :
         {step, Vec2(length, 0), Vec2(-length, 0), Vec2(0, length), Vec2(0, -length)})
        if (const auto end = far_end(patch, from, way, unit, near, is_material))
            ways.push_back(*end - start);
    SameSide side{!ways.empty(), false};
    for (const Vec3& a : ways)
        for (const Vec3& b : ways)
            side.is_wide = side.is_wide || a.cross(b).length() >= near * a.length() / 2;
    return side;
}

std::optional<NormalBreak> turn_along(const NormalPatch& patch, const std::array<Vec2, 2>& ends,
                                      double near, const IsMaterial& is_material) {
    constexpr int most = 50;
    Vec2 a = ends[0], b = ends[1];
    auto at_a = patch.normal(a), at_b = patch.normal(b);
    for (int i = 0; i < most; ++i) {
        if (!at_a || !at_b || !(at_a->dot(*at_b) < 0)) return std::nullopt;
        if (way_along(patch, a, b) <= near) {
            const double degrees = degrees_between(*at_a, *at_b);
            if (degrees < fold || !is_material(a) || !is_material(b)) return std::nullopt;
            const SameSide before = same_side(patch, a, a - b, *at_a, near, is_material);
            const SameSide after = same_side(patch, b, b - a, *at_b, near, is_material);
            return NormalBreak{degrees, before.is_long && after.is_long,
                               before.is_wide && after.is_wide,
                               (patch.position(a) + patch.position(b)) / 2};
        }
        constexpr double share = 0.49; // singular places often lie in the middle
        const Vec2 between = a + (b - a) * share;
        const auto normal = patch.normal(between);
        if (normal && at_a->dot(*normal) < 0)
            b = between, at_b = normal;
        else
            a = between, at_a = normal;
    }
    return std::nullopt;
}

} // namespace

std::optional<NormalBreak> turn_between(const NormalPatch& patch, const std::array<Vec2, 2>& ends,
                                        const Box2& box, double near,
                                        const IsMaterial& is_material) {
    const Vec2 inside = box.lower + Vec2(0.37, 0.61) * box.extent();
    constexpr double aside = 0.25;
    auto found = turn_along(patch, ends, near, is_material);
    if (!found) return std::nullopt;
    const auto beside =
        turn_along(patch, {ends[0], ends[1] + (inside - ends[1]) * aside}, near, is_material);
    if (!beside) return std::nullopt;
    found->turns_over = found->turns_over && beside->turns_over;
    found->wide = found->wide && beside->wide;
    return found;
}

std::optional<NormalBreak> break_about(const NormalPatch& patch, const Box2& box, double near,
                                       const IsMaterial& is_material) {
    const Vec2 reach = box.extent() * 1.5;
    const Box2 around{box.center() - reach, box.center() + reach};
    const Vec2 place = least_normal(patch, around);
    const std::vector<Normal> normals = ring(patch, place, reach, is_material);
    for (std::size_t i = 0; i < normals.size(); ++i) {
        const Normal &a = normals[i], &b = normals[(i + 1) % normals.size()];
        if (!(a.unit.dot(b.unit) < 0)) continue;
        if (auto over = turn_between(patch, {a.uv, b.uv}, around, near, is_material)) return over;
    }
    const double wide = largest_turn(normals);
    const double close = largest_turn(ring(patch, place, reach / 4, is_material));
    constexpr double clearly = 1.0 / 3;
    const double limit = (4 * close - wide) / 3;
    if (!(limit > clearly * wide)) return std::nullopt;
    return NormalBreak{std::min(limit, 180.0), false, false, patch.position(place)};
}

} // namespace keiko
