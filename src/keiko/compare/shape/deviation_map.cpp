#include "keiko/compare/shape/deviation_map.h"

#include "keiko/base/parallel.h"
#include "keiko/compare/alignment/closest_point_walk.h"

#include <cmath>
#include <limits>
#include <optional>

namespace keiko {
namespace {

/// Distance of a place from its closest point, mm: positive outside, infinite without one.
float signed_distance(const Vec3& place, const std::optional<ClosestSurfacePoint>& foot) {
    return foot ? static_cast<float>(foot->signed_distance(place))
                : std::numeric_limits<float>::infinity();
}

} // namespace

DeviationMap surface_map(const Tracer& body, const Camera& camera,
                         const std::function<HitValue()>& begin_row, const Job& job) {
    DeviationMap map{Image(camera.width, camera.height, 1, std::numeric_limits<float>::quiet_NaN()),
                     Image(camera.width, camera.height, 1)};
    parallel_for(static_cast<std::size_t>(camera.height), job, "deviation map", [&](std::size_t y) {
        const int row = static_cast<int>(y);
        std::vector<Ray> rays;
        for (int x = 0; x < camera.width; ++x) rays.push_back(camera.ray(x + 0.5, row + 0.5));
        const std::vector<std::optional<Hit>> hits = body.nearest(rays);
        const HitValue value = begin_row();
        for (int x = 0; x < camera.width; ++x) {
            const auto& hit = hits[static_cast<std::size_t>(x)];
            if (!hit) continue;
            *map.distance.pixel(x, row) = value(*hit);
            const Vec3 view = rays[static_cast<std::size_t>(x)].direction.normalized();
            *map.facing.pixel(x, row) = static_cast<float>(std::abs(view.dot(hit->normal)));
        }
    });
    return map;
}

DeviationMap deviation_map(const Tracer& body, const Camera& camera, const ClosestPointQuery& other,
                           double reach, const Job& job) {
    const auto begin_row = [&]() -> HitValue {
        return [walk = ClosestPointWalk(other, reach)](const Hit& hit) mutable {
            return signed_distance(hit.position, walk.next(hit.position));
        };
    };
    return surface_map(body, camera, begin_row, job);
}

SharedFaces::SharedFaces(const PlacedModel& before, const Deviation& from_before,
                         const PlacedModel& after, const Deviation& from_after) {
    // 0 is the ground, which both have.
    std::size_t next = 1;
    before_[0] = after_[0] = 0;
    for (const Face& face : before.model.faces) next += before_.emplace(face.id, next).second;
    for (const Face& face : after.model.faces) next += after_.emplace(face.id, next).second;
    sets_ = DisjointSets(next);
    join(before, before_, from_before, after, after_);
    join(after, after_, from_after, before, before_);
}

void SharedFaces::join(const PlacedModel& from, const Numbers& numbers_from,
                       const Deviation& deviation, const PlacedModel& to,
                       const Numbers& numbers_to) {
    for (std::size_t f = 0; f < deviation.faces.size(); ++f) {
        const FaceDeviation& face = deviation.faces[f];
        if (face.partner == no_index || face.alone()) continue;
        sets_.join(numbers_from.at(from.model.faces[f].id),
                   numbers_to.at(to.model.faces[face.partner].id));
    }
}

void SharedFaces::rename(Film& film, const Numbers& numbers) {
    const auto layer = film.aovs.find(Aov::face);
    if (layer == film.aovs.end()) return;
    for (float& value : layer->second.values) {
        if (value < 0) continue;
        const auto found = numbers.find(static_cast<std::uint32_t>(value));
        if (found != numbers.end()) value = static_cast<float>(sets_.root(found->second));
    }
}

} // namespace keiko
