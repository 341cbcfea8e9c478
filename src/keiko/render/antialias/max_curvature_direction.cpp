#include "keiko/render/antialias/max_curvature_direction.h"

#include "keiko/render/reflection/cubic_footprint.h"

#include <cmath>
#include <numeric>

namespace keiko {
namespace {

/// The slopes of something over the picture by least squares. Places are told from their mean, so
/// that a constant in the values, such as that of a place that is not the mean, drops out.
class SlopeFit {
public:
    void add(const Vec2& place, const Vec3& value) {
        xx_ += place.x * place.x, xy_ += place.x * place.y, yy_ += place.y * place.y;
        x_ += value * place.x, y_ += value * place.y;
    }
    Slopes<Vec3> slopes() const {
        const double determinant = xx_ * yy_ - xy_ * xy_;
        return {(x_ * yy_ - y_ * xy_) / determinant, (y_ * xx_ - x_ * xy_) / determinant};
    }

private:
    double xx_ = 0, xy_ = 0, yy_ = 0; ///< moments of the places
    Vec3 x_{0}, y_{0};                ///< and with the values
};

/// How the unit normal changes where the position changes by `step`, as the curvature at a hit
/// has it; not at all at a pole.
Slopes<Vec3> slopes_at(const Hit& hit, const Slopes<Vec3>& step) {
    const Vec3 &su = hit.dpdu, &sv = hit.dpdv, area = su.cross(sv);
    const double size = area.length();
    if (!(size > 0)) return {Vec3(0), Vec3(0)};
    const auto along = [&](const Vec3& d) {
        const double u = d.cross(sv).dot(area), v = su.cross(d).dot(area);
        const Vec3 change = (hit.second->duu.cross(sv) + su.cross(hit.second->duv)) * u +
                            (hit.second->duv.cross(sv) + su.cross(hit.second->dvv)) * v;
        return (change - area * (area.dot(change) / (size * size))) / (size * size * size);
    };
    return {along(step.x), along(step.y)};
}

/// Sums up how much slopes are along every direction of the picture: a quadratic form.
class Steepness {
public:
    void add(const Slopes<Vec3>& by) {
        xx_ += by.x.dot(by.x), xy_ += by.x.dot(by.y), yy_ += by.y.dot(by.y);
    }
    /// Along which they are most, unit; 0 where there are none.
    Vec2 most() const {
        if (!(xx_ + yy_ > 0)) return Vec2(0);
        const double angle = std::atan2(2 * xy_, xx_ - yy_) / 2;
        return {std::cos(angle), std::sin(angle)};
    }

private:
    double xx_ = 0, xy_ = 0, yy_ = 0;
};

Slopes<Vec3> operator*(const Slopes<Vec3>& s, double factor) {
    return {s.x * factor, s.y * factor};
}
Slopes<Vec3> operator-(const Slopes<Vec3>& a, const Slopes<Vec3>& b) {
    return {a.x - b.x, a.y - b.y};
}

} // namespace

Vec2 max_curvature_direction(std::span<const Vec2> corners,
                             std::span<const PixelSample* const> seen, const PixelSample& amid) {
    SlopeFit normals, positions;
    const Vec2 middle = std::accumulate(corners.begin(), corners.end(), Vec2(0)) /
                        static_cast<double>(corners.size());
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const Hit& hit = *seen[i]->hit;
        const Vec3 normal = hit.normal.dot(amid.hit->normal) < 0 ? -hit.normal : hit.normal;
        normals.add(corners[i] - middle, normal - amid.hit->normal);
        positions.add(corners[i] - middle, hit.position - amid.hit->position);
    }
    // Images are bent where the normal turns unevenly; what turns evenly counts little.
    constexpr double even = 0.1;
    const Slopes<Vec3> step = positions.slopes(), mean = normals.slopes();
    const Slopes<Vec3> own = slopes_at(*amid.hit, step);
    Steepness bending;
    bending.add(mean * even), bending.add(mean - own);
    for (const PixelSample* sample : seen) {
        const double side = sample->hit->normal.dot(amid.hit->normal) < 0 ? -1 : 1;
        const Slopes<Vec3> there = slopes_at(*sample->hit, step) * side;
        bending.add(there * even), bending.add(there - own);
    }
    return bending.most();
}

} // namespace keiko
