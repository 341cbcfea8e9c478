#include "keiko/inspect/seams/narrow_faces.h"

#include "keiko/base/parallel.h"
#include "keiko/base/units.h"
#include "keiko/geometry/bvh/box_tree.h"
#include "keiko/geometry/model/closest_point.h"
#include "keiko/geometry/seam/border_run.h"
#include "keiko/inspect/seams/seam_sides.h"
#include "keiko/math/interval_set.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace keiko {
namespace {

/// mm: largest distance of the polyline of a side from the side.
constexpr double chord_error = 0.002;

/// A straight piece of a polyline; world, mm.
struct Chord {
    Vec3 from{0}; ///< its begin
    Vec3 to{0};   ///< its end

    /// mm.
    double length() const { return (to - from).length(); }
    /// The point at a share of it, 0 at `from` and 1 at `to`.
    Vec3 at(double share) const { return from + (to - from) * share; }
};

/// Shares s at which low <= from + s * slope <= high.
ParameterInterval between(double from, double slope, double low, double high) {
    if (slope == 0)
        return low <= from && from <= high ? ParameterInterval{0, 1} : ParameterInterval{1, 0};
    const auto [begin, end] = std::minmax({(low - from) / slope, (high - from) / slope});
    return {begin, end};
}

/// Shares s at which |from + s * slope| <= reach.
ParameterInterval within(const Vec3& from, const Vec3& slope, double reach) {
    const double a = slope.length2(), b = from.dot(slope), c = from.length2() - reach * reach;
    if (a == 0) return c <= 0 ? ParameterInterval{0, 1} : ParameterInterval{1, 0};
    const double square = b * b - a * c;
    if (!(square >= 0)) return {1, 0};
    return {(-b - std::sqrt(square)) / a, (-b + std::sqrt(square)) / a};
}

/// The part of `chord` that runs beside `other`: from each of its places the foot of the
/// perpendicular on the line of `other` lies on `other`, at most `reach` mm away. Shares of
/// `chord`; nullopt if there is none, or if the chords diverge by more than `parallel_borders`.
std::optional<ParameterInterval> part_beside(const Chord& chord, const Chord& other, double reach) {
    const double length = other.length();
    const Vec3 way = chord.to - chord.from;
    if (!(length > 0) || !nearly_parallel(way, other.to - other.from, std::sin(parallel_borders)))
        return std::nullopt;
    const Vec3 along = (other.to - other.from) / length;
    const Vec3 start = chord.from - other.from;
    const ParameterInterval on = between(start.dot(along), way.dot(along), 0, length);
    const ParameterInterval near =
        within(start - along * start.dot(along), way - along * way.dot(along), reach);
    const ParameterInterval part{std::max({0.0, on.begin, near.begin}),
                                 std::min({1.0, on.end, near.end})};
    return part.begin < part.end ? std::optional(part) : std::nullopt;
}

/// The point of a line that is nearest to a place.
ClosestPoint foot_on(const SeamSide::Line& line, const Vec3& place, double guess) {
    return closest_point(line.curve, place, guess, line.low(), line.high());
}

class StripSearch {
public:
    StripSearch(const SurfaceModel& model, const PlacedFace& face,
                const std::vector<SeamSide>& sides, const CriteriaPreset& limits, double join)
        : model_(model),
          sides_(sides),
          limits_(limits),
          face_(face),
          join_(join),
          tree_(list_chords()) {}

    std::optional<NarrowFace> run(NarrowFace::Kind kind) {
        NarrowFace found{.kind = kind, .face = face_};
        double negligible = 0;
        for (std::uint32_t i = 0; i < chords_.size(); ++i) {
            const SeamSide& side = sides_[chords_[i].side];
            if (side.is_crease != (kind == NarrowFace::Kind::beside_crease)) continue;
            const double length = narrow_length(i, found);
            found.length += length;
            if (length > 0) negligible = std::max(negligible, side.negligible);
        }
        return found.length > negligible ? std::optional(found) : std::nullopt;
    }

private:
    /// A chord of the polyline of a side.
    struct SideChord {
        std::uint32_t side;
        double t_from, t_to; ///< parameters of the border
        Chord chord;

