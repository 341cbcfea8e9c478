// Panels with rolled edges that stand apart.
#pragma once

#include "keiko/inspect/joints/find_joints.h"

#include "tests/support/model_builder.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace keiko::test::joints {

constexpr double join = 0.5;                          ///< mm
constexpr double quarter_turn = std::numbers::pi / 2; ///< radians

/// A straight panel: its skin ends at a line from `origin`, in a roll and a flange.
struct Panel {
    Vec3 origin{0};              ///< where the line begins, mm
    Vec3 along{1, 0, 0};         ///< unit
    Vec3 forward{0, 1, 0};       ///< unit, over the skin's end
    Vec3 outward{0, 0, 1};       ///< unit
    double radius = 3;           ///< mm; 0: the flange begins at the skin's end
    double length = 200;         ///< mm
    double sweep = quarter_turn; ///< of the roll, radians
    double flange = 10;          ///< mm; 0: there is none
    double depth = 60;           ///< mm of the skin
    double skin_radius = 0;      ///< mm, about an axis along the line inside; 0: flat

    Vec3 centre() const { return origin - outward * radius; }
    /// Direction from the centre of the roll, `angle` from its beginning.
    Vec3 spoke(double angle) const { return outward * std::cos(angle) + forward * std::sin(angle); }
    /// The point of the roll that is foremost in a direction, at the beginning of the line.
    Vec3 foremost(const Vec3& direction) const {
        const double angle = std::atan2(direction.dot(forward), direction.dot(outward));
        return centre() + spoke(std::min(angle, sweep)) * radius;
    }
};

/// Control points of an arc about `centre` from `from` by `angle` towards `to`, unit vectors.
inline std::vector<Vec4> arc(const Vec3& centre, const Vec3& from, const Vec3& to, double radius,
                             double angle) {
    const double w = std::cos(angle / 2);
    std::vector<Vec4> points;
    const auto add = [&](double at, double r, double weight) {
        const Vec3 p = centre + (from * std::cos(at) + to * std::sin(at)) * r;
        points.emplace_back(p.x * weight, p.y * weight, p.z * weight, weight);
    };
    add(0, radius, 1), add(angle / 2, radius / w, w), add(angle, radius, 1);
    return points;
}

/// Control points of a chord.
inline std::vector<Vec4> chord(const Vec3& from, const Vec3& to) {
    return {Vec4(from.x, from.y, from.z, 1), Vec4(to.x, to.y, to.z, 1)};
}

/// A profile moved along a line.
inline void extruded(ModelBuilder& builder, const std::vector<Vec4>& profile, const Vec3& by) {
    std::vector<Vec4> points = profile;
    for (const Vec4& p : profile)
        points.emplace_back(p.x + by.x * p.w, p.y + by.y * p.w, p.z + by.z * p.w, p.w);
    builder.rational_patch(1, static_cast<int>(profile.size()) - 1, points);
}

/// The profiles of a panel at the beginning of its line: skin, roll (in halves beyond a right
/// angle) and flange.
inline std::vector<std::vector<Vec4>> profiles(const Panel& panel) {
    std::vector<std::vector<Vec4>> found;
    const Vec3 back = -panel.forward;
    if (panel.skin_radius > 0)
        found.push_back(arc(panel.origin - panel.outward * panel.skin_radius, panel.outward, back,
                            panel.skin_radius, panel.depth / panel.skin_radius));
    else
        found.push_back(chord(panel.origin, panel.origin + back * panel.depth));
    // Its normal points outwards where `along` and `forward` turn right-handed about that.
    std::reverse(found.back().begin(), found.back().end());
    const int parts = panel.radius > 0 ? (panel.sweep > quarter_turn + 0.8 ? 2 : 1) : 0;
    for (int i = 0; i < parts; ++i) {
        const double from = panel.sweep * i / parts;
        found.push_back(arc(panel.centre(), panel.spoke(from), panel.spoke(from + quarter_turn),
                            panel.radius, panel.sweep / parts));
    }
    const Vec3 end = panel.centre() + panel.spoke(panel.sweep) * panel.radius;
    if (panel.flange > 0)
        found.push_back(chord(end, end + panel.spoke(panel.sweep + quarter_turn) * panel.flange));
    return found;
}

inline void add(ModelBuilder& builder, const Panel& panel) {
    for (const auto& profile : profiles(panel))
        extruded(builder, profile, panel.along * panel.length);
}

inline SurfaceModel model_of(const std::vector<Panel>& panels) {
    ModelBuilder builder;
    for (const Panel& panel : panels) add(builder, panel);
    return builder.build();
}

inline std::vector<Joint> joints_of(const SurfaceModel& model, const JointLimits& limits = {}) {
    return find_joints(model, pair_seams(model, join), limits);
}

/// Two flat panels along x: the first from y = 0 with a roll of 3 mm, the second across the gap
/// with a roll of 2 mm.
inline std::vector<Panel> pair_of(double gap, double flush) {
    Panel a, b;
    b.radius = 2, b.forward = {0, -1, 0};
    b.origin = {0, a.radius + gap + b.radius, flush};
    return {a, b};
}

} // namespace keiko::test::joints
