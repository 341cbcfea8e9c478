#include "keiko/inspect/basics/face_limits.h"

#include "keiko/scene/stricter_limits.h"

#include <stdexcept>
#include <utility>

namespace keiko {

FaceLimits::FaceLimits(CriteriaPreset preset) : preset_(std::move(preset)), strictest_(preset_) {
    if (!preset_.zones.empty())
        throw std::invalid_argument("the zones of preset " + preset_.name + " have no faces yet");
}

FaceLimits::FaceLimits(const SurfaceModel& model, CriteriaPreset preset, FaceZones zones)
    : preset_(std::move(preset)), zones_(std::move(zones)) {
    std::size_t count = 0;
    for (const Instance& instance : model.instances) {
        const Part& part = model.parts[instance.part];
        first_.push_back(count - part.first_face); // wraps around, and back in index_of
        count += part.face_count;
    }
    combine();
}

/// The faces of no zone are those of the last.
void FaceLimits::combine() {
    std::vector<const CriteriaPreset*> all;
    for (const Zone& zone : preset_.zones) all.push_back(&zone.limits);
    CriteriaPreset rest = preset_;
    rest.zones.clear();
    all.push_back(&rest);
    strictest_ = rest;
    for (const CriteriaPreset* a : all) {
        strictest_ = stricter_limits(strictest_, *a);
        for (const CriteriaPreset* b : all) pairs_.push_back(a == b ? *a : stricter_limits(*a, *b));
    }
}

std::size_t FaceLimits::number_of(const PlacedFace& face) const {
    const std::uint32_t zone = zone_of(face);
    return zone == no_zone ? preset_.zones.size() : zone;
}

const CriteriaPreset& FaceLimits::of(const PlacedFace& face) const {
    return between(face, face);
}

const CriteriaPreset& FaceLimits::between(const PlacedFace& a, const PlacedFace& b) const {
    if (!has_zones_or_scope()) return preset_;
    return pairs_[number_of(a) * (preset_.zones.size() + 1) + number_of(b)];
}

std::uint32_t FaceLimits::zone_of(const PlacedFace& face) const {
    return zones_.zone.empty() ? no_zone : zones_.zone[index_of(face)];
}

bool FaceLimits::in_scope(const PlacedFace& face) const {
    return zones_.in_scope.empty() || zones_.in_scope[index_of(face)];
}

} // namespace keiko