        double t(double share) const { return t_from + share * (t_to - t_from); }
    };

    /// Places of two sides that face each other over the material of the face.
    struct Across {
        BoundaryFrame near, far;
        double t_near, t_far;
    };

    std::vector<Box3> list_chords();
    double narrow_length(std::uint32_t i, NarrowFace& found);
    std::optional<Across> across(const SideChord& from, double share, const SideChord& to,
                                 double reach);
    bool is_material_between(const Across& at, const SurfaceCurve& from, const SurfaceCurve& to);
    bool take(const Across& at, const SeamSide& near, const SeamSide& far, NarrowFace& found) const;
    std::optional<BoundaryFrame> beyond(const SeamSide& side, double t, const Vec3& place) const;

    const SurfaceModel& model_;
    const std::vector<SeamSide>& sides_;
    const CriteriaPreset& limits_;
    PlacedFace face_;
    double join_;
    std::vector<SideChord> chords_;
    BoxTree tree_;
    std::optional<KnottedFace> surface_; ///< made on first use
};

std::vector<Box3> StripSearch::list_chords() {
    std::vector<Box3> boxes;
    for (std::uint32_t side = 0; side < sides_.size(); ++side) {
        const SurfaceCurve& curve = sides_[side].own.curve;
        const double begin = sides_[side].own.low(), end = sides_[side].own.high();
        const CurvePolyline line = make_polyline(curve, chord_error);
        double t = begin;
        Vec3 from = curve.at(begin).position;
        const auto add = [&](double t_to, const Vec3& to) {
            chords_.push_back({side, t, t_to, {from, to}});
            boxes.emplace_back();
            boxes.back().extend(from);
            boxes.back().extend(to);
            t = t_to, from = to;
        };
        for (std::size_t k = 0; k < line.t.size(); ++k)
            if (line.t[k] > begin && line.t[k] < end) add(line.t[k], line.points[k]);
        add(end, curve.at(end).position);
    }
    return boxes;
}

/// mm of a chord along which the face has a strip of the kind; `found` takes the worst place.
double StripSearch::narrow_length(std::uint32_t i, NarrowFace& found) {
    const SideChord& from = chords_[i];
    const bool of_crease = found.kind == NarrowFace::Kind::beside_crease;
    const double reach = of_crease ? join_ : sides_[from.side].negligible;
    Box3 box;
    box.extend(from.chord.from);
    box.extend(from.chord.to);
    std::vector<ParameterInterval> narrow;
    for (const std::uint32_t j : tree_.overlapping(box.padded(reach))) {
        const SideChord& to = chords_[j];
        const SeamSide &near = sides_[from.side], &far = sides_[to.side];
        const bool is_second = of_crease ? far.is_crease && j <= i : far.is_crease || j <= i;
        if (is_second) continue; // found from there
        const auto part = part_beside(from.chord, to.chord, reach);
        const auto middle =
            part ? across(from, (part->begin + part->end) / 2, to, reach) : std::nullopt;
        if (!middle || !take(*middle, near, far, found)) continue;
        narrow.push_back(*part);
        for (const double share : {part->begin, part->end})
            if (const auto at = across(from, share, to, reach)) take(*at, near, far, found);
    }
    return IntervalSet(std::move(narrow)).measure() * from.chord.length();
}

std::optional<StripSearch::Across> StripSearch::across(const SideChord& from, double share,
                                                       const SideChord& to, double reach) {
    constexpr double same_place = 1e-6; // mm: closer sides have no direction across
    const SeamSide::Line &own = sides_[from.side].own, &opposite = sides_[to.side].own;
    const double t = from.t(share);
    const auto near = own.curve.frame(t);
    if (!near) return std::nullopt;
    const double guess = to.t(nearest_on_segment(to.chord.from, to.chord.to, near->position));
    const ClosestPoint foot = foot_on(opposite, near->position, guess);
    const auto far = opposite.curve.frame(foot.t);
    if (!far || foot.distance > reach || !(foot.distance > same_place)) return std::nullopt;
    const Across at{*near, *far, t, foot.t};
    return is_material_between(at, own.curve, opposite.curve) ? std::optional(at) : std::nullopt;
}

/// True if the straight path in the parameters leads into the material at both of its ends and is
/// at most twice as long as the distance between them: more than around half a circle. It is longer
/// from one border to the other of a face that is rolled up.
bool StripSearch::is_material_between(const Across& at, const SurfaceCurve& from,
                                      const SurfaceCurve& to) {
    if (!surface_) surface_.emplace(model_, face_.face);
    constexpr int steps = 8;
    constexpr double longest = 2, into = 0.5;
    const Affine& placed = model_.instances[face_.instance].transform;
    const Vec2 begin = from.parameters(at.t_near), end = to.parameters(at.t_far);
    double length = 0;
    Vec3 last = at.near.position;
    for (int i = 1; i <= steps; ++i) {
        const Vec3 next =
            placed.point(surface_->point(begin + (end - begin) * (double(i) / steps)));
        const Vec3 way = next - last;
        if (i == 1 && !(way.dot(at.near.inward) > into * way.length())) return false;
        if (i == steps && !(-way.dot(at.far.inward) > into * way.length())) return false;
        length += way.length(), last = next;
    }
    return length <= longest * (at.far.position - at.near.position).length();
}

/// The frame of the seam's other side at a place.
std::optional<BoundaryFrame> StripSearch::beyond(const SeamSide& side, double t,
                                                 const Vec3& place) const {
    const ParameterInterval& on = side.own.on;
    const double guess = side.beyond.at((t - on.begin) / (on.end - on.begin));
    return side.beyond.curve.frame(foot_on(side.beyond, place, guess).t);
}

/// False if the place is no part of such a strip.
bool StripSearch::take(const Across& at, const SeamSide& near, const SeamSide& far,
                       NarrowFace& found) const {
    const auto a = beyond(near, at.t_near, at.near.position);
    const auto b = beyond(far, at.t_far, at.far.position);
    const Vec3 way = at.far.position - at.near.position, run = at.near.tangent;
    double step = 0, angle = 0;
    if (a && b) {
        const auto across = [&](const Vec3& v) { return v - run * v.dot(run); };
        step = std::max(std::abs(way.dot(a->normal)), std::abs(way.dot(b->normal)));
        angle = radians_to_degrees(angle_between(across(-a->inward), across(b->inward)));
        if (angle <= angle_rounding) angle = 0;
    }
    const bool is_kink = found.kind == NarrowFace::Kind::kink;
    if (is_kink && !(angle > limits_.angle && angle < limits_.feature_angle)) return false;
    if (found.width > 0 && (is_kink ? angle <= found.angle : step <= found.step)) return true;
    found.width = way.length(), found.step = step, found.angle = angle;
    found.place = (at.near.position + at.far.position) / 2;
    found.neighbours = {near.neighbour, far.neighbour};
    return true;
}

} // namespace

std::vector<NarrowFace> narrow_faces(const ModelBorders& borders,
                                     std::span<const MeasuredSeam> seams,
                                     std::span<const Seam> pieces, const CriteriaPreset& limits,
                                     double join, const Job& job) {
    const SeamSides sides(borders, seams, pieces);
    std::vector<const SeamSides::ByFace::value_type*> faces;
    for (const auto& face : sides.by_face()) faces.push_back(&face);
    using Kind = NarrowFace::Kind;
    std::vector<std::array<std::optional<NarrowFace>, 2>> found(faces.size());
    parallel_for(faces.size(), job, "", [&](std::size_t i) {
        const auto& [face, of_face] = *faces[i];
        StripSearch search(borders.model, {face.first, face.second}, of_face, limits, join);
        found[i] = {search.run(Kind::beside_crease), search.run(Kind::kink)};
    });
    std::vector<NarrowFace> narrow;
    for (const auto& face : found)
        for (const auto& strip : face)
            if (strip) narrow.push_back(*strip);
    return narrow;
}

} // namespace keiko
