#include "keiko/inspect/flaws/surface_poles.h"

#include "keiko/base/job.h"
#include "keiko/base/units.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace keiko {
namespace {

/// Distance within which points are one pole, mm: no flaw fits in between.
constexpr double coincident = 1e-3;

/// A spoke and the outward normal at its begin.
struct NormalSpoke {
    SurfacePole::Spoke spoke;
    Vec3 normal{0}; ///< unit
};

/// Limit of the normal at the pole, by those at the end of the spoke and in its middle, as the pole
/// itself may have no derivatives that tell it. nullopt without material.
std::optional<NormalSpoke> spoke_of(const FaceSurface& face, std::size_t index, const Vec2& begin,
                                    const Vec2& step) {
    const auto normal_at = [&](double share) -> std::optional<Vec3> {
        const auto s = face.evaluate(begin + step * share, 1);
        return s ? face.normal(*s) : std::nullopt;
    };
    const auto middle = normal_at(0.5), end = normal_at(1);
    if (!middle || !end) return std::nullopt;
    const auto there = face.evaluate_beyond(begin + step, 0);
    const auto pole = face.evaluate_beyond(begin, 0);
    return NormalSpoke{{{index, begin}, step, there->position() - pole->position()},
                       (*middle * 2 - *end).normalized()};
}

/// The spokes of one collapsed side, and where it is.
struct PoleSide {
    std::size_t face = 0;
    Vec3 position{0};
    std::vector<NormalSpoke> spokes;
};

PoleSide pole_side(const FaceSurface& face, std::size_t index, const CollapsedSide& side) {
    constexpr int count = 8;       // a span
    constexpr double share = 1e-3; // of a span: the way is straight
    PoleSide found{index, face.evaluate_beyond(side.begin, 0)->position(), {}};
    for (int k = 0; k < count; ++k) {
        const Vec2 begin = side.begin + side.along * ((k + 0.5) / count);
        if (auto spoke = spoke_of(face, index, begin, side.inward * share))
            found.spokes.push_back(*spoke);
    }
    return found;
}

/// The pole of coinciding sides; nullopt if it is the tip of a cone or has no material around.
std::optional<SurfacePole> smooth_pole(std::span<const PoleSide* const> sides) {
    SurfacePole pole;
    pole.position = sides.front()->position;
    Vec3 sum(0);
    for (const PoleSide* side : sides)
        for (const NormalSpoke& s : side->spokes) sum += s.normal, pole.spokes.push_back(s.spoke);
    pole.normal = sum.normalized();
    constexpr double smooth = 0.1 / 2; // degrees: half the angle of a seam of class-a-outer
    const double least = std::cos(degrees_to_radians(smooth));
    for (const PoleSide* side : sides)
        for (const NormalSpoke& s : side->spokes)
            if (!(s.normal.dot(pole.normal) >= least)) return std::nullopt;
    return pole.spokes.empty() ? std::nullopt : std::optional(pole);
}

} // namespace

SurfacePoles::SurfacePoles(std::span<const FaceSurface> faces, std::span<const std::size_t> sheets)
    : of_face_(faces.size()) {
    std::vector<PoleSide> sides;
    for (std::size_t i = 0; i < faces.size(); ++i) {
        check_stop();
        for (const CollapsedSide& side : faces[i].collapsed_sides(coincident))
            sides.push_back(pole_side(faces[i], i, side));
    }
    std::stable_sort(sides.begin(), sides.end(), [](const PoleSide& a, const PoleSide& b) {
        return a.position.x < b.position.x;
    });
    std::vector<bool> taken(sides.size(), false);
    for (std::size_t i = 0; i < sides.size(); ++i) {
        if (taken[i]) continue;
        check_stop();
        std::vector<const PoleSide*> together;
        for (std::size_t k = i;
             k < sides.size() && sides[k].position.x <= sides[i].position.x + coincident; ++k) {
            if (taken[k] || sheets[sides[k].face] != sheets[sides[i].face] ||
                (sides[k].position - sides[i].position).length() > coincident)
                continue;
            taken[k] = true, together.push_back(&sides[k]);
        }
        const auto pole = smooth_pole(together);
        if (!pole) continue;
        for (const PoleSide* side : together)
            if (auto& of = of_face_[side->face]; of.empty() || of.back() != poles_.size())
                of.push_back(poles_.size());
        poles_.push_back(*pole);
    }
}

} // namespace keiko
