#include "keiko/inspect/openings/grooves.h"

#include "keiko/base/job.h"
#include "keiko/base/units.h"
#include "keiko/geometry/bvh/box_tree.h"
#include "keiko/geometry/model/closest_point.h"
#include "keiko/inspect/seams/face_strips.h"
#include "keiko/math/interval_set.h"

#include <algorithm>
#include <map>
#include <optional>
#include <set>
#include <tuple>
#include <utility>

namespace keiko {
namespace {

using FaceKey = std::pair<std::uint32_t, std::uint32_t>; ///< instance and face
using FacePair = std::pair<FaceKey, FaceKey>;            ///< the lower one first

FacePair pair_of(const FaceKey& a, const FaceKey& b) {
    return std::minmax(a, b);
}

FaceKey key_of(const PlacedFace& face) {
    return {face.instance, face.face};
}

/// A side of a crease.
struct CreaseSide {
    FaceKey face;
    const SeamSide* side;
};

/// The sides of creases between faces, and their chords.
class Creases {
public:
    explicit Creases(const SeamSides& sides) : tree_(list(sides)) {}

    const std::vector<SideChord>& chords() const { return chords_; }
    const CreaseSide& side_of(const SideChord& chord) const { return sides_[chord.side]; }
    std::vector<std::uint32_t> near(const Box3& box) const { return tree_.overlapping(box); }

private:
    std::vector<Box3> list(const SeamSides& sides) {
        std::vector<Box3> boxes;
        for (const auto& [face, of_face] : sides.by_face())
            for (const SeamSide& side : of_face) {
                if (!side.is_crease || side.is_inside) continue;
                for (const SideChord& chord :
                     chords_of(side, static_cast<std::uint32_t>(sides_.size())))
                    chords_.push_back(chord), boxes.push_back(chord.box());
                sides_.push_back({face, &side});
            }
        return boxes;
    }

    std::vector<CreaseSide> sides_;
    std::vector<SideChord> chords_;
    BoxTree tree_;
};

class GrooveSearch {
public:
    GrooveSearch(const SurfaceModel& model, const SeamSides& sides, std::set<FacePair> joined,
                 const OpeningLimits& limits, double feature_angle)
        : model_(model),
          sides_(sides),
          creases_(sides),
          joined_(std::move(joined)),
          limits_(limits),
          reach_(limits.join * (1 + rounding)),
          most_turn_(degrees_to_radians(feature_angle)) {}

    std::vector<Opening> run() {
        std::map<FacePair, Opening> found;
        for (std::uint32_t i = 0; i < creases_.chords().size(); ++i) add_beside(i, found);
        std::vector<Opening> all;
        for (const auto& [faces, opening] : found)
            if (opening.length > limits_.from) all.push_back(opening);
        return all;
    }

private:
    static constexpr double rounding = 1e-9; ///< share of the join distance

    void add_beside(std::uint32_t i, std::map<FacePair, Opening>& found);
    bool may_continue(const CreaseSide& a, const CreaseSide& b) const {
        return a.face < b.face && joined_.count({a.face, b.face}) == 0 &&
               !(a.side->neighbour == b.side->neighbour) && key_of(a.side->neighbour) != b.face &&
               key_of(b.side->neighbour) != a.face;
    }
    std::optional<Opening> across(const CreaseSide& a, double t, const SideChord& to);
    bool is_strip_beyond(const SeamSide& side, double t, const Vec3& place);
    bool continues(const BoundaryFrame& a, const BoundaryFrame& b) const;

