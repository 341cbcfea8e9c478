#include "keiko/render/antialias/edge_detection.h"

#include "keiko/geometry/bezier/differential_geometry.h"
#include "keiko/math/vec.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace keiko {
namespace {

/// Angle by which the normal turns over a step by the curvature at a hit, rad.
double told_turn(const Hit& hit, const Vec3& step) {
    if (!(hit.dpdu.cross(hit.dpdv).length2() > 0)) return 0;
    return std::abs(normal_curvature(derivatives_of(hit), hit.normal, step)) * step.length();
}

/// True if a smooth surface turns from one hit to another.
bool rounds_off(const Hit& a, const Hit& b) {
    const Vec3 step = b.position - a.position;
    const double off = std::min(std::abs(step.dot(a.normal)), std::abs(step.dot(b.normal)));
    constexpr double rounding = 1 + 1e-9;
    // Precedes the last condition, as it needs no angle: it decides most edges.
    if (off > a.normal.cross(b.normal).length() * step.length() * rounding) return false;
    const double turn = angle_between(a.normal.dot(b.normal) < 0 ? -a.normal : a.normal, b.normal);
    return turn < 2 * std::max(told_turn(a, step), told_turn(b, step)) &&
           off < std::sin(turn) * step.length();
}

/// True if what the first surfaces mirror, or what is seen through them, has an edge between.
bool border_differs(const PixelSample& a, const PixelSample& b) {
    return a.mirrored_face.has_value() != b.mirrored_face.has_value() ||
           a.behind.has_value() != b.behind.has_value() ||
           (a.behind && !is_same_surface(*a.behind, *b.behind));
}

} // namespace

bool differ(const PixelSample& a, const PixelSample& b) {
    if (!a.hit || !b.hit) return (a.hit != nullptr) != (b.hit != nullptr);
    return border_differs(a, b) || !is_same_surface(place_of(a), place_of(b));
}

bool differ_closely(const PixelSample& a, const PixelSample& b) {
    if (!differ(a, b)) return false;
    return !a.hit || !b.hit || border_differs(a, b) || a.paint != b.paint ||
           !rounds_off(*a.hit, *b.hit);
}

bool look_alike(const PixelSample& a, const PixelSample& b, double contrast) {
    if ((a.hit != nullptr) != (b.hit != nullptr)) return false;
    if ((a.lit || b.lit) && differ(a, b)) return false;
    const auto near = [contrast](double x, double y) {
        return std::abs(x - y) <= contrast * std::max(std::abs(x), std::abs(y));
    };
    return near(a.luminance.r, b.luminance.r) && near(a.luminance.g, b.luminance.g) &&
           near(a.luminance.b, b.luminance.b);
}

std::vector<Outline> outlines_of(std::span<const PixelSample> samples, int width) {
    const auto w = static_cast<std::size_t>(width);
    const auto outline = [&](std::size_t i) {
        if (samples[i].discontinuous) return Outline::discontinuous;
        const auto off = [&](std::size_t other) { return differ(samples[i], samples[other]); };
        const std::array around{i - w - 1, i - w,     i - w + 1, i - 1,
                                i + 1,     i + w - 1, i + w,     i + w + 1};
        return std::any_of(around.begin(), around.end(), off) ? Outline::likely : Outline::none;
    };
    std::vector<Outline> outlines;
    for (std::size_t row = w; row + w < samples.size(); row += w)
        for (std::size_t x = 1; x + 1 < w; ++x) outlines.push_back(outline(row + x));
    return outlines;
}

} // namespace keiko
