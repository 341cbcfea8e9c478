#include "keiko/volumes/lit_volumes.h"

#include "keiko/volumes/opacity.h"
#include "keiko/volumes/ray_samples.h"

#include <algorithm>
#include <limits>

namespace keiko {
namespace {

constexpr double opaque = 0.999; ///< opacity beyond which nothing behind counts

/// A volume that a ray crosses.
struct Crossed {
    const Volume* volume;
    std::optional<CloudView> cloud;
    GridRay ray;

    Rgb luminance(const Vec3& place, const Vec3& to_viewer, double t) {
        const Rgb own = volume->luminance(place, to_viewer, t);
        return cloud ? own + cloud->luminance(place) : own;
    }
};

/// Adds the volumes along a part of a ray that is inside all of them, behind what is there.
void add_part(std::span<Crossed* const> volumes, const Vec3& to_viewer, double begin, double end,
              FrontToBack& sum) {
    double step = end - begin;
    for (const Crossed* crossed : volumes) step = std::min(step, crossed->volume->step());
    const RaySamples samples(begin, end, step);
    const auto clear_until = [&](double t) {
        double clear = std::numeric_limits<double>::infinity();
        for (const Crossed* crossed : volumes)
            clear = std::min(clear, crossed->volume->clear_until(crossed->ray, t));
        return clear;
    };
    samples.each(clear_until, [&](double t) {
        double extinction = 0;
        Rgb light;
        for (Crossed* crossed : volumes) {
            const Vec3 place = crossed->ray.at(t);
            const double own = crossed->volume->extinction(place);
            if (!(own > 0)) continue;
            extinction += own;
            light += crossed->luminance(place, to_viewer, t) * own;
        }
        if (extinction > 0)
            sum.add(light / extinction, opacity_of_depth(extinction * samples.length()));
        return sum.opacity <= opaque;
    });
}

/// Parameters between which a ray is inside the same volumes.
std::vector<double> ends_of(std::span<const Crossed> crossed) {
    std::vector<double> ends;
    for (const Crossed& one : crossed) ends.push_back(one.ray.begin), ends.push_back(one.ray.end);
    std::sort(ends.begin(), ends.end());
    return ends;
}

} // namespace

LitVolumes::LitVolumes(const SceneVolumes& volumes, const LightRig& rig, const StopOfLight& stops,
                       const Job& job)
    : volumes_(volumes), clouds_(volumes.volumes().size()) {
    for (std::size_t i = 0; i < clouds_.size(); ++i) {
        const Volume& volume = volumes.volumes()[i];
        if (volume.spec().scattering) clouds_[i].emplace(volumes, volume, rig, stops, job);
    }
}

FrontToBack LitVolumes::along(const Segment& segment) const {
    const Vec3 to_viewer = (segment.a - segment.b).normalized();
    std::vector<Crossed> crossed;
    for (std::size_t i = 0; i < clouds_.size(); ++i)
        if (const auto ray = volumes_.volumes()[i].crossing(segment)) {
            crossed.push_back({&volumes_.volumes()[i], {}, *ray});
            if (clouds_[i]) crossed.back().cloud.emplace(*clouds_[i], to_viewer);
        }
    FrontToBack sum;
    if (crossed.empty()) return sum;
    const std::vector<double> ends = ends_of(crossed);
    std::vector<Crossed*> inside;
    for (std::size_t i = 0; i + 1 < ends.size() && sum.opacity <= opaque; ++i) {
        if (!(ends[i] < ends[i + 1])) continue;
        inside.clear();
        for (Crossed& one : crossed)
            if (one.ray.begin <= ends[i] && one.ray.end >= ends[i + 1]) inside.push_back(&one);
        if (!inside.empty()) add_part(inside, to_viewer, ends[i], ends[i + 1], sum);
    }
    return sum;
}

} // namespace keiko
