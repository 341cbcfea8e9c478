#include "keiko/workflow/zoned_limits.h"

#include "keiko/base/text.h"
#include "keiko/workflow/face_sets.h"

#include <algorithm>

namespace keiko {
namespace {

using Words = std::vector<std::string>;

/// Throws Error unless one of the faces is there.
void require_some(const FaceSet& faces, const Zone& zone, const std::string& reason) {
    if (std::find(faces.begin(), faces.end(), true) == faces.end())
        throw Error(zone.file, "zone '" + zone.name + "'", reason);
}

/// The faces of each zone, whatever zones come before it.
std::vector<FaceSet> faces_of_zones(FaceFinder& finder, const CriteriaPreset& preset) {
    std::vector<FaceSet> sets;
    for (const Zone& zone : preset.zones) {
        try {
            sets.push_back(finder.selected(zone.selection));
        } catch (const FieldError& error) {
            throw Error(zone.file, "zone '" + zone.name + "', " + error.field(), error.reason());
        }
        require_some(sets.back(), zone,
                     "no face meets all its conditions: " + zone.selection.text());
    }
    return sets;
}

/// The zone of each face: the first that selects it.
std::vector<std::uint32_t> first_zones(const std::vector<FaceSet>& sets,
                                       const CriteriaPreset& preset, std::size_t faces) {
    std::vector<std::uint32_t> zones(faces, no_zone);
    for (std::uint32_t z = 0; z < sets.size(); ++z) {
        FaceSet left(faces, false);
        for (std::size_t i = 0; i < faces; ++i) {
            if (!sets[z][i] || zones[i] != no_zone) continue;
            zones[i] = z;
            left[i] = true;
        }
        require_some(left, preset.zones[z], "each of its faces belongs to an earlier zone");
    }
    return zones;
}

/// Adds the faces of a zone of the scope by its name.
void add_zone(const std::string& name, const CriteriaPreset& preset,
              const std::vector<std::uint32_t>& zone_of, FaceFinder& finder, FaceSet& faces) {
    if (name == outer_skin) {
        const FaceSet skin = finder.outer_skin();
        for (std::size_t i = 0; i < faces.size(); ++i)
            if (skin[i]) faces[i] = true;
        return;
    }
    Words names;
    for (std::uint32_t z = 0; z < preset.zones.size(); ++z) {
        names.push_back(preset.zones[z].name);
        if (names.back() != name) continue;
        for (std::size_t i = 0; i < faces.size(); ++i)
            if (zone_of[i] == z) faces[i] = true;
        return;
    }
    names.emplace_back(outer_skin);
    throw FieldError("zone", "preset " + preset.name + " has no zone '" + shortened(name) + "'" +
                                 did_you_mean(name, names) + "; there are " + comma_list(names));
}

FaceSet scope_of(FaceFinder& finder, const CriteriaPreset& preset, const Scope& scope,
                 const std::vector<std::uint32_t>& zone_of) {
    FaceSet faces(zone_of.size(), scope.zones.empty());
    for (const std::string& zone : scope.zones) add_zone(zone, preset, zone_of, finder, faces);
    const FaceSet selected = finder.selected(scope.selection);
    for (std::size_t i = 0; i < faces.size(); ++i) faces[i] = faces[i] && selected[i];
    if (std::find(faces.begin(), faces.end(), true) == faces.end())
        throw Error("", "scope", "no face is left to judge: " + scope.text());
    return faces;
}

} // namespace

FaceLimits zoned_limits(const ZonedBody& body, const CriteriaPreset& preset, const Scope& scope,
                        const Job& job) {
    if (preset.zones.empty() && scope.is_whole()) return preset;
    const StopScope stop(job);
    FaceFinder finder(body, job);
    FaceZones zones;
    zones.zone = first_zones(faces_of_zones(finder, preset), preset, finder.size());
    zones.in_scope = scope_of(finder, preset, scope, zones.zone);
    zones.scope = scope.text();
    return {body.model, preset, std::move(zones)};
}

FaceLimits limits_in(const Scene& scene, const CriteriaPreset& preset, const Scope& scope,
                     const Job& job) {
    return zoned_limits({scene.model, &scene.tracer, scene.ground()}, preset, scope, job);
}

} // namespace keiko
