#include "keiko/inspect/overlaps/body_crossings.h"

#include "keiko/base/units.h"
#include "keiko/geometry/bvh/box_tree.h"
#include "keiko/geometry/seam/border_approach.h"
#include "keiko/inspect/basics/placed_face.h"
#include "keiko/inspect/openings/bodies.h"
#include "keiko/inspect/openings/free_edges.h"
#include "keiko/intersect/hit/hit.h"
#include "keiko/intersect/traversal/tracer.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <set>

namespace keiko {
namespace {

/// Appends a copy of a curve's points; the edge that it belonged to is not kept.
TrimCurve copied(const SurfaceModel& from, TrimCurve curve, SurfaceModel& to) {
    const auto first = from.trim_points.begin() + curve.first_point;
    curve.first_point = static_cast<std::uint32_t>(to.trim_points.size());
    curve.edge = no_index;
    to.trim_points.insert(to.trim_points.end(), first, first + curve.degree + 1);
    return curve;
}

void add_patches(const SurfaceModel& from, Face& face, SurfaceModel& to) {
    const std::uint32_t first = face.first_patch;
    face.first_patch = static_cast<std::uint32_t>(to.patches.size());
    for (std::uint32_t i = first; i < first + face.patch_count; ++i) {
        Patch patch = from.patches[i];
        const auto points = from.patch(i).points;
        patch.face = static_cast<std::uint32_t>(to.faces.size());
        patch.first_point = static_cast<std::uint32_t>(to.control_points.size());
        to.control_points.insert(to.control_points.end(), points.begin(), points.end());
        to.patches.push_back(patch);
    }
}

void add_loops(const SurfaceModel& from, Face& face, SurfaceModel& to) {
    const auto loops = from.loops_of(face);
    face.first_loop = static_cast<std::uint32_t>(to.trim_loops.size());
    for (const TrimLoop& loop : loops) {
        to.trim_loops.push_back(
            {static_cast<std::uint32_t>(to.trim_curves.size()), loop.curve_count});
        for (const TrimCurve& curve : from.curves_of(loop))
            to.trim_curves.push_back(copied(from, curve, to));
    }
}

/// A model of some placed faces of another, without its edges: each is a part of its own, placed
/// once, in the order given.
SurfaceModel placed_subset(const SurfaceModel& model, std::span<const PlacedFace> faces) {
    SurfaceModel subset;
    subset.source = model.source, subset.format = model.format;
    for (const PlacedFace& of : faces) {
        const auto number = static_cast<std::uint32_t>(subset.faces.size());
        Face face = model.faces[of.face];
        face.part = number;
        add_patches(model, face, subset);
        add_loops(model, face, subset);
        subset.faces.push_back(face);
        subset.parts.push_back({"", number, 1});
        subset.instances.push_back({number, "", model.instances[of.instance].transform});
    }
    return subset;
}

/// The way of a border through a face that it meets at `hit`, `way` mm along the border.
struct BorderPassage {
    /// It leaves the tangent plane by more than half of `join` on both sides, within `join` / 2
    /// over sin `parallel_borders` of the hit.
    bool is_through = false;
    double length = 0; ///< mm of that way within `join` of the tangent plane
};

/// The place of a border, which goes round where it is closed.
Vec3 place_at(const FreeEdge& border, double way) {
    const double all = border.length();
    if (border.closed) way = std::fmod(std::fmod(way, all) + all, all);
    return border.at(std::clamp(way, 0.0, all)).position;
}

/// The way of a border through the face of `hit`, whose place is `way` mm along it; `join` in mm.
BorderPassage border_passage(const FreeEdge& border, double way, const Hit& hit, double join) {
    constexpr int steps = 16; // on either side
    const double step = join / 2 / std::sin(parallel_borders) / steps;
    BorderPassage passage;
    double most_before = 0, most_after = 0;
    for (int i = -steps; i <= steps; ++i) {
        const Vec3 off = place_at(border, way + i * step) - hit.position;
        const double offset = off.dot(hit.normal);
        if (std::abs(offset) <= join) passage.length += step;
        double& most = i < 0 ? most_before : most_after;
        if (std::abs(offset) > std::abs(most)) most = offset;
    }
    const auto [below, above] = std::minmax({most_before, most_after});
    passage.is_through = below < -join / 2 && above > join / 2;
    return passage;
}

/// The boxes of the control points of every placed patch, and the faces that they belong to.
struct PatchBoxes {
    std::vector<PlacedFace> faces;
    std::vector<Box3> boxes; ///< world, mm

    PatchBoxes(const SurfaceModel& model, const Bodies& bodies) {
        for (std::size_t i = 0; i < bodies.count(); ++i)
            for (const PlacedFace& of : bodies.faces(i)) add(model, of);
    }

private:
    void add(const SurfaceModel& model, const PlacedFace& of) {
        const Face& face = model.faces[of.face];
        const Affine& placed = model.instances[of.instance].transform;
        for (std::uint32_t k = 0; k < face.patch_count; ++k) {
            faces.push_back(of);
            boxes.push_back(PlacedPatch(model, face.first_patch + k, placed).box);
        }
    }
};

class CrossingSearch {
public:
    CrossingSearch(const ModelBorders& borders, const Bodies& bodies, double join)
        : borders_(borders),
          bodies_(bodies),
          join_(join),
          patches_(borders.model, bodies),
          tree_(patches_.boxes) {}

