#include "keiko/trace/subpatch.h"

namespace keiko {
namespace {

/// `count` control points, `step` apart, cut down to [a, b] in place by two de Casteljau splits.
void restrict_line(Vec4* c, std::size_t count, std::size_t step, double a, double b) {
    const auto blend = [&](std::size_t i, std::size_t k, double t) {
        return c[i * step] * (1 - t) + c[k * step] * t;
    };
    if (b != 1)
        for (std::size_t level = 1; level < count; ++level)
            for (std::size_t i = count - 1; i >= level; --i) c[i * step] = blend(i - 1, i, b);
    if (a != 0)
        for (std::size_t level = 1; level < count; ++level)
            for (std::size_t i = 0; i + level < count; ++i) c[i * step] = blend(i, i + 1, a / b);
}

} // namespace

std::vector<Vec4> subpatch(const BezierPatchView& patch, const Box2& box) {
    std::vector<Vec4> points(patch.points.begin(), patch.points.end());
    const auto rows = static_cast<std::size_t>(patch.degree_u) + 1;
    const auto columns = static_cast<std::size_t>(patch.degree_v) + 1;
    for (std::size_t j = 0; j < columns; ++j)
        restrict_line(&points[j], rows, columns, box.lower.x, box.upper.x);
    for (std::size_t i = 0; i < rows; ++i)
        restrict_line(&points[i * columns], columns, 1, box.lower.y, box.upper.y);
    return points;
}

} // namespace keiko
