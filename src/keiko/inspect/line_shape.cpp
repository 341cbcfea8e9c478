#include "keiko/inspect/line_shape.h"

#include "keiko/base/units.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace keiko {
namespace {

/// Degrees. A stretch that turns by less is straight to any eye, and often to rounding.
constexpr double least_turning = 0.05;

/// Sums of the turning of stretches that turn one way, degrees.
std::vector<double> stretches(std::span<const CourseAt> courses) {
    std::vector<double> sums;
    for (std::size_t i = 1; i < courses.size(); ++i) {
        const double bend = (courses[i - 1].course.bend + courses[i].course.bend) / 2;
        const double turning = radians_to_degrees(bend * courses[i].step);
        if (!sums.empty() && (sums.back() < 0) == (turning < 0))
            sums.back() += turning;
        else
            sums.push_back(turning);
    }
    return sums;
}

int inflections(const std::vector<double>& stretches) {
    int count = 0;
    double before = 0;
    for (const double turning : stretches) {
        if (std::abs(turning) < least_turning) continue;
        if (before * turning < 0) ++count;
        before = turning;
    }
    return count;
}

void take_spacing(LineShape& shape, const LineCourse& course, double step) {
    const double spacing = step / course.density;
    if (!std::isfinite(spacing)) return;
    shape.least_spacing =
        shape.least_spacing > 0 ? std::min(shape.least_spacing, spacing) : spacing;
    shape.most_spacing = std::max(shape.most_spacing, spacing);
    shape.spacing_ratio =
        std::max(shape.spacing_ratio, 1 + std::abs(spacing * course.spread_across));
    shape.spacing_rate = std::max(shape.spacing_rate, std::abs(course.spread_along));
}

} // namespace

LineShape line_shape(std::span<const CourseAt> courses, double step) {
    LineShape shape;
    double turning = 0;
    const std::vector<double> sums = stretches(courses);
    for (const double sum : sums) shape.turning += sum, turning += std::abs(sum);
    shape.waviness = turning - std::abs(shape.turning);
    shape.inflections = inflections(sums);
    for (const CourseAt& at : courses) {
        shape.length += at.step;
        if (std::abs(at.course.bend) > std::abs(shape.largest_bend))
            shape.largest_bend = at.course.bend;
        if (step > 0) take_spacing(shape, at.course, step);
    }
    return shape;
}

} // namespace keiko