    void leave_out(std::span<const Overlap> known) {
        for (const Overlap& overlap : known)
            if (overlap.kind == Overlap::Kind::crossing) known_.insert(pair_of(overlap.sides));
    }

    std::vector<Overlap> run(const Job& job) {
        edges_ = free_edges(borders_.model, borders_.curves, {}, 0, join_, job);
        list_chords();
        if (chords_.empty()) return {};
        std::vector<Ray> rays;
        for (const Chord& chord : chords_) rays.push_back(ray_of(chord));
        const Tracer tracer(placed_subset(borders_.model, met_), {.join = join_}, job);
        const auto hits = tracer.all(rays);
        for (std::size_t i = 0; i < rays.size(); ++i)
            for (const Hit& hit : hits[i]) take(chords_[i], hit);
        std::vector<Overlap> crossings;
        for (const auto& [pair, crossing] : found_) crossings.push_back(crossing);
        return crossings;
    }

private:
    using BodyPair = std::pair<std::size_t, std::size_t>;

    /// A chord of a border's polyline that may meet another body.
    struct Chord {
        std::uint32_t edge, place; ///< into FreeEdges::all and FreeEdge::places
    };

    BodyPair pair_of(const std::array<PlacedFace, 2>& sides) const {
        return std::minmax({bodies_.of(sides[0]), bodies_.of(sides[1])});
    }

    /// Lists chords that may meet other bodies, and the faces that these may meet.
    void list_chords() {
        std::set<std::pair<std::uint32_t, std::uint32_t>> met;
        for (std::uint32_t e = 0; e < edges_.all.size(); ++e) {
            const std::vector<FreePlace>& places = edges_.all[e].places;
            const PlacedFace own = edges_.all[e].face();
            for (std::uint32_t k = 0; k + 1 < places.size(); ++k) {
                Box3 box;
                box.extend(places[k].position);
                box.extend(places[k + 1].position);
                bool meets = false;
                for (const std::uint32_t i : tree_.overlapping(box)) {
                    const PlacedFace& on = patches_.faces[i];
                    if (bodies_.of(on) == bodies_.of(own) || known_.count(pair_of({own, on})) > 0)
                        continue;
                    meets = true;
                    if (met.emplace(on.instance, on.face).second) met_.push_back(on);
                }
                if (meets) chords_.push_back({e, k});
            }
        }
    }

    Ray ray_of(const Chord& chord) const {
        const std::vector<FreePlace>& places = edges_.all[chord.edge].places;
        Ray ray;
        ray.origin = places[chord.place].position;
        ray.direction = places[chord.place + 1].position - ray.origin;
        ray.t_max = 1;
        return ray;
    }

    void take(const Chord& chord, const Hit& hit) {
        const FreeEdge& border = edges_.all[chord.edge];
        const PlacedFace on = met_[hit.face];
        const BodyPair pair = pair_of({border.face(), on});
        if (pair.first == pair.second || known_.count(pair) > 0) return;
        const double from = border.ways[chord.place], to = border.ways[chord.place + 1];
        const BorderPassage passage =
            border_passage(border, from + hit.t * (to - from), hit, join_);
        if (!passage.is_through) return;
        Overlap crossing{.kind = Overlap::Kind::crossing, .sides = {border.face(), on}};
        crossing.length = passage.length, crossing.place = hit.position;
        crossing.angle = angle_at(border.places[chord.place], hit);
        const auto [known, is_new] = found_.try_emplace(pair, crossing);
        if (!is_new && crossing.angle > known->second.angle) known->second = crossing;
    }

    /// Degrees between the faces of a border and of a hit, 0 to 90.
    double angle_at(const FreePlace& place, const Hit& hit) const {
        const BoundaryInterval& piece = edges_.all[place.edge].pieces[place.piece];
        const auto frame = borders_.curves.curve(piece).frame(place.t);
        if (!frame) return 0;
        const double angle = radians_to_degrees(angle_between(frame->normal, hit.normal));
        return std::min(angle, 180 - angle);
    }

    const ModelBorders& borders_;
    const Bodies& bodies_;
    double join_;
    PatchBoxes patches_;
    BoxTree tree_;
    FreeEdges edges_;          ///< every border of every face
    std::set<BodyPair> known_; ///< not searched
    std::vector<Chord> chords_;
    std::vector<PlacedFace> met_; ///< faces that chords may meet
    std::map<BodyPair, Overlap> found_;
};

} // namespace

std::vector<Overlap> body_crossings(const ModelBorders& borders, std::span<const Seam> seams,
                                    std::span<const Overlap> known, double join, const Job& job) {
    // Parts of an assembly are bodies of their own, though their borders touch.
    std::vector<Seam> within_parts;
    std::copy_if(seams.begin(), seams.end(), std::back_inserter(within_parts),
                 [](const Seam& seam) { return seam.a.instance == seam.b.instance; });
    const Bodies bodies(borders.model, within_parts);
    if (bodies.count() < 2) return {};
    CrossingSearch search(borders, bodies, join);
    search.leave_out(known);
    return search.run(job);
}

} // namespace keiko
