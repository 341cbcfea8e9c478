#include "keiko/render/antialias/edge_detection.h"
#include "keiko/render/antialias/edge_refinement.h"
#include "keiko/render/reflection/reflected_footprint.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace keiko {
namespace {

/// Slopes of a quantity over the picture by least squares. Places are relative to their mean, so
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

/// Change of the unit normal with a change of the position by `step`, by the curvature at a hit; 0
/// at a pole.
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

/// Sum of the squares of slopes along every direction of the picture: a quadratic form.
class Steepness {
public:
    void add(const Slopes<Vec3>& by) {
        xx_ += by.x.dot(by.x), xy_ += by.x.dot(by.y), yy_ += by.y.dot(by.y);
    }
    /// Direction in which they are largest, unit; 0 if there are none.
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
    // Images are bent where the normal turns non-uniformly; a uniform turn counts little.
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

namespace {

/// Deviation from a parallelogram allowed for the image of a pixel on the lamps' plane, as a share
/// of its span, if luminances differ by at most the luminance in the middle.
constexpr double most_bend = 0.03;
/// Difference allowed between the cosines of a pixel, as a share of the larger.
constexpr double most_turn = 0.3;
/// Sine of an angle by which the normal may turn: lamps fit in between.
constexpr double most_rotation = 0.17;

/// Deviation allowed of the middle of a pixel from the mean of its corners, as a share of the
/// larger luminance. It counts where the pixel reflects the body itself, which has no place on the
/// lamps' plane that would state more.
constexpr double most_glare = 0.05;

struct Range {
    double least, most;

    explicit Range(double x) : least(x), most(x) {}
    void add(double x) { least = std::min(least, x), most = std::max(most, x); }
    double span() const { return most - least; }
};

} // namespace

bool SampledPolygon::shows(const PixelSample& amid) const {
    return std::any_of(seen.begin(), seen.end(),
                       [&](const PixelSample* corner) { return !differ_closely(*corner, amid); });
}

bool SampledPolygon::is_outshone_by(const PixelSample& amid) const {
    Range shown(luminance(seen[0]->luminance));
    for (const PixelSample* sample : seen) shown.add(luminance(sample->luminance));
    const double own = luminance(amid.luminance), slack = 0.1 * shown.most;
    return own < shown.least - slack || own > shown.most + slack;
}

double SampledPolygon::turn(const PixelSample& amid) const {
    Range cosine(amid.cosine), sine(0);
    for (const PixelSample* sample : seen) {
        cosine.add(sample->cosine);
        if (sample->hit) sine.add(sample->hit->normal.cross(amid.hit->normal).length());
    }
    return std::max(cosine.span() / (most_turn * cosine.most), sine.most / most_rotation);
}

double SampledPolygon::bend(const PixelSample& amid) const {
    Range across(amid.across_lamps), light(luminance(amid.luminance));
    InplaceVector<double, most_corners> places;
    for (const PixelSample* sample : seen) {
        across.add(sample->across_lamps);
        light.add(luminance(sample->luminance));
        places.push_back(sample->across_lamps);
    }
    if (across.span() == 0) return 0;
    // The visibility of an error is relative to the luminance there.
    const double contrast = std::max(1.0, light.span() / std::max(luminance(amid.luminance), 1e-9));
    return std::abs(polygon_mean(corners, places) - amid.across_lamps) * contrast /
           (most_bend * across.span());
}

double SampledPolygon::glare(const PixelSample& amid) const {
    InplaceVector<double, most_corners> lights;
    for (const PixelSample* sample : seen) lights.push_back(luminance(sample->luminance));
    const double mean = polygon_mean(corners, lights), own = luminance(amid.luminance);
    return std::abs(mean - own) / (most_glare * std::max({mean, own, 1e-9}));
}

double SampledPolygon::unevenness(const PixelSample& amid) const {
    const auto beyond_horizon = [&](const PixelSample* sample) {
        return sample->c_plane.has_value() != amid.c_plane.has_value();
    };
    if (!amid.hit) return 0;
    if (is_outshone_by(amid) || std::any_of(seen.begin(), seen.end(), beyond_horizon))
        return std::numeric_limits<double>::infinity();
    const double size = std::sqrt(whole().area), turned = turn(amid) * size;
    return std::max(turned * turned, size * (amid.c_plane ? bend(amid) : glare(amid)));
}

std::vector<PixelArea> SampledPolygon::strips(const PixelSample& amid, double uneven,
                                              double narrowest) const {
    const auto shows_surface = [](const PixelSample* sample) { return sample->hit != nullptr; };
    if (!amid.hit || !std::all_of(seen.begin(), seen.end(), shows_surface)) return {};
    const Vec2 across = max_curvature_direction(corners, seen, amid);
    if (across == Vec2(0)) return {};
    Range range(across.dot(corners[0]));
    for (const Vec2& corner : corners) range.add(across.dot(corner));
    const double most = std::max(2.0, std::ceil(range.span() / narrowest));
    constexpr double spare = 3; // the bend is not uniform
    const double n = std::min(most, std::ceil(std::sqrt(uneven)) + spare);
    const double step = range.span() / n;
    std::vector<PixelArea> parts;
    for (double i = 0; i < n; ++i) {
        const double end = i + 1 < n ? range.least + (i + 1) * step : range.most;
        const Polygon strip = strip_of(corners, across, range.least + i * step, end);
        if (strip.size() < 3) continue;
        const PixelArea part = polygon_part(strip);
        if (part.area > 0) parts.push_back(part);
    }
    return parts;
}

} // namespace keiko
