#include "keiko/render/antialias/subpixels.h"

#include "keiko/math/convex_clip.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

namespace keiko {
namespace {

/// Part of a convex polygon beyond a line across a direction.
Polygon beyond(std::span<const Vec2> corners, const Vec2& across, double line) {
    Polygon left;
    clip_convex(
        corners, [&](std::size_t i) { return across.dot(corners[i]) - line; },
        [&](const Vec2& corner) { left.push_back(corner); });
    return left;
}

} // namespace

PixelArea rectangle_part(const Vec2& corner, const Vec2& size) {
    return {corner + size / 2, {size.x, 0}, {0, size.y}, size.x * size.y};
}

PixelArea polygon_part(std::span<const Vec2> corners) {
    const Vec2& origin = corners[0];
    double area = 0, xx = 0, xy = 0, yy = 0;
    Vec2 first(0);
    for (std::size_t i = 2; i < corners.size(); ++i) {
        const Vec2 a = corners[i - 1] - origin, b = corners[i] - origin, sum = a + b;
        const double triangle = (a.x * b.y - a.y * b.x) / 2;
        area += triangle;
        first += sum * (triangle / 3);
        xx += triangle / 12 * (a.x * a.x + b.x * b.x + sum.x * sum.x);
        xy += triangle / 12 * (a.x * a.y + b.x * b.y + sum.x * sum.y);
        yy += triangle / 12 * (a.y * a.y + b.y * b.y + sum.y * sum.y);
    }
    const Vec2 middle = first / area;
    xx = xx / area - middle.x * middle.x;
    xy = xy / area - middle.x * middle.y;
    yy = yy / area - middle.y * middle.y;
    // Edges e and f have the moments (e e' + f f') / 12: those are a Cholesky factor.
    const double right = std::sqrt(std::max(xx, 0.0));
    const double shear = right > 0 ? xy / right : 0;
    const double down = std::sqrt(std::max(yy - shear * shear, 0.0));
    const double scale = std::sqrt(12.0);
    return {origin + middle, Vec2(right, shear) * scale, Vec2(0, down) * scale, std::abs(area)};
}

Polygon strip_of(std::span<const Vec2> corners, const Vec2& across, double begin, double end) {
    return beyond(beyond(corners, across, begin), -across, -end);
}

double polygon_mean(std::span<const Vec2> corners, std::span<const double> values) {
    double area = 0, sum = 0;
    for (std::size_t i = 2; i < corners.size(); ++i) {
        const Vec2 a = corners[i - 1] - corners[0], b = corners[i] - corners[0];
        const double triangle = a.x * b.y - a.y * b.x;
        area += triangle;
        sum += triangle * (values[0] + values[i - 1] + values[i]) / 3;
    }
    return sum / area;
}

Ray ray_of(const PreparedCamera& camera, const PixelArea& part) {
    Ray ray = camera.ray(part.centre.x, part.centre.y);
    const RayDifferentials pixel = *ray.differentials;
    const auto along = [](const Vec3& dx, const Vec3& dy, const Vec2& edge) {
        return dx * edge.x + dy * edge.y;
    };
    ray.differentials = RayDifferentials{along(pixel.origin_dx, pixel.origin_dy, part.right),
                                         along(pixel.origin_dx, pixel.origin_dy, part.down),
                                         along(pixel.direction_dx, pixel.direction_dy, part.right),
                                         along(pixel.direction_dx, pixel.direction_dy, part.down)};
    return ray;
}

void Subpixels::open(SampleBatch view) {
    for (const PixelSample& seen : view.samples) result_.paths += seen.paths;
    kept_.assign(view.samples.size(), {});
    result_.views.push_back(std::move(view));
}

void Subpixels::keep(std::size_t sample, std::size_t pixel, double share) {
    kept_[sample] = result_.parts.size();
    result_.parts.push_back({pixel, share, seen(sample)});
}

void Subpixels::close() {
    for (ShadingPoint point : result_.views.back().points)
        if (const auto part = kept_[point.sample]) {
            point.sample = *part;
            result_.points.push_back(point);
        }
}

RefinedPixels Subpixels::finish(const HitStatistics& probes) {
    std::vector<std::size_t> order(result_.parts.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
        return result_.parts[a].pixel < result_.parts[b].pixel;
    });
    std::vector<Subpixel> parts;
    parts.reserve(order.size());
    std::vector<std::size_t> place(order.size());
    for (const std::size_t i : order) {
        place[i] = parts.size();
        parts.push_back(result_.parts[i]);
    }
    result_.parts = std::move(parts);
    for (ShadingPoint& point : result_.points) point.sample = place[point.sample];
    result_.paths += probes;
    return std::move(result_);
}

} // namespace keiko
