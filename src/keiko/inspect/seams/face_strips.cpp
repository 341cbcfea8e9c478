#include "keiko/inspect/seams/face_strips.h"

#include "keiko/geometry/model/closest_point.h"
#include "keiko/geometry/seam/border_run.h"

#include <algorithm>
#include <cmath>

namespace keiko {
namespace {

/// mm: largest distance of the polyline of a side from the side.
constexpr double chord_error = 0.002;

/// The point of a line that is nearest to a place.
ClosestPoint foot_on(const SeamSide::Line& line, const Vec3& place, double guess) {
    return closest_point(line.curve, place, guess, line.low(), line.high());
}

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

} // namespace

std::vector<SideChord> chords_of(const SeamSide& side, std::uint32_t number) {
    const SurfaceCurve& curve = side.own.curve;
    const double begin = side.own.low(), end = side.own.high();
    const CurvePolyline line = make_polyline(curve, chord_error);
    std::vector<SideChord> chords;
    double t = begin;
    Vec3 from = curve.at(begin).position;
    const auto add = [&](double t_to, const Vec3& to) {
        chords.push_back({number, t, t_to, from, to});
        t = t_to, from = to;
    };
    for (std::size_t k = 0; k < line.t.size(); ++k)
        if (line.t[k] > begin && line.t[k] < end) add(line.t[k], line.points[k]);
    add(end, curve.at(end).position);
    return chords;
}

std::optional<ParameterInterval> part_beside(const SideChord& chord, const SideChord& other,
                                             double reach) {
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

FaceStrips::FaceStrips(const SurfaceModel& model, const PlacedFace& face,
                       const std::vector<SeamSide>& sides)
    : model_(model), sides_(sides), face_(face), tree_(list_chords()), surface_(model, face.face) {}

std::vector<Box3> FaceStrips::list_chords() {
    std::vector<Box3> boxes;
    for (std::uint32_t side = 0; side < sides_.size(); ++side)
        for (const SideChord& chord : chords_of(sides_[side], side))
            chords_.push_back(chord), boxes.push_back(chord.box());
    return boxes;
}

std::optional<StripPlace> FaceStrips::across(const SurfaceCurve& border, double t,
                                             const SideChord& to, double reach) const {
    constexpr double same_place = 1e-6; // mm: closer sides have no direction across
    const SeamSide::Line& opposite = sides_[to.side].own;
    const Vec3 place = border.at(t).position;
    const ClosestPoint foot =
        foot_on(opposite, place, to.t(nearest_on_segment(to.from, to.to, place)));
    if (foot.distance > reach || !(foot.distance > same_place)) return std::nullopt;
    const auto near = border.frame(t), far = opposite.curve.frame(foot.t);
    if (!near || !far) return std::nullopt;
    const StripPlace at{*near, *far, foot.t, to.side};
    const Vec2 begin = border.parameters(t), end = opposite.curve.parameters(foot.t);
    return is_material_between(at, begin, end) ? std::optional(at) : std::nullopt;
}

std::optional<StripPlace> FaceStrips::nearest(const SurfaceCurve& border, double t,
                                              double reach) const {
    Box3 box;
    box.extend(border.at(t).position);
    std::optional<StripPlace> best;
    for (const std::uint32_t j : near(box.padded(reach))) {
        const SideChord& chord = chords_[j];
        const SeamSide& side = sides_[chord.side];
        if (side.is_inside && side.leads_on) continue;
        const bool is_here = t >= chord.t_from && t <= chord.t_to;
        if (is_here && side.own.curve.is_same(border)) continue;
        const auto at = across(border, t, chord, best ? best->width() : reach);
        if (at && nearly_parallel(at->near.tangent, at->far.tangent, std::sin(parallel_borders)))
            best = at;
    }
    return best;
}

/// True if the straight path in the parameters leads into the material at both of its ends and is
/// at most twice as long as the distance between them: more than around half a circle. It is longer
/// from one border to the other of a face that is rolled up.
bool FaceStrips::is_material_between(const StripPlace& at, const Vec2& begin,
                                     const Vec2& end) const {
    constexpr int steps = 8;
    constexpr double longest = 2, into = 0.5;
    const Affine& placed = model_.instances[face_.instance].transform;
    double length = 0;
    Vec3 last = at.near.position;
    for (int i = 1; i <= steps; ++i) {
        const Vec3 next = placed.point(surface_.point(begin + (end - begin) * (double(i) / steps)));
        const Vec3 way = next - last;
        if (i == 1 && !(way.dot(at.near.inward) > into * way.length())) return false;
        if (i == steps && !(-way.dot(at.far.inward) > into * way.length())) return false;
        length += way.length(), last = next;
    }
    return length <= longest * (at.far.position - at.near.position).length();
}

double parameter_beyond(const SeamSide& side, double t, const Vec3& place) {
    const ParameterInterval& on = side.own.on;
    const double guess = side.beyond.at((t - on.begin) / (on.end - on.begin));
    return foot_on(side.beyond, place, guess).t;
}

} // namespace keiko
