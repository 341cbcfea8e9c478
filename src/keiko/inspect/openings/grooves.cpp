#include "keiko/inspect/openings/grooves.h"

#include "keiko/base/job.h"
#include "keiko/base/units.h"
#include "keiko/geometry/bvh/box_tree.h"
#include "keiko/geometry/model/closest_point.h"
#include "keiko/inspect/seams/face_strips.h"
#include "keiko/math/interval_set.h"

#include <algorithm>
#include <map>
#include <numbers>
#include <optional>
#include <utility>

namespace keiko {
namespace {

using FaceKey = std::pair<std::uint32_t, std::uint32_t>; ///< instance and face
using FacePair = std::pair<FaceKey, FaceKey>;            ///< the lower one first

FaceKey key_of(const PlacedFace& face) {
    return {face.instance, face.face};
}

PlacedFace placed(const FaceKey& face) {
    return {face.first, face.second};
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

/// Frames at a place of a crease: of its own border and of the one beyond.
using CreaseFrames = std::array<BoundaryFrame, 2>;

/// A place of a side of a crease.
struct CreasePlace {
    const CreaseSide& of;
    double t; ///< parameter of its border
    Vec3 at;

    /// nullopt where a side has none, or where the crease itself has a gap wider than allowed.
    std::optional<CreaseFrames> frames(double gap) const {
        const auto own = of.side->own.curve.frame(t);
        const auto beyond = of.side->beyond.curve.frame(parameter_beyond(*of.side, t, at));
        if (!own || !beyond || (own->position - beyond->position).length() > gap)
            return std::nullopt;
        return CreaseFrames{*own, *beyond};
    }
};

/// Radians by which face `b` turns from face `a` across the way between them; nullopt where one of
/// them reaches into the gap.
std::optional<double> turn_across(const BoundaryFrame& a, const BoundaryFrame& b, const Vec3& way) {
    constexpr double over = 0.5, no_way = 1e-6; // cosine, mm
    const double most = std::max(way.dot(a.inward), -way.dot(b.inward));
    if (way.length() > no_way && most > over * way.length()) return std::nullopt;
    const auto square = [&](const Vec3& v) { return v - a.tangent * v.dot(a.tangent); };
    return angle_between(square(-a.inward), square(b.inward));
}

/// The smallest turn between a face of one crease and a face of the other; radians.
double least_turn(const CreaseFrames& a, const CreaseFrames& b, const Vec3& way) {
    double least = std::numbers::pi;
    for (const BoundaryFrame& of_a : a)
        for (const BoundaryFrame& of_b : b)
            least = std::min(least, turn_across(of_a, of_b, way).value_or(least));
    return least;
}

class GrooveSearch {
public:
    GrooveSearch(const SurfaceModel& model, const SeamSides& sides, const OpeningLimits& limits,
                 const CriteriaPreset& preset)
        : model_(model),
          sides_(sides),
          creases_(sides),
          limits_(limits),
          preset_(preset),
          reach_(limits.join * (1 + rounding)) {}

    std::vector<Groove> run() {
        std::map<FacePair, Groove> found;
        for (std::uint32_t i = 0; i < creases_.chords().size(); ++i) add_beside(i, found);
        std::vector<Groove> all;
        for (auto& [faces, groove] : found) {
            if (faces.first == faces.second) groove.length /= 2; // seen from either crease
            if (groove.length > limits_.from) all.push_back(groove);
        }
        return all;
    }

private:
    static constexpr double rounding = 1e-9; ///< share of the join distance
    static constexpr double most_turn = 85;  ///< degrees, as of openings

    void add_beside(std::uint32_t i, std::map<FacePair, Groove>& found);
    std::optional<Groove> widest(const SideChord& from, const SideChord& to,
                                 const ParameterInterval& part);
    std::optional<Groove> across(const CreaseSide& a, double t, const SideChord& to);
    bool may_be(double width, double turn, bool is_one_face) const;
    bool is_closed(const CreasePlace& from, const CreasePlace& to);
    bool is_seam_at(const CreasePlace& place, const FaceKey& with);
    const FaceStrips& strips_of(const FaceKey& face) {
        return strips_.try_emplace(face, model_, placed(face), sides_.by_face().at(face))
            .first->second;
    }

    const SurfaceModel& model_;
    const SeamSides& sides_;
    Creases creases_;
    std::map<FaceKey, FaceStrips> strips_; ///< made when first needed
    const OpeningLimits& limits_;
    const CriteriaPreset& preset_;
    double reach_; ///< mm: the join distance, and what rounding adds to it
};

/// Adds what lies beside a chord of the lower face.
void GrooveSearch::add_beside(std::uint32_t i, std::map<FacePair, Groove>& found) {
    check_stop();
    const SideChord& from = creases_.chords()[i];
    const FaceKey& a = creases_.side_of(from).face;
    std::map<FaceKey, std::vector<ParameterInterval>> open;
    for (const std::uint32_t j : creases_.near(from.box().padded(reach_))) {
        const SideChord& to = creases_.chords()[j];
        const FaceKey& b = creases_.side_of(to).face;
        if (b < a || i == j) continue;
        const auto part = part_beside(from, to, reach_);
        if (!part) continue;
        const std::optional<Groove> here = widest(from, to, *part);
        if (!here) continue;
        open[b].push_back(*part);
        Groove& groove = found.try_emplace({a, b}, *here).first->second;
        if (here->width > groove.width) {
            const double length = groove.length;
            groove = *here, groove.length = length;
        }
    }
    for (auto& [b, parts] : open)
        found.at({a, b}).length += IntervalSet(std::move(parts)).measure() * from.length();
}

/// The groove between parts of two chords, where it is widest; nullopt if there is none in the
/// middle.
std::optional<Groove> GrooveSearch::widest(const SideChord& from, const SideChord& to,
                                           const ParameterInterval& part) {
    const CreaseSide& a = creases_.side_of(from);
    std::optional<Groove> most = across(a, from.t((part.begin + part.end) / 2), to);
    if (!most) return std::nullopt;
    for (const double share : {part.begin, part.end})
        if (const auto at = across(a, from.t(share), to); at && at->width > most->width) most = at;
    return most;
}

/// True if a gap or a kink of this size is worth a look. `is_one_face`: a face beside itself, which
/// has no kink.
bool GrooveSearch::may_be(double width, double turn, bool is_one_face) const {
    if (width > limits_.gap) return turn <= most_turn;
    return !is_one_face && turn > preset_.angle && turn <= preset_.feature_angle;
}

/// The groove at a place of one crease, across to a chord of another one; nullopt if there is none,
/// or if other faces of the two creases continue each other with a smaller turn.
std::optional<Groove> GrooveSearch::across(const CreaseSide& a, double t, const SideChord& to) {
    const CreaseSide& b = creases_.side_of(to);
    const Vec3 from = a.side->own.curve.at(t).position;
    const ClosestPoint foot =
        closest_point(b.side->own.curve, from, to.t(nearest_on_segment(to.from, to.to, from)),
                      b.side->own.low(), b.side->own.high());
    if (!(foot.distance <= reach_)) return std::nullopt;
    const CreasePlace at_a{a, t, from}, at_b{b, foot.t, foot.point.position};
    const auto frames_a = at_a.frames(limits_.gap), frames_b = at_b.frames(limits_.gap);
    if (!frames_a || !frames_b) return std::nullopt;
    const Vec3 way = at_b.at - at_a.at;
    const std::optional<double> turn = turn_across(frames_a->front(), frames_b->front(), way);
    if (!turn || !may_be(foot.distance, radians_to_degrees(*turn), a.face == b.face))
        return std::nullopt;
    if (turn > least_turn(*frames_a, *frames_b, way) || is_seam_at(at_a, b.face) ||
        is_closed(at_a, at_b) || is_closed(at_b, at_a))
        return std::nullopt;
    return Groove{.sides = {placed(a.face), placed(b.face)},
                  .width = foot.distance,
                  .turn = radians_to_degrees(*turn),
                  .place = (at_a.at + at_b.at) / 2};
}

/// True if a chain of strips, none wider than the join distance, leads from the face beyond one
/// crease to the other face.
bool GrooveSearch::is_closed(const CreasePlace& from, const CreasePlace& to) {
    constexpr int most_strips = 8;
    const SeamSide* side = from.of.side;
    double t = from.t;
    Vec3 at = from.at;
    for (int i = 0; i < most_strips; ++i) {
        const FaceStrips& strips = strips_of(key_of(side->neighbour));
        const auto next =
            strips.nearest(side->beyond.curve, parameter_beyond(*side, t, at), limits_.join);
        if (!next) return false;
        side = &strips.sides()[next->side_far];
        t = next->t_far, at = next->far.position;
        if (key_of(side->neighbour) == to.of.face && (at - to.at).length() <= reach_) return true;
    }
    return false;
}

/// True if the face at a place has a seam with another one within the join distance.
bool GrooveSearch::is_seam_at(const CreasePlace& place, const FaceKey& with) {
    const FaceStrips& own = strips_of(place.of.face);
    Box3 box;
    box.extend(place.at);
    for (const std::uint32_t j : own.near(box.padded(reach_))) {
        const SideChord& chord = own.chords()[j];
        const SeamSide& side = own.sides()[chord.side];
        if (side.is_inside || key_of(side.neighbour) != with) continue;
        if (segment_distance(chord.from, chord.to, place.at) <= reach_) return true;
    }
    return false;
}

} // namespace

std::vector<Groove> grooves(const ModelBorders& borders, std::span<const MeasuredSeam> seams,
                            std::span<const Seam> pieces, const OpeningLimits& limits,
                            const CriteriaPreset& preset) {
    const SeamSides sides(borders, seams, pieces);
    return GrooveSearch(borders.model, sides, limits, preset).run();
}

} // namespace keiko
