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
    std::vector<Box3> boxes;
    for (std::uint32_t i = 0; i < all_.size(); ++i) {
        const std::vector<Vec3>& points = all_[i].polyline.points;
        for (std::size_t k = 0; k + 1 < points.size(); ++k) {
            chords_.push_back({i, points[k], points[k + 1]});
            boxes.emplace_back();
            boxes.back().extend(points[k]), boxes.back().extend(points[k + 1]);
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

/// True unless a chord is too askew, or lies ahead or behind.
bool PanelBorders::may_face(const Chord& chord, const Vec3& place, const Vec3& along,
                            double radius) const {
    const CurvePolyline& line = all_[chord.border].polyline;
    const Vec3 way = chord.to - chord.from;
    const double askew = std::min(parallel_borders + line.turn, std::numbers::pi / 2);
    if (std::abs(way.dot(along)) < std::cos(askew) * way.length() * (1 - 1e-9)) return false;
    // The way to a facing place is square to the mean of both directions.
    const double slab = radius * std::sin(parallel_borders / 2) + line.deviation + chord_error;
    const double from = (chord.from - place).dot(along), to = (chord.to - place).dot(along);
    return std::min(from, to) <= slab && std::max(from, to) >= -slab;
}

std::vector<std::uint32_t> PanelBorders::others_facing(std::size_t body, const Vec3& place,
                                                       const Vec3& along, double radius) const {
    Box3 box;
    box.extend(place);
    std::vector<std::uint32_t> found;
    for (const std::uint32_t i : tree_.overlapping(box.padded(radius))) {
        const Chord& chord = chords_[i];
        if (all_[chord.border].body != body && may_face(chord, place, along, radius))
            found.push_back(chord.border);
    }
    found.erase(std::unique(found.begin(), found.end()), found.end());
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
