#include "keiko/render/antialias/edge_pixel_lighting.h"

#include "keiko/render/antialias/edge_runs.h"
#include "keiko/render/lighting/light_interpolation.h"

#include <algorithm>
#include <map>
#include <tuple>
#include <utility>

namespace keiko {
namespace {

using Spots = std::vector<OutlineSpot>;

/// The shading points of one depth, whose light goes to the parts of pixels.
class SharedLight {
public:
    SharedLight(const Integrator& integrator, double error, std::vector<Subpixel>& parts)
        : integrator_(integrator), error_(error), parts_(parts) {}

    /// Shading points of one pixel.
    void add(Spots points) {
        for (Spots& surface : smooth_surfaces(std::move(points))) {
            const OutlineSpot place = amid(surface);
            places_.push_back(place);
            surfaces_[place.point] = std::move(surface);
        }
    }
    /// Lights what has been added.
    void light() const {
        for (const EdgeRun& row : edge_runs(places_)) {
            const ShadingGrid grid(row.points, row.along);
            const std::vector<DirectLight> light =
                light_interpolation(integrator_, grid, seen(row), {}, error_);
            for (std::size_t i = 0; i < light.size(); ++i)
                for (const OutlineSpot& point : surfaces_.at(row.points[i]))
                    integrator_.add_light(*point.point, light[i], part_of(*point.point).sample);
        }
    }

private:
    Subpixel& part_of(const ShadingPoint& point) const { return parts_[point.sample]; }
    /// The one nearest to the mean place of all, by their shares.
    OutlineSpot amid(const Spots& surface) const {
        Vec3 sum(0);
        double shares = 0;
        for (const OutlineSpot& point : surface) {
            sum += point.point->place.position * part_of(*point.point).share;
            shares += part_of(*point.point).share;
        }
        const Vec3 mean = sum / shares;
        const auto off = [&](const OutlineSpot& point) {
            return (point.point->place.position - mean).length2();
        };
        return *std::min_element(surface.begin(), surface.end(),
                                 [&](const auto& a, const auto& b) { return off(a) < off(b); });
    }
    std::vector<Rgb> seen(const EdgeRun& row) const {
        std::vector<Rgb> seen;
        for (const ShadingPoint* point : row.points)
            seen.push_back(part_of(*point).sample.luminance);
        return seen;
    }

    const Integrator& integrator_;
    double error_;
    std::vector<Subpixel>& parts_;
    Spots places_;
    std::map<const ShadingPoint*, Spots> surfaces_; ///< by the one of them that is lit
};

} // namespace

void add_shared_light(const Integrator& integrator, int width, double error,
                      RefinedPixels& refined) {
    std::vector<ShadingPoint>& points = refined.points;
    const auto pixel = [&](const ShadingPoint& point) { return refined.parts[point.sample].pixel; };
    const auto order = [&](const ShadingPoint& point) {
        return std::tuple(point.depth, pixel(point), point.sample);
    };
    std::stable_sort(
        points.begin(), points.end(),
        [&](const ShadingPoint& a, const ShadingPoint& b) { return order(a) < order(b); });
    each_depth(points, [&](std::span<const ShadingPoint> of_depth) {
        SharedLight shared(integrator, error, refined.parts);
        for (std::size_t i = 0; i < of_depth.size();) {
            Spots of_pixel;
            const std::size_t number = pixel(of_depth[i]);
            const auto w = static_cast<std::size_t>(width);
            const Pixel place{static_cast<int>(number % w), static_cast<int>(number / w)};
            for (; i < of_depth.size() && pixel(of_depth[i]) == number; ++i)
                of_pixel.push_back({place, &of_depth[i]});
            shared.add(std::move(of_pixel));
        }
        shared.light();
    });
}

} // namespace keiko
