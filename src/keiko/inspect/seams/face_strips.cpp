#include "keiko/inspect/seams/face_strips.h"

#include "keiko/geometry/model/closest_point.h"
#include "keiko/geometry/seam/border_approach.h"

#include <cmath>

namespace keiko {
namespace {

/// mm: largest distance of the polyline of a side from the side.
constexpr double chord_error = 0.002;

/// The point of a line that is nearest to a place.
ClosestPoint foot_on(const SeamSide::Line& line, const Vec3& place, double guess) {
    return closest_point(line.curve, place, guess, line.low(), line.high());
}

} // namespace

FaceStrips::FaceStrips(const SurfaceModel& model, const PlacedFace& face,
                       const std::vector<SeamSide>& sides)
    : model_(model), sides_(sides), face_(face), tree_(list_chords()), surface_(model, face.face) {}

std::vector<Box3> FaceStrips::list_chords() {
    std::vector<Box3> boxes;
    for (std::uint32_t side = 0; side < sides_.size(); ++side) {
        const SurfaceCurve& curve = sides_[side].own.curve;
        const double begin = sides_[side].own.low(), end = sides_[side].own.high();
        const CurvePolyline line = make_polyline(curve, chord_error);
        double t = begin;
        Vec3 from = curve.at(begin).position;
        const auto add = [&](double t_to, const Vec3& to) {
            chords_.push_back({side, t, t_to, from, to});
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
