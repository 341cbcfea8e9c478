#include "keiko/radiosity/exchange_area.h"

#include "keiko/math/convex_clip.h"
#include "keiko/math/polygon.h"
#include "keiko/math/quadrature.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

namespace keiko {
namespace {

/// Edge of a polygon.
struct PolygonEdge {
    Vec3 from{0}, unit{0}; ///< mm; direction
    double length = 0;     ///< mm

    PolygonEdge(const Vec3& a, const Vec3& b) : from(a), length((b - a).length()) {
        if (length > 0) unit = (b - a) / length;
    }
    Vec3 at(double s) const { return from + unit * s; }
    /// Place of the foot of a point.
    double foot(const Vec3& point) const { return unit.dot(point - from); }
};

std::vector<PolygonEdge> edges_of(std::span<const Vec3> corners) {
    std::vector<PolygonEdge> edges;
    for (std::size_t i = 0; i < corners.size(); ++i)
        edges.emplace_back(corners[i], corners[i + 1 < corners.size() ? i + 1 : 0]);
    return edges;
}

/// Integral of ln(r / unit) along a line from its foot to x, at a distance from the line.
double log_integral(double x, double distance, double unit) {
    const double square = (x * x + distance * distance) / (unit * unit);
    if (!(square > 0)) return 0;
    const double round = distance > 0 ? distance * std::atan(x / distance) : 0;
    return x * std::log(square) / 2 - x + round;
}

/// Integral over both edges of ln(r / unit), r the distance of their places.
class EdgePair {
public:
    EdgePair(const PolygonEdge& a, const PolygonEdge& b, double unit) : a_(a), b_(b), unit_(unit) {}

    /// By Gauss's rule on both, for edges far from each other.
    double far(int order) const {
        const auto along = [&](double s) {
            const Vec3 place = a_.at(s);
            return integrate(
                [&](double t) {
                    return std::log((b_.at(t) - place).length2() / (unit_ * unit_)) / 2;
                },
                0, b_.length, order);
        };
        return integrate(along, 0, a_.length, order);
    }

    /// In closed form along the second. Along the first it is cut where the second's ends are
    /// nearest, since derivatives may grow there without bound.
    double near(double allowed) const {
        Breakpoints range(0, a_.length);
        range.cut_at(a_.foot(b_.from));
        range.cut_at(a_.foot(b_.at(b_.length)));
        constexpr int halvings = 14;
        return sum_over_pieces(range, [&](double begin, double end) {
            return integrate_adaptively([&](double s) { return along_second(a_.at(s)); }, begin,
                                        end, allowed, halvings);
        });
    }

private:
    double along_second(const Vec3& place) const {
        const Vec3 way = b_.from - place;
        const double begin = b_.unit.dot(way), distance = b_.unit.cross(way).length();
        return log_integral(begin + b_.length, distance, unit_) -
               log_integral(begin, distance, unit_);
    }

    const PolygonEdge &a_, &b_;
    double unit_;
};

/// Ball around points.
struct Ball {
    Vec3 center{0};
    double radius = 0;

    explicit Ball(std::span<const Vec3> points) : center(middle_of(points)) {
        for (const Vec3& point : points) radius = std::max(radius, (point - center).length());
    }
};

/// Order of a rule that has 1e-14 on edges in two balls, by Bernstein's ellipse of the logarithm;
/// nullopt for balls that are too near.
std::optional<int> order_of_rule(const Ball& a, const Ball& b) {
    const double apart = (a.center - b.center).length() - a.radius - b.radius;
    const double size = std::max(a.radius, b.radius);
    if (apart > 16 * size) return 5;
    if (apart > 4 * size) return 8;
    if (apart > 1.5 * size) return 13;
    return std::nullopt;
}

/// Sum over the pairs of edges of two polygons that are wholly before each other.
double contour_sum(std::span<const Vec3> first, std::span<const Vec3> second) {
    const Ball a(first), b(second);
    const std::optional<int> order = order_of_rule(a, b);
    const double unit = std::max({(a.center - b.center).length(), a.radius, b.radius});
    const double allowed =
        1e-12 * std::min(polygon_normal(first).length(), polygon_normal(second).length());
    double sum = 0;
    for (const PolygonEdge& e : edges_of(first))
        for (const PolygonEdge& f : edges_of(second)) {
            const double along = e.unit.dot(f.unit);
            if (along == 0) continue;
            const EdgePair pair(e, f, unit);
            sum += along * (order ? pair.far(*order) : pair.near(allowed));
        }
    return sum / (2 * std::numbers::pi);
}

} // namespace

std::vector<Vec3> part_before(std::span<const Vec3> corners, const Vec3& place,
                              const Vec3& normal) {
    std::vector<Vec3> part;
    clip_convex(
        corners, [&](std::size_t i) { return normal.dot(corners[i] - place); },
        [&](const Vec3& corner) { part.push_back(corner); });
    return part;
}

double direct_exchange_area(std::span<const Vec3> first, std::span<const Vec3> second) {
    if (first.size() < 3 || second.size() < 3) return 0;
    const std::vector<Vec3> a = part_before(first, second[0], polygon_normal(second));
    const std::vector<Vec3> b = part_before(second, first[0], polygon_normal(first));
    if (a.size() < 3 || b.size() < 3) return 0;
    return std::max(contour_sum(a, b), 0.0);
}

} // namespace keiko
