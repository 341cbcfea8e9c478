#include "keiko/base/units.h"
#include "keiko/inspect/structure/face_structure.h"
#include "keiko/inspect/structure/least_value.h"
#include "keiko/inspect/structure/net_structure.h"
#include "keiko/inspect/structure/span_nets.h"
#include "keiko/inspect/structure/span_widths.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace keiko {
namespace {

using Nets = std::vector<SpanNet>;

MeasuredValue at_most(double value, int limit, const Vec3& place) {
    return {value, 0, double(limit), place, judge(value, 0, limit), false};
}

/// The patch's place at (1/2, 1/2).
Vec3 middle_of_patch(const SpanNet& net) {
    const BezierPatchView view{net.patch->degree_u, net.patch->degree_v, net.placed.points};
    return net.world(evaluate(view, Vec2(0.5), 0).position());
}

MeasuredValue degree(const Nets& nets, int limit) {
    int most = 0;
    for (const SpanNet& net : nets)
        most = std::max({most, int{net.patch->degree_u}, int{net.patch->degree_v}});
    return at_most(most, limit, middle_of_patch(nets.front()));
}

MeasuredValue span_count(const Nets& nets, int limit) {
    const std::size_t most = std::max(spans_of(nets, true).size(), spans_of(nets, false).size());
    return at_most(static_cast<double>(most), limit, middle_of_patch(nets.front()));
}

/// The shortest edge of all patches; points are left out, or count as 0.
std::optional<MeasuredValue> shortest_edge(const Nets& nets, double limit, bool points) {
    std::optional<MeasuredValue> shortest;
    for (const SpanNet& net : nets)
        for (const CurvePoints& edge : net.edges()) {
            if (!points && is_point(edge, net.coincidence())) continue;
            if (shortest && chord_length(edge) > std::max(limit, shortest->value)) continue;
            const LengthRange length = curve_length(edge);
            const MeasuredValue found =
                at_least(length.middle(), length.bound() + net.coincidence(), limit,
                         net.world(curve_middle(edge)));
            shortest = shortest ? lesser_of(*shortest, found) : found;
        }
    return shortest;
}

/// The way from the curve's first point to the first control point that is another.
std::optional<Vec3> leg(const CurvePoints& curve, double coincidence) {
    const Vec3 first = euclidean(curve.front());
    for (const Vec4& p : curve)
        if ((euclidean(p) - first).length() > coincidence) return euclidean(p) - first;
    return std::nullopt;
}

CurvePoints backwards(CurvePoints curve) {
    std::reverse(curve.begin(), curve.end());
    return curve;
}

/// Angle of a corner from 0 and from 180 degrees; nullopt if one of its edges is a point.
std::optional<MeasuredValue> corner(const SpanNet& net, const CurvePoints& a, const CurvePoints& b,
                                    double limit) {
    const auto from_a = leg(a, net.coincidence()), from_b = leg(b, net.coincidence());
    if (!from_a || !from_b) return std::nullopt;
    const double angle = radians_to_degrees(angle_between(*from_a, *from_b));
    const double blur = net.placed.rounding / std::min(from_a->length(), from_b->length());
    return at_least(std::min(angle, 180 - angle), radians_to_degrees(4 * blur), limit,
                    net.world(euclidean(a.front())));
}

std::optional<MeasuredValue> sharpest_corner(const Nets& nets, double limit) {
    std::optional<MeasuredValue> sharpest;
    for (const SpanNet& net : nets) {
        const auto [low, high, left, right] = net.edges();
        const std::pair<CurvePoints, CurvePoints> corners[] = {{low, left},
                                                               {backwards(low), right},
                                                               {high, backwards(left)},
                                                               {backwards(high), backwards(right)}};
        for (const auto& [a, b] : corners)
            if (const auto found = corner(net, a, b, limit))
                sharpest = sharpest ? lesser_of(*sharpest, *found) : *found;
    }
    return sharpest;
}

} // namespace

bool has_spans(const Face& face) {
    const bool spline = face.surface_kind == "b-spline" || face.surface_kind == "bezier";
    return spline && face.patch_count > 0 && !(face.approximated > 0);
}

SpanStructure span_structure(const SurfaceModel& model, std::uint32_t instance, std::uint32_t face,
                             const StructureLimits& limits) {
    const Nets nets = span_nets(model, instance, model.faces[face]);
    SpanStructure result;
    if (limits.degree) result.degree = degree(nets, *limits.degree);
    if (limits.spans) result.spans = span_count(nets, *limits.spans);
    if (limits.knot_distance) result.knot_distance = knot_distance(nets, *limits.knot_distance);
    if (limits.width_ratio) result.width_ratio = largest_width_ratio(nets, *limits.width_ratio);
    if (limits.patch_edge) result.patch_edge = shortest_edge(nets, *limits.patch_edge, false);
    if (limits.degenerate_edge)
        result.degenerate_edge = shortest_edge(nets, *limits.degenerate_edge, true);
    if (limits.corner_angle) result.corner_angle = sharpest_corner(nets, *limits.corner_angle);
    if (limits.control_turn) result.control_turn = largest_turn(nets, *limits.control_turn);
    if (limits.control_twist) result.control_twist = largest_twist(nets, *limits.control_twist);
    if (limits.control_ratio) result.control_ratio = largest_ratio(nets, *limits.control_ratio);
    if (limits.control_distance)
        result.control_distance = shortest_leg(nets, *limits.control_distance);
    return result;
}

} // namespace keiko
