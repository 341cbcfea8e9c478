#include "keiko/inspect/lines/line_statistics.h"

#include "keiko/base/units.h"
#include "keiko/inspect/basics/placed_face.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace keiko {
namespace {

/// Degrees. A stretch that turns by less is visually straight, and often straight to within
/// rounding.
constexpr double least_turning = 0.05;

/// A stretch of a line with curvature of one sign.
struct Stretch {
    std::size_t begin = 0; ///< the course that it begins with
    double turning = 0;    ///< degrees
};

std::vector<Stretch> stretches(std::span<const CourseAt> courses) {
    std::vector<Stretch> found;
    for (std::size_t i = 1; i < courses.size(); ++i) {
        const double bend = (courses[i - 1].course.bend + courses[i].course.bend) / 2;
        const double turning = radians_to_degrees(bend * courses[i].step);
        if (!found.empty() && (found.back().turning < 0) == (turning < 0))
            found.back().turning += turning;
        else
            found.push_back({i - 1, turning});
    }
    return found;
}

/// The course at or before the change of sign with which a stretch begins.
std::size_t change_before(std::span<const CourseAt> courses, const Stretch& stretch) {
    const double bend = courses[stretch.begin].course.bend;
    return bend * stretch.turning > 0 && stretch.begin > 0 ? stretch.begin - 1 : stretch.begin;
}

std::vector<std::size_t> inflections(std::span<const CourseAt> courses,
                                     const std::vector<Stretch>& stretches) {
    std::vector<std::size_t> found;
    double before = 0;
    for (const Stretch& stretch : stretches) {
        if (std::abs(stretch.turning) < least_turning) continue;
        if (before * stretch.turning < 0) found.push_back(change_before(courses, stretch));
        before = stretch.turning;
    }
    return found;
}

void take_spacing(LineStatistics& shape, const LineGeometry& course, double step) {
    const double spacing = step / course.density;
    if (!std::isfinite(spacing)) return;
    shape.least_spacing =
        shape.least_spacing > 0 ? std::min(shape.least_spacing, spacing) : spacing;
    shape.most_spacing = std::max(shape.most_spacing, spacing);
    shape.spacing_ratio =
        std::max(shape.spacing_ratio, 1 + std::abs(spacing * course.spread_across));
    shape.spacing_rate = std::max(shape.spacing_rate, std::abs(course.spread_along));
}

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

LineStatistics line_shape(std::span<const CourseAt> courses, double step) {
    LineStatistics shape;
    double turning = 0;
    const std::vector<Stretch> parts = stretches(courses);
    for (const Stretch& part : parts)
        shape.turning += part.turning, turning += std::abs(part.turning);
    shape.waviness = turning - std::abs(shape.turning);
    shape.inflections = inflections(courses, parts);
    for (const CourseAt& at : courses) {
        shape.length += at.step;
        if (std::abs(at.course.bend) > std::abs(shape.largest_bend))
            shape.largest_bend = at.course.bend;
        if (step > 0) take_spacing(shape, at.course, step);
    }
    return shape;
}

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
