#include "keiko/inspect/overlaps/body_crossings.h"

#include "keiko/base/units.h"
#include "keiko/geometry/bvh/box_tree.h"
#include "keiko/inspect/basics/placed_face.h"
#include "keiko/inspect/openings/bodies.h"
#include "keiko/inspect/overlaps/face_inside.h"
#include "keiko/intersect/traversal/tracer.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <set>

namespace keiko {
namespace {

/// The boxes of the control points of every placed patch, and what they belong to.
struct PatchBoxes {
    std::vector<PlacedFace> faces;
    std::vector<std::size_t> bodies;
    std::vector<Box3> boxes; ///< world, mm

    PatchBoxes(const SurfaceModel& model, const Bodies& all) {
        for (std::size_t i = 0; i < all.count(); ++i)
            for (const PlacedFace& of : all.faces(i)) add(model, of, i);
    }

private:
    void add(const SurfaceModel& model, const PlacedFace& of, std::size_t body) {
        const Face& face = model.faces[of.face];
        const Affine& placed = model.instances[of.instance].transform;
        for (std::uint32_t k = 0; k < face.patch_count; ++k) {
            faces.push_back(of), bodies.push_back(body);
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
          tree_(patches_.boxes) {
        Box3 all;
        for (const Box3& box : patches_.boxes) all.extend(box);
        size_ = all.size();
    }

    void leave_out(std::span<const Overlap> known) {
        for (const Overlap& overlap : known)
            if (overlap.kind == Overlap::Kind::crossing) known_.insert(pair_of(overlap.sides));
    }

    std::vector<Overlap> run(const Job& job) {
        edges_ = free_edges(borders_.curves, {}, 0, join_, job);
        list_chords();
        if (chords_.empty()) return {};
        std::vector<Ray> rays;
        for (const Chord& chord : chords_) rays.push_back(ray_of(chord));
        traced_ = placed_subset(borders_.model, met_);
        const Tracer tracer(traced_, {.join = join_}, job);
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
            const std::size_t body = bodies_.of(edges_.all[e].face());
            for (std::uint32_t k = 0; k + 1 < places.size(); ++k) {
                bool meets = false;
                for (const std::uint32_t i :
                     patches_near(places[k].position, places[k + 1].position)) {
                    const PlacedFace& on = patches_.faces[i];
                    const BodyPair pair = std::minmax(body, patches_.bodies[i]);
                    if (pair.first == pair.second || known_.count(pair) > 0) continue;
                    meets = true;
                    if (met.emplace(on.instance, on.face).second) met_.push_back(on);
                }
                if (meets) chords_.push_back({e, k});
            }
        }
    }

    /// Patches whose boxes meet those of the parts of a chord, each part short: the box of a long
    /// slanted chord holds much that is far from it.
    std::set<std::uint32_t> patches_near(const Vec3& a, const Vec3& b) const {
        constexpr double most_parts = 64;
        const double parts = std::ceil(most_parts * (b - a).length() / size_);
        std::set<std::uint32_t> near;
        for (double i = 0; i < parts; ++i) {
            Box3 box;
            box.extend(a + (b - a) * (i / parts)), box.extend(a + (b - a) * ((i + 1) / parts));
            const auto met = tree_.overlapping(box);
            near.insert(met.begin(), met.end());
        }
        return near;
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
        if (pair.first == pair.second || known_.count(pair) > 0 || !is_inside(hit)) return;
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

    /// True if a hit is farther than `join` from the borders of its face: those of bodies that
    /// touch side by side are nearer.
    bool is_inside(const Hit& hit) {
        const auto face =
            insides_.try_emplace(hit.face, traced_, traced_.faces[hit.face], join_).first;
        SurfaceDerivatives s;
        s.d[1][0] = hit.dpdu, s.d[0][1] = hit.dpdv;
        return face->second.is_inside(hit.patch, hit.uv, s);
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
    double size_ = 0; ///< mm, of the model
    PatchBoxes patches_;
    BoxTree tree_;
    FreeEdges edges_;          ///< every border of every face
    std::set<BodyPair> known_; ///< not searched
    std::vector<Chord> chords_;
    std::vector<PlacedFace> met_;                 ///< faces that chords may meet
    SurfaceModel traced_;                         ///< those faces
    std::map<std::uint32_t, FaceInside> insides_; ///< of faces with hits
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
