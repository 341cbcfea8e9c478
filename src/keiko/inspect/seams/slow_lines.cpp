#include "keiko/inspect/seams/slow_lines.h"

#include "keiko/math/golden_section.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace keiko {
namespace {

/// The speed square to the isolines of a patch where they cross one isoline of the other parameter.
class CrossSpeed {
public:
    CrossSpeed(const BezierPatchView& patch, bool constant_u, double along)
        : patch_(patch), constant_u_(constant_u), along_(along) {}

    double operator()(double t) const {
        const Vec2 uv = constant_u_ ? Vec2(t, along_) : Vec2(along_, t);
        const SurfaceDerivatives s = evaluate(patch_, uv, 1);
        return (constant_u_ ? square_to(s.du(), s.dv()) : square_to(s.dv(), s.du())).length();
    }

private:
    const BezierPatchView& patch_;
    bool constant_u_;
    double along_;
};

double fastest_slow(int degree, double window, double most) {
    return (degree - 1) * std::sqrt(2 * window * most);
}

/// The tangents of a patch's control net in one direction, times the degree: polynomials through
/// them have a patch's derivatives between their least and largest part in any direction.
std::vector<Vec3> net_tangents(const BezierPatchView& patch, bool by_u) {
    const int degree = by_u ? patch.degree_u : patch.degree_v;
    const int rows = by_u ? patch.degree_v : patch.degree_u;
    std::vector<Vec3> tangents;
    for (int i = 0; i < degree; ++i)
        for (int j = 0; j <= rows; ++j) {
            const Vec4 d = by_u ? patch.point(i + 1, j) - patch.point(i, j)
                                : patch.point(j, i + 1) - patch.point(j, i);
            tangents.push_back(Vec3(d.x, d.y, d.z) * (degree / patch.points.front().w));
        }
    return tangents;
}

Vec3 sum_of(const std::vector<Vec3>& vectors) {
    return std::accumulate(vectors.begin(), vectors.end(), Vec3(0));
}

double most_length(const std::vector<Vec3>& vectors) {
    double most = 0;
    for (const Vec3& v : vectors) most = std::max(most, v.length());
    return most;
}

double least_part(const std::vector<Vec3>& vectors, const Vec3& direction) {
    double least = HUGE_VAL;
    for (const Vec3& v : vectors) least = std::min(least, v.dot(direction));
    return least;
}

/// True if the control points alone exclude slow lines. The part of S_u square to S_v is
/// S_u - l S_v, |l| <= |S_u| / |S_v|: it advances in a direction at least as S_u does, less l times
/// what S_v does.
bool advances(const BezierPatchView& patch, bool constant_u, double window) {
    if (patch.rational()) return false;
    const int degree = constant_u ? patch.degree_u : patch.degree_v;
    const std::vector<Vec3> across = net_tangents(patch, constant_u);
    const std::vector<Vec3> along = net_tangents(patch, !constant_u);
    const Vec3 run = sum_of(along), square = square_to(sum_of(across), run);
    if (run.length2() == 0 || square.length2() == 0) return false;
    const Vec3 ahead = square.normalized();
    const double most = most_length(across), slowest_run = least_part(along, run.normalized());
    if (!(slowest_run > 0)) return false;
    double drift = 0;
    for (const Vec3& v : along) drift = std::max(drift, std::abs(v.dot(ahead)));
    const double least = least_part(across, ahead) - most / slowest_run * drift;
    return least > std::max(window, fastest_slow(degree, window, most));
}

/// The parameter of least speed between two others, ends included.
double slowest_between(const CrossSpeed& speed, double low, double high) {
    constexpr double enough = 1e-9;
    const FunctionPlace inside = golden_section_minimum(speed, low, high, enough);
    if (speed(low) <= inside.value) return low;
    return speed(high) <= inside.value ? high : inside.at;
}

/// True if the speed rises by a quarter within half a window, to one side of `t`.
bool quickens(const CrossSpeed& speed, double t, double window, double step) {
    constexpr double rise = 1.25;
    const double slow = speed(t);
    double way = 0;
    const double first =
        slow * std::abs(step) > window / 2 ? std::copysign(window / 2 / slow, step) : step;
    for (double x = t + first; x >= 0 && x <= 1 && way < window / 2; x += step) {
        const double now = speed(x);
        if (now > rise * slow) return true;
        way += now * std::abs(step);
    }
    return false;
}

void add_slow(const CrossSpeed& speed, int degree, double window, std::vector<double>& lines) {
    const int steps = 4 * degree;
    std::vector<double> sampled;
    double length = 0, most = 0;
    for (int i = 0; i <= steps; ++i) {
        sampled.push_back(speed(static_cast<double>(i) / steps));
        length += sampled.back() / (steps + 1), most = std::max(most, sampled.back());
    }
    if (length <= window) lines.push_back(middle_of_narrow);
    const double limit = fastest_slow(degree, window, most);
    for (int i = 0; i <= steps; ++i) {
        const auto k = static_cast<std::size_t>(i);
        const bool falls = i == 0 || sampled[k] <= sampled[k - 1];
        const bool rises =
            i == steps ? i > 0 && sampled[k] < sampled[k - 1] : sampled[k] < sampled[k + 1];
        if (!falls || !rises) continue;
        const double step = 1.0 / steps;
        const double t = slowest_between(speed, std::max(0, i - 1) * step,
                                         i + 1 >= steps ? 1.0 : (i + 1) * step);
        if (speed(t) <= limit &&
            (quickens(speed, t, window, step) || quickens(speed, t, window, -step)))
            lines.push_back(t);
    }
}

} // namespace

std::vector<double> slow_lines(const BezierPatchView& patch, bool constant_u,
                               std::span<const double> along, double window) {
    std::vector<double> lines;
    if (advances(patch, constant_u, window)) return lines;
    const int degree = constant_u ? patch.degree_u : patch.degree_v;
    for (const double place : along)
        add_slow(CrossSpeed(patch, constant_u, place), degree, window, lines);
    std::sort(lines.begin(), lines.end());
    constexpr double same = 1e-6;
    const auto near = [](double a, double b) { return b - a < same; };
    lines.erase(std::unique(lines.begin(), lines.end(), near), lines.end());
    return lines;
}

} // namespace keiko
