#include "keiko/render/caustics/beam_overlap.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace keiko {
namespace {

using Triangle = std::array<Vec2, 3>;

/// Part of a beam, in coordinates of a footprint, which is a square from -1/2 to 1/2.
class Corners {
public:
    Corners() { corners_.fill(Vec2(0)); }
    void push_back(const Vec2& corner) { corners_[size_++] = corner; }
    std::size_t size() const { return size_; }
    const Vec2& operator[](std::size_t i) const { return corners_[i]; }
    const Vec2* begin() const { return corners_.data(); }
    const Vec2* end() const { return corners_.data() + size_; }

private:
    // A cut adds half of them at the most, however rounding falls: four make 13 of 3.
    std::array<Vec2, 13> corners_;
    std::size_t size_ = 0;
};

double signed_area(const Corners& corners) {
    double sum = 0;
    for (std::size_t i = 1; i + 1 < corners.size(); ++i)
        sum += (corners[i] - corners[0]).cross(corners[i + 1] - corners[0]);
    return sum / 2;
}

/// The part of a convex polygon where `side(corner)` >= 0 [Sutherland1974].
template <class Side>
Corners clipped(const Corners& corners, const Side& side) {
    Corners left;
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const Vec2 &a = corners[i], &b = corners[(i + 1) % corners.size()];
        const double from = side(a), to = side(b);
        if (from >= 0) left.push_back(a);
        if ((from >= 0) != (to >= 0)) left.push_back(a + (b - a) * (from / (from - to)));
    }
    return left;
}

/// The part of a triangle within the footprint.
Corners within_square(const Triangle& triangle) {
    Corners corners;
    for (const Vec2& corner : triangle) corners.push_back(corner);
    for (const unsigned axis : {0U, 1U})
        for (const double sense : {1.0, -1.0})
            corners = clipped(corners, [&](const Vec2& p) { return 0.5 - sense * p[axis]; });
    return corners;
}

/// The mean place of a convex polygon; of no area, of its corners.
template <class Polygon>
Vec2 centroid(const Polygon& corners) {
    Vec2 sum(0), plain(0);
    double areas = 0;
    for (std::size_t i = 1; i + 1 < corners.size(); ++i) {
        const double area = (corners[i] - corners[0]).cross(corners[i + 1] - corners[0]);
        sum += (corners[0] + corners[i] + corners[i + 1]) * (area / 3);
        areas += area;
    }
    for (const Vec2& corner : corners) plain += corner / static_cast<double>(corners.size());
    return areas != 0 ? sum / areas : plain;
}

/// Density at a place of a triangle relative to its mean there.
double density_at(const Beam& beam, const Triangle& triangle, double area, const Vec2& place) {
    const auto& [a, b, c] = beam.density;
    const double mean = (a + b + c) / 3, low = std::min({a, b, c}), high = std::max({a, b, c});
    constexpr double steep = 4; // beyond, a fold is near, where it is not linear
    if (!(low > 0 && high < steep * low)) return 1;
    const double u = (triangle[2] - triangle[1]).cross(place - triangle[1]) / (2 * area);
    const double v = (triangle[0] - triangle[2]).cross(place - triangle[2]) / (2 * area);
    return (a * u + b * v + c * (1 - u - v)) / mean;
}

} // namespace

double share_within(const Beam& beam, const SurfaceFootprint& footprint) {
    const Vec3 across = footprint.dx.cross(footprint.dy);
    const double area2 = across.length2();
    const Vec3 to_x = footprint.dy.cross(across) / area2, to_y = across.cross(footprint.dx) / area2;
    Triangle triangle;
    Box2 box;
    for (std::size_t i = 0; i < triangle.size(); ++i) {
        const Vec3 off = beam.corners[i] - footprint.position;
        triangle[i] = Vec2(off.dot(to_x), off.dot(to_y));
        box.extend(triangle[i]);
    }
    const Box2 square{Vec2(-0.5), Vec2(0.5)};
    if (!square.overlaps(box)) return 0;
    if (square.contains(box.lower) && square.contains(box.upper)) return 1;
    const Corners part = within_square(triangle);
    if (part.size() == 0) return 0;
    const double area = (triangle[1] - triangle[0]).cross(triangle[2] - triangle[0]) / 2;
    constexpr double sliver = 1e-12; // of the footprint: it lies on a line
    if (!(std::abs(area) > sliver)) return square.contains(centroid(triangle)) ? 1 : 0;
    return signed_area(part) / area * density_at(beam, triangle, area, centroid(part));
}

} // namespace keiko