    const SurfaceModel& model_;
    const SeamSides& sides_;
    Creases creases_;
    std::map<FaceKey, FaceStrips> strips_; ///< of faces beyond creases, made when first needed
    std::set<FacePair> joined_;            ///< faces that have a seam with each other
    const OpeningLimits& limits_;
    double reach_;     ///< mm: the join distance, and what rounding adds to it
    double most_turn_; ///< radians
};

/// Adds what lies beside a chord of the lower face.
void GrooveSearch::add_beside(std::uint32_t i, std::map<FacePair, Opening>& found) {
    check_stop();
    const SideChord& from = creases_.chords()[i];
    const CreaseSide& a = creases_.side_of(from);
    std::map<FaceKey, std::vector<ParameterInterval>> open;
    for (const std::uint32_t j : creases_.near(from.box().padded(reach_))) {
        const SideChord& to = creases_.chords()[j];
        const CreaseSide& b = creases_.side_of(to);
        if (!may_continue(a, b)) continue;
        const auto part = part_beside(from, to, reach_);
        if (!part) continue;
        std::optional<Opening> widest = across(a, from.t((part->begin + part->end) / 2), to);
        if (!widest) continue;
        for (const double share : {part->begin, part->end})
            if (const auto at = across(a, from.t(share), to); at && at->width > widest->width)
                widest = at;
        open[b.face].push_back(*part);
        Opening& groove = found.try_emplace({a.face, b.face}, *widest).first->second;
        if (widest->width > groove.width) widest->length = groove.length, groove = *widest;
    }
    for (auto& [face, parts] : open)
        found.at({a.face, face}).length += IntervalSet(std::move(parts)).measure() * from.length();
}

/// True if the face beyond a crease is a strip there, no wider than the join distance.
bool GrooveSearch::is_strip_beyond(const SeamSide& side, double t, const Vec3& place) {
    const FaceKey face = key_of(side.neighbour);
    const FaceStrips& strips =
        strips_.try_emplace(face, model_, side.neighbour, sides_.by_face().at(face)).first->second;
    return strips.nearest(side.beyond.curve, parameter_beyond(side, t, place), limits_.join)
        .has_value();
}

/// The groove at a place of one crease, across to a chord of another one; nullopt if there is none.
std::optional<Opening> GrooveSearch::across(const CreaseSide& a, double t, const SideChord& to) {
    constexpr double over = 0.5; // cosine
    const CreaseSide& b = creases_.side_of(to);
    const Vec3 place = a.side->own.curve.at(t).position;
    const ClosestPoint foot =
        closest_point(b.side->own.curve, place, to.t(nearest_on_segment(to.from, to.to, place)),
                      b.side->own.low(), b.side->own.high());
    const Vec3& facing = foot.point.position;
    if (!(foot.distance > limits_.gap && foot.distance <= reach_)) return std::nullopt;
    const auto at_a = a.side->own.curve.frame(t), at_b = b.side->own.curve.frame(foot.t);
    if (!at_a || !at_b || !continues(*at_a, *at_b)) return std::nullopt;
    const Vec3 way = (facing - place) / foot.distance;
    if (std::max(way.dot(at_a->inward), -way.dot(at_b->inward)) > over) return std::nullopt;
    if (is_strip_beyond(*a.side, t, place) || is_strip_beyond(*b.side, foot.t, facing))
        return std::nullopt;
    const auto placed = [](const FaceKey& face) { return PlacedFace{face.first, face.second}; };
    return Opening{.sides = {placed(a.face), placed(b.face)},
                   .width = foot.distance,
                   .is_groove = true,
                   .place = (place + facing) / 2};
}

/// True if one face would continue the other across the gap.
bool GrooveSearch::continues(const BoundaryFrame& a, const BoundaryFrame& b) const {
    const auto square = [&](const Vec3& v) { return v - a.tangent * v.dot(a.tangent); };
    return angle_between(square(-a.inward), square(b.inward)) <= most_turn_;
}

} // namespace

std::vector<Opening> grooves(const ModelBorders& borders, std::span<const MeasuredSeam> seams,
                             std::span<const Seam> pieces, const OpeningLimits& limits,
                             double feature_angle) {
    const SeamSides sides(borders, seams, pieces);
    std::set<FacePair> joined;
    for (const MeasuredSeam& seam : seams)
        joined.insert(pair_of({seam.instance_a, seam.face_a}, {seam.instance_b, seam.face_b}));
    return GrooveSearch(borders.model, sides, std::move(joined), limits, feature_angle).run();
}

} // namespace keiko
