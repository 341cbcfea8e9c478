#include "keiko/inspect/flaws/roughness_profile.h"

#include <algorithm>
#include <cmath>

namespace keiko {
namespace {

constexpr double reach = 2.5;  ///< waves
constexpr double steps = 24;   ///< a wave
constexpr std::size_t few = 8; ///< too few samples to decide

/// Numerov's method, of order 4, for w'' = k.
std::vector<double> integrated(const std::vector<WalkPoint>& points, double step) {
    std::vector<double> w(points.size(), 0);
    for (std::size_t i = 1; i + 1 < w.size(); ++i)
        w[i + 1] =
            2 * w[i] - w[i - 1] +
            step * step / 12 * (points[i - 1].bend + 10 * points[i].bend + points[i + 1].bend);
    return w;
}

} // namespace

std::optional<RoughnessProfile> RoughnessProfile::through(const FaceAdjacency& faces,
                                                          const SheetPoint& at, const Vec3& along,
                                                          double length) {
    RoughnessProfile profile;
    profile.step_ = length / steps;
    const auto walk = [&](double side) {
        return walk_straight(faces, at, along * side, profile.step_, reach * length, false).points;
    };
    const std::vector<WalkPoint> behind = walk(-1), ahead = walk(1);
    if (behind.size() + ahead.size() < few) return std::nullopt;
    profile.points_.assign(behind.rbegin(), behind.rend() - 1);
    profile.points_.insert(profile.points_.end(), ahead.begin(), ahead.end());
    profile.begin_ = -static_cast<double>(behind.size() - 1) * profile.step_;
    profile.heights_ = integrated(profile.points_, profile.step_);
    return profile;
}

bool RoughnessProfile::holds(double s) const {
    constexpr double rounding = 1e-9;
    const double at = (s - begin_) / step_;
    return at >= -rounding && at <= static_cast<double>(heights_.size() - 1) + rounding;
}

/// The cubic through the four samples around.
double RoughnessProfile::height(double s) const {
    const double at = (s - begin_) / step_;
    const auto last = static_cast<std::ptrdiff_t>(heights_.size()) - 4;
    const auto first =
        std::clamp(static_cast<std::ptrdiff_t>(std::floor(at)) - 1, std::ptrdiff_t{0}, last);
    const double t = at - static_cast<double>(first);
    const auto w = [&](int k) { return heights_[static_cast<std::size_t>(first + k)]; };
    return (w(3) * t * (t - 1) * (t - 2) - w(0) * (t - 1) * (t - 2) * (t - 3)) / 6 +
           (w(1) * t * (t - 2) * (t - 3) - w(2) * t * (t - 1) * (t - 3)) / 2;
}

SheetPoint RoughnessProfile::place(const FaceAdjacency& faces, double s) const {
    const double last = static_cast<double>(points_.size() - 1);
    const double number = std::clamp(std::round((s - begin_) / step_), 0.0, last);
    const auto i = static_cast<std::size_t>(number);
    const WalkPoint &before = points_[i == 0 ? 0 : i - 1], &here = points_[i];
    const WalkPoint& behind = points_[std::min(i + 1, points_.size() - 1)];
    const auto frame = faces.frame(here.at, behind.position - before.position);
    if (!frame) return here.at;
    return faces.moved(*frame, here.at, Vec2(s - begin_ - number * step_, 0)).value_or(here.at);
}

} // namespace keiko
