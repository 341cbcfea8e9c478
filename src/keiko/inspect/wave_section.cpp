#include "keiko/inspect/wave_section.h"

#include <array>
#include <cmath>

namespace keiko {
namespace {

/// The line through a place, in the plane of the normal there.
class Section {
public:
    Section(const FaceGrid& grid, const Vec2& place, bool along_u, const SurfaceDerivatives& s)
        : grid_(grid),
          place_(place),
          along_u_(along_u),
          origin_(s.position()),
          normal_(s.du().cross(s.dv()).normalized() * grid.sign()),
          tangent_((along_u ? s.du() : s.dv()).normalized()),
          speed_((along_u ? s.du() : s.dv()).length()) {}

    /// How high the line lies over the tangent where it has gone `x` mm along it.
    std::optional<double> height(double x) const {
        double near = 0, far = x / speed_;
        constexpr int most_doublings = 10, halvings = 35;
        for (int i = 0;; ++i) {
            const auto gone = along(far);
            if (!gone || i == most_doublings) return std::nullopt;
            if (std::abs(*gone) >= std::abs(x)) break;
            near = far, far *= 2;
            if (!along(far)) far = near * 1.25; // the face may end before
        }
        for (int i = 0; i < halvings; ++i) {
            const double middle = (near + far) / 2;
            const auto gone = along(middle);
            if (!gone) return std::nullopt;
            (std::abs(*gone) < std::abs(x) ? near : far) = middle;
        }
        const auto there = grid_.evaluate(at(far), 0);
        if (!there) return std::nullopt;
        return (there->position() - origin_).dot(normal_);
    }

private:
    Vec2 at(double step) const { return place_ + (along_u_ ? Vec2(step, 0) : Vec2(0, step)); }
    std::optional<double> along(double step) const {
        const auto s = grid_.evaluate(at(step), 0);
        if (!s) return std::nullopt;
        return (s->position() - origin_).dot(tangent_);
    }

    const FaceGrid& grid_;
    Vec2 place_;
    bool along_u_;
    Vec3 origin_, normal_, tangent_;
    double speed_;
};

/// The depth there of a wave of this length. With d(h) the height of the middle above that of the
/// places h to either side: d(length / 2) is twice the depth and the form's bend, d(length) four
/// times that bend alone.
std::optional<double> depth_at(const FaceGrid& grid, const Vec2& place, bool along_u,
                               double length) {
    const auto s = grid.evaluate(place, 1);
    if (!s) return std::nullopt;
    const Section section(grid, place, along_u, *s);
    std::array<double, 2> differences{};
    for (std::size_t i = 0; i < 2; ++i) {
        const double h = i == 0 ? length / 2 : length;
        const auto before = section.height(-h), behind = section.height(h);
        if (!before || !behind) return std::nullopt;
        differences[i] = -(*before + *behind) / 2;
    }
    return (differences[0] - differences[1] / 4) / 2;
}

} // namespace

std::optional<WaveSection> wave_section(const FaceGrid& grid, const Vec2& place, bool along_u,
                                        bool crest, double length) {
    const auto s = grid.evaluate(place, 1);
    if (!s) return std::nullopt;
    const double side = crest ? 1 : -1, speed = (along_u ? s->du() : s->dv()).length();
    const auto depth_of = [&](const Vec2& at, double of_length) {
        return depth_at(grid, at, along_u, of_length);
    };
    WaveSection best{0, length, 0, place, s->position()};
    const auto start = depth_of(place, length);
    if (!start) return std::nullopt;
    best.depth = *start;
    double step = 0.1;
    constexpr int halvings = 6;
    for (int halved = 0; halved < halvings;) {
        bool moved = false;
        for (const Vec2& way : {Vec2(1, 0), Vec2(-1, 0), Vec2(0, 1), Vec2(0, -1)}) {
            const double shift = way.x * step * length / speed;
            const Vec2 at = best.place + (along_u ? Vec2(shift, 0) : Vec2(0, shift));
            const double longer = best.length * (1 + way.y * step);
            const auto depth = depth_of(at, longer);
            if (!depth || *depth * side <= best.depth * side) continue;
            best.depth = *depth, best.place = at, best.length = longer, moved = true;
        }
        if (!moved) step /= 2, ++halved;
    }
    const auto shorter = depth_of(best.place, 0.95 * best.length);
    const auto there = grid.evaluate(best.place, 0);
    if (!shorter || !there) return std::nullopt;
    best.bound = std::abs(*shorter - best.depth);
    best.position = there->position();
    return best;
}

} // namespace keiko
