#include "keiko/geometry/bezier/subpatch.h"

namespace keiko {
namespace {

/// `count` control points, `step` apart; one end is cut off in place, or continued, at t.
struct Line {
    Vec4* c;
    std::size_t count, step;

    Vec4 blend(std::size_t i, std::size_t k, double t) const {
        return c[i * step] * (1 - t) + c[k * step] * t;
    }
    void end_at(double t) const {
        if (t == 1) return;
        for (std::size_t level = 1; level < count; ++level)
            for (std::size_t i = count - 1; i >= level; --i) c[i * step] = blend(i - 1, i, t);
    }
    void begin_at(double t) const {
        if (t == 0) return;
        for (std::size_t level = 1; level < count; ++level)
            for (std::size_t i = 0; i + level < count; ++i) c[i * step] = blend(i, i + 1, t);
    }
};

/// Restricts the line to [a, b]. The part beyond the patch is continued first, from the whole of
/// it: continued by as much from a narrow piece, rounding would grow with a power of their ratio.
void restrict_line(const Line& line, double a, double b) {
    if (a < 0) {
        line.begin_at(a);
        line.end_at((b - a) / (1 - a));
    } else {
        line.end_at(b);
        line.begin_at(a / b);
    }
}

} // namespace

std::vector<Vec4> subpatch(const BezierPatchView& patch, const Box2& box) {
    std::vector<Vec4> points(patch.points.begin(), patch.points.end());
    const auto rows = static_cast<std::size_t>(patch.degree_u) + 1;
    const auto columns = static_cast<std::size_t>(patch.degree_v) + 1;
    for (std::size_t j = 0; j < columns; ++j)
        restrict_line({&points[j], rows, columns}, box.lower.x, box.upper.x);
    for (std::size_t i = 0; i < rows; ++i)
        restrict_line({&points[i * columns], columns, 1}, box.lower.y, box.upper.y);
    return points;
}

} // namespace keiko
