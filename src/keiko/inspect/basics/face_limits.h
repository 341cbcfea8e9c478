#pragma once

#include "keiko/base/export.h"
#include "keiko/inspect/basics/placed_face.h"
#include "keiko/scene/criteria_preset.h"

#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace KEIKO_API keiko {

/// Number of the zone of a face, from 0, in a preset; `no_zone` for a face in none.
constexpr std::uint32_t no_zone = 0xffffffff;

/// Zones of the faces of a body, and the faces that are judged.
struct FaceZones {
    std::vector<std::uint32_t> zone; ///< of each of placed_faces(), into the zones of the preset
    std::vector<bool> in_scope;      ///< of each of placed_faces()
    std::string scope;               ///< Scope::text(), for people
};

/// Limits by which the faces of a body, and the seams between them, are judged.
class FaceLimits {
public:
    /// Limits of the default preset, for all of any body.
    FaceLimits() : FaceLimits(CriteriaPreset{}) {}
    /// Limits of a preset, for all of any body. Throws std::invalid_argument for one with zones,
    /// whose faces are yet to be found.
    FaceLimits(CriteriaPreset preset);
    /// Limits of a preset and its zones for a body.
    FaceLimits(const SurfaceModel& model, CriteriaPreset preset, FaceZones zones);

    /// The preset itself.
    const CriteriaPreset& preset() const { return preset_; }
    /// Limits of a face, whatever its neighbours.
    const CriteriaPreset& of(const PlacedFace& face) const;
    /// Limits of the seam between two faces, or inside one: the stricter of each criterion.
    const CriteriaPreset& between(const PlacedFace& a, const PlacedFace& b) const;
    /// The strictest limits of seams in any zone, or of the preset itself.
    const CriteriaPreset& strictest() const { return strictest_; }

    /// The zone of a face, or no_zone.
    std::uint32_t zone_of(const PlacedFace& face) const;
    /// True if a face is judged.
    bool in_scope(const PlacedFace& face) const;
    /// True if a seam between two faces is judged: one of them is.
    bool in_scope(const PlacedFace& a, const PlacedFace& b) const {
        return in_scope(a) || in_scope(b);
    }
    /// The part of the body that is judged, for people; empty if it is all of it.
    const std::string& scope() const { return zones_.scope; }
    /// True if faces have zones, or some are not judged.
    bool has_zones_or_scope() const { return !first_.empty(); }

private:
    std::size_t index_of(const PlacedFace& face) const { return first_[face.instance] + face.face; }
    /// Limits by number of a zone, the preset's own at the end.
    std::size_t number_of(const PlacedFace& face) const;
    void combine();

    CriteriaPreset preset_;
    CriteriaPreset strictest_;
    FaceZones zones_;
    /// Index of the first face of each instance in placed_faces(), less the number of that face.
    std::vector<std::size_t> first_;
    /// Limits of each pair of zones, rows first.
    std::vector<CriteriaPreset> pairs_;
};

} // namespace keiko
