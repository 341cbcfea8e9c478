#include "keiko/inspect/dent_depth.h"

#include "keiko/inspect/smooth_base.h"

#include <array>
#include <cmath>
#include <vector>

namespace keiko {
namespace {

/// A plane that touches the surface, to look from at what is around.
struct Outlook {
    Vec3 origin, x, y, z;

    Height height(const Vec3& position, double weight) const {
        const Vec3 from = position - origin;
        return {from.dot(x), from.dot(y), from.dot(z), weight};
    }
};

std::optional<Outlook> outlook(const FaceGrid& grid, const Vec2& place) {
    const auto s = grid.evaluate(place, 1);
    if (!s) return std::nullopt;
    const Vec3 x = s->du().normalized();
    const Vec3 z = s->du().cross(s->dv()).normalized() * grid.sign();
    return Outlook{s->position(), x, z.cross(x), z};
}

/// The form around a place.
std::optional<SmoothBase> base_around(const FaceGrid& grid, const Outlook& from, double reach) {
    std::vector<Height> heights;
    std::array<std::size_t, 4> quarters{};
    for (std::size_t row = 0; row < grid.rows(); ++row)
        for (std::size_t column = 0; column < grid.columns(); ++column) {
            const FaceSample& sample = grid.sample(column, row);
            if (!sample.material || (sample.position - from.origin).length() > reach) continue;
            heights.push_back(from.height(sample.position, sample.area));
            ++quarters[(heights.back().x > 0 ? 1u : 0u) + (heights.back().y > 0 ? 2u : 0u)];
        }
    // Beside a border there is form on one side only.
    constexpr std::size_t least_share = 20;
    for (const std::size_t quarter : quarters)
        if (quarter * least_share < heights.size()) return std::nullopt;
    return SmoothBase::fit(heights, reach);
}

/// Of the surface at a place, mm; positive outwards.
std::optional<double> offset_at(const FaceGrid& grid, const Vec2& place, double reach) {
    const auto from = outlook(grid, place);
    if (!from) return std::nullopt;
    const auto under = base_around(grid, *from, reach);
    if (!under) return std::nullopt;
    return -under->height(0, 0);
}

/// By steps along u and v that are halved where none leads further off.
Vec2 furthest(const FaceGrid& grid, Vec2 place, const Outlook& from, const SmoothBase& under,
              double reach, double spacing) {
    const auto offset = [&](const Vec2& at) {
        const auto s = grid.evaluate(at, 0);
        if (!s) return 0.0;
        const Height h = from.height(s->position(), 1);
        return h.x * h.x + h.y * h.y < reach * reach ? h.z - under.height(h.x, h.y) : 0.0;
    };
    const auto s = grid.evaluate(place, 1);
    if (!s) return place;
    double best = offset(place);
    const double side = best < 0 ? -1 : 1;
    best *= side;
    Vec2 step(spacing / s->du().length(), spacing / s->dv().length());
    constexpr int halvings = 8;
    for (int halved = 0; halved < halvings;) {
        bool moved = false;
        for (const Vec2& way :
             {Vec2(step.x, 0), Vec2(-step.x, 0), Vec2(0, step.y), Vec2(0, -step.y)}) {
            const double there = offset(place + way) * side;
            if (there > best) best = there, place += way, moved = true;
        }
        if (!moved) step *= 0.5, ++halved;
    }
    return place;
}

} // namespace

std::optional<DentDepth> dent_depth(const FaceGrid& grid, const Vec2& begin, double reach,
                                    double spacing) {
    Vec2 place = begin;
    constexpr int rounds = 3;
    for (int i = 0; i < rounds; ++i) {
        const auto from = outlook(grid, place);
        if (!from) return std::nullopt;
        const auto under = base_around(grid, *from, reach);
        if (!under) return std::nullopt;
        place = furthest(grid, place, *from, *under, reach, spacing);
    }
    constexpr double less = 0.8;
    const auto from = outlook(grid, place);
    const auto offset = offset_at(grid, place, reach), again = offset_at(grid, place, less * reach);
    if (!from || !offset || !again) return std::nullopt;
    return DentDepth{*offset, std::abs(*again - *offset), from->origin};
}

} // namespace keiko
