#include "keiko/inspect/joints/panel_borders.h"

#include "keiko/base/parallel.h"
#include "keiko/geometry/seam/border_run.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace keiko {
namespace {

/// mm: largest distance of a border's polyline from the border.
constexpr double chord_error = 0.02;

} // namespace

PanelBorders::PanelBorders(const ModelBorders& borders, std::span<const Seam> seams, const Job& job)
    : borders_(borders), bodies_(borders.model, seams), tree_({}) {
    list_borders();
    for (const Seam& seam : seams) add_seam(seam.a, seam.b), add_seam(seam.b, seam.a);
    tree_ = BoxTree(list_chords());
    const std::vector<PlacedFace> faces = placed_faces(borders.model);
    surfaces_.resize(faces.size());
    for (std::size_t i = 0; i < faces.size(); ++i)
        surface_of_[{faces[i].instance, faces[i].face}] = i;
    if (body_count() < 2) return;
    parallel_for(faces.size(), job, "", [&](std::size_t i) {
        surfaces_[i].emplace(borders.model, faces[i].instance, faces[i].face);
    });
}

void PanelBorders::list_borders() {
    for (const BoundaryInterval& on : borders_.curves.all()) {
        const SurfaceCurve curve = borders_.curves.curve(on);
        by_face_[{on.instance, on.face}].push_back(static_cast<std::uint32_t>(all_.size()));
        all_.push_back(
            {on, curve, make_polyline(curve, chord_error), bodies_.of({on.instance, on.face})});
    }
}

void PanelBorders::add_seam(const BoundaryInterval& own, const BoundaryInterval& other) {
    joined_[{own.instance, own.face}].push_back({own, other});
}

std::vector<Box3> PanelBorders::list_chords() {
    constexpr std::size_t most = 8; // chords in a box
    std::vector<Box3> boxes;
    for (std::uint32_t i = 0; i < all_.size(); ++i) {
        const std::vector<Vec3>& points = all_[i].polyline.points;
        for (std::size_t k = 0; k + 1 < points.size(); k += most) {
            chords_.push_back({i, k, std::min(k + most, points.size() - 1)});
            boxes.emplace_back();
            for (std::size_t j = k; j <= chords_.back().end; ++j) boxes.back().extend(points[j]);
        }
    }
    return boxes;
}

std::span<const std::uint32_t> PanelBorders::of(const PlacedFace& face) const {
    const auto found = by_face_.find({face.instance, face.face});
    return found == by_face_.end() ? std::span<const std::uint32_t>() : found->second;
}

const FaceSurface& PanelBorders::surface(const PlacedFace& face) const {
    return surfaces_[surface_of_.at({face.instance, face.face})].value();
}

double PanelBorders::size(const PlacedFace& face) const {
    return borders_.sizes.of(face.instance, face.face);
}

/// False if all chords are too askew, or lie ahead or behind.
bool PanelBorders::may_face(const Chords& chords, const Vec3& place, const Vec3& along,
                            double radius) const {
    const CurvePolyline& line = all_[chords.border].polyline;
    const double askew = std::min(parallel_borders + line.turn, std::numbers::pi / 2);
    const double cosine = std::cos(askew) * (1 - 1e-9);
    // The way to a facing place is square to the mean of both directions.
    const double slab = radius * std::sin(parallel_borders / 2) + line.deviation + chord_error;
    for (std::size_t i = chords.begin; i < chords.end; ++i) {
        const Vec3 way = line.points[i + 1] - line.points[i];
        const double from = (line.points[i] - place).dot(along), length = way.dot(along);
        const bool beside =
            std::min(from, from + length) <= slab && std::max(from, from + length) >= -slab;
        if (beside && std::abs(length) >= cosine * way.length()) return true;
    }
    return false;
}

std::vector<std::uint32_t> PanelBorders::others_facing(std::size_t body, const Vec3& place,
                                                       const Vec3& along, double radius,
                                                       const Box3& box) const {
    std::vector<std::uint32_t> found;
    for (const std::uint32_t i : tree_.overlapping(box)) {
        const Chords& chords = chords_[i];
        if (all_[chords.border].body == body || (!found.empty() && found.back() == chords.border))
            continue;
        if (may_face(chords, place, along, radius)) found.push_back(chords.border);
    }
    return found;
}

const PanelBorders::Joined* PanelBorders::joined_at(const PanelBorder& border, double t) const {
    const auto found = joined_.find({border.on.instance, border.on.face});
    if (found == joined_.end()) return nullptr;
    for (const Joined& joined : found->second) {
        const auto [low, high] = std::minmax(joined.own.begin, joined.own.end);
        if (joined.own.curve == border.on.curve && low <= t && t <= high) return &joined;
    }
    return nullptr;
}

bool PanelBorders::is_free(const PanelBorder& border, double t) const {
    return joined_at(border, t) == nullptr;
}

std::optional<BorderNeighbour> PanelBorders::beyond(const PanelBorder& border, double t) const {
    const Joined* joined = joined_at(border, t);
    if (!joined) return std::nullopt;
    const BoundaryInterval &own = joined->own, &other = joined->other;
    const double share = own.end == own.begin ? 0 : (t - own.begin) / (own.end - own.begin);
    const auto [low, high] = std::minmax(other.begin, other.end);
    const SurfaceCurve curve = borders_.curves.curve(other);
    const ClosestPoint nearest =
        closest_point(curve, border.curve.at(t).position,
                      other.begin + share * (other.end - other.begin), low, high);
    const auto frame = curve.frame(nearest.t);
    if (!frame) return std::nullopt;
    return BorderNeighbour{{other.instance, other.face}, *frame, curve.parameters(nearest.t)};
}

} // namespace keiko
