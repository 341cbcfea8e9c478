#include "keiko/maps/scene_maps.h"

#include <algorithm>
#include <limits>
#include <utility>

namespace keiko {
namespace {

/// Face parameters over all of some patches.
template <class MapOf>
std::pair<double, double> range_of(std::span<const Patch> patches, const MapOf& map_of) {
    double low = std::numeric_limits<double>::infinity(), high = -low;
    for (const Patch& patch : patches)
        for (const double t : {0.0, 1.0}) {
            const double at = map_of(patch).to_face(t);
            low = std::min(low, at), high = std::max(high, at);
        }
    return {low, high > low ? high - low : 1};
}

const ParameterMap& map_u(const Patch& patch) {
    return patch.map_u;
}
const ParameterMap& map_v(const Patch& patch) {
    return patch.map_v;
}

} // namespace

FaceParameters::FaceParameters(const SurfaceModel& model) {
    for (const Face& face : model.faces) {
        const std::span<const Patch> patches = model.patches_of(face);
        const auto [u, u_size] = range_of(patches, map_u);
        const auto [v, v_size] = range_of(patches, map_v);
        for (const Patch& patch : patches)
            of_patch_.push_back({{patch.map_u, u, u_size}, {patch.map_v, v, v_size}});
    }
}

ProjectedPlace FaceParameters::at(std::uint32_t patch, const Vec2& uv, const Vec3& dpdu,
                                  const Vec3& dpdv) const {
    const PatchRanges ranges = patch < of_patch_.size() ? of_patch_[patch] : PatchRanges{};
    ProjectedPlace place{{ranges.u.at(uv.x), ranges.v.at(uv.y)}};
    const Vec3 area = dpdu.cross(dpdv);
    if (!(area.length2() > 0)) return place;
    place.grad_u = dpdv.cross(area) * (ranges.u.slope(uv.x) / area.length2());
    place.grad_v = area.cross(dpdu) * (ranges.v.slope(uv.y) / area.length2());
    return place;
}

bool FaceParameters::is_turned(std::uint32_t patch, const Vec2& uv) const {
    if (patch >= of_patch_.size()) return false;
    const PatchRanges& ranges = of_patch_[patch];
    return ranges.u.slope(uv.x) * ranges.v.slope(uv.y) < 0;
}

SceneMaps::SceneMaps(std::span<const Material> materials, const SurfaceModel& model,
                     const std::optional<EnvironmentSpec>& environment)
    : parameters_(model) {
    if (environment) environment_.emplace(*environment);
    for (const Face& face : model.faces) reversed_.push_back(face.reversed);
    reversed_.resize(std::max(materials.size(), reversed_.size()), false);
    for (const Instance& instance : model.instances)
        mirrored_.push_back(instance.transform.mirrored());
    mirrored_.push_back(false); // of the ground
    std::vector<std::pair<std::span<const MaterialMap>, std::shared_ptr<const SurfaceMaps>>> known;
    for (const Material& material : materials) {
        if (material.maps.empty()) {
            of_face_.emplace_back();
            continue;
        }
        const auto same = [&](const auto& other) {
            return std::equal(other.first.begin(), other.first.end(), material.maps.begin(),
                              material.maps.end());
        };
        auto found = std::find_if(known.begin(), known.end(), same);
        if (found == known.end())
            found = known.insert(
                found, {material.maps, std::make_shared<const SurfaceMaps>(material.maps)});
        of_face_.push_back(found->second);
    }
}

} // namespace keiko
