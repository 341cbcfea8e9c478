#include "keiko/base/units.h"
#include "keiko/geometry/bezier/space_curve.h"
#include "keiko/inspect/basics/placed_face.h"
#include "keiko/inspect/structure/face_structure.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <utility>

namespace keiko {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// A patch of a face as placed, its control points about its middle.
struct Net {
    const Patch* patch;
    PlacedPatch placed;

    std::size_t count_u() const { return patch->degree_u + std::size_t{1}; }
    std::size_t count_v() const { return patch->degree_v + std::size_t{1}; }
    const Vec4& point(std::size_t i, std::size_t j) const {
        return placed.points[i * count_v() + j];
    }
    /// Isoline along u, of the control points with index j.
    CurvePoints along_u(std::size_t j) const {
        CurvePoints curve;
        for (std::size_t i = 0; i < count_u(); ++i) curve.push_back(point(i, j));
        return curve;
    }
    CurvePoints along_v(std::size_t i) const {
        CurvePoints curve;
        for (std::size_t j = 0; j < count_v(); ++j) curve.push_back(point(i, j));
        return curve;
    }
    /// The edges v = 0, v = 1, u = 0 and u = 1.
    std::array<CurvePoints, 4> edges() const {
        return {along_u(0), along_u(count_v() - 1), along_v(0), along_v(count_u() - 1)};
    }
    /// mm: control points that are nearer to each other are one.
    double coincidence() const { return 16 * placed.rounding; }
    Vec3 world(const Vec3& point) const { return point + placed.middle; }
};

using Nets = std::vector<Net>;

Nets nets_of(const SurfaceModel& model, std::uint32_t instance, const Face& face) {
    Nets nets;
    for (std::uint32_t p = face.first_patch; p < face.first_patch + face.patch_count; ++p)
        nets.push_back(
            {&model.patches[p], PlacedPatch(model, p, model.instances[instance].transform)});
    return nets;
}

bool is_point(const CurvePoints& curve, double coincidence) {
    const Vec3 first = euclidean(curve.front());
    return std::all_of(curve.begin(), curve.end(), [&](const Vec4& p) {
        return !((euclidean(p) - first).length() > coincidence);
    });
}

/// A value that must not be under its limit.
MeasuredValue at_least(double value, double bound, double limit, const Vec3& place) {
    MeasuredValue worst{value, bound, limit, place, Verdict::undecided, true};
    if (value - bound >= limit) worst.verdict = Verdict::pass;
    if (value + bound < limit) worst.verdict = Verdict::fail;
    return worst;
}

MeasuredValue at_most(double value, int limit, const Vec3& place) {
    return {value, 0, double(limit), place, judge(value, 0, limit), false};
}

/// The patch's place at (1/2, 1/2).
Vec3 middle_of_patch(const Net& net) {
    const BezierPatchView view{net.patch->degree_u, net.patch->degree_v, net.placed.points};
    return net.world(evaluate(view, Vec2(0.5), 0).position());
}

MeasuredValue degree(const Nets& nets, int limit) {
    int most = 0;
    for (const Net& net : nets)
        most = std::max({most, int{net.patch->degree_u}, int{net.patch->degree_v}});
    return at_most(most, limit, middle_of_patch(nets.front()));
}

using Knots = std::pair<double, double>;

/// The patches of each knot span of one parameter.
std::map<Knots, std::vector<const Net*>> spans_of(const Nets& nets, ParameterMap Patch::*map) {
    std::map<Knots, std::vector<const Net*>> spans;
    for (const Net& net : nets)
        spans[{(net.patch->*map).begin, (net.patch->*map).end}].push_back(&net);
    return spans;
}

MeasuredValue span_count(const Nets& nets, int limit) {
    const std::size_t most =
        std::max(spans_of(nets, &Patch::map_u).size(), spans_of(nets, &Patch::map_v).size());
    return at_most(static_cast<double>(most), limit, middle_of_patch(nets.front()));
}

/// The control polygons of a patch across a span: one for each control point along it.
std::vector<CurvePoints> across(const Net& net, bool in_u) {
    std::vector<CurvePoints> curves;
    for (std::size_t k = 0; k < (in_u ? net.count_v() : net.count_u()); ++k)
        curves.push_back(in_u ? net.along_u(k) : net.along_v(k));
    return curves;
}

/// mm: no isoline across the patch is longer. A leg of an isoline's control polygon is a mean of
/// those of the net, if the weights are a product of two factors; else their ratios add some.
double longest_isoline(const std::vector<CurvePoints>& curves) {
    double length = 0;
    for (std::size_t i = 0; i + 1 < curves.front().size(); ++i) {
        double leg = 0, extent = 0, least = infinity, most = 0;
        const Vec3 from = euclidean(curves.front()[i]);
        for (const CurvePoints& curve : curves) {
            const Vec3 p = euclidean(curve[i]);
            leg = std::max(leg, (euclidean(curve[i + 1]) - p).length());
            extent = std::max(extent, (p - from).length());
            const double ratio = curve[i + 1].w / curve[i].w;
            least = std::min(least, ratio), most = std::max(most, ratio);
        }
        length += leg + (most / least - 1) * extent;
    }
    return length;
}

/// The width of a span: the longest isoline across it. At least that of the edges of its patches.
MeasuredValue width(const std::vector<const Net*>& patches, bool in_u, double limit) {
    double least = 0, most = 0;
    Vec3 place(0);
    for (const Net* net : patches) {
        const std::vector<CurvePoints> curves = across(*net, in_u);
        for (const CurvePoints* edge : {&curves.front(), &curves.back()}) {
            const double length = curve_length(*edge).least;
            if (length >= least) least = length, place = net->world(curve_middle(*edge));
        }
        most = std::max(most, longest_isoline(curves));
    }
    most = std::max(least, most);
    return at_least((least + most) / 2, (most - least) / 2, limit, place);
}

/// The longest chord of the edges across a span, mm: the span is at least that wide.
double least_width(const std::vector<const Net*>& patches, bool in_u) {
    double least = 0;
    for (const Net* net : patches) {
        const std::size_t last = (in_u ? net->count_v() : net->count_u()) - 1;
        for (const std::size_t k : {std::size_t{0}, last})
            least = std::max(least, chord_length(in_u ? net->along_u(k) : net->along_v(k)));
    }
    return least;
}

const MeasuredValue& narrower(const MeasuredValue& a, const MeasuredValue& b) {
    if (a.verdict != b.verdict) return a.verdict > b.verdict ? a : b;
    return a.value <= b.value ? a : b;
}

MeasuredValue knot_distance(const Nets& nets, double limit) {
    std::optional<MeasuredValue> narrowest;
    for (const bool in_u : {true, false})
        for (const auto& [knots, patches] : spans_of(nets, in_u ? &Patch::map_u : &Patch::map_v)) {
            if (narrowest && least_width(patches, in_u) > std::max(limit, narrowest->value))
                continue;
            const MeasuredValue found = width(patches, in_u, limit);
            narrowest = narrowest ? narrower(*narrowest, found) : found;
        }
    return *narrowest;
}

/// The shortest edge of all patches; points are left out, or count as 0.
std::optional<MeasuredValue> shortest_edge(const Nets& nets, double limit, bool points) {
    std::optional<MeasuredValue> shortest;
    for (const Net& net : nets)
        for (const CurvePoints& edge : net.edges()) {
            if (!points && is_point(edge, net.coincidence())) continue;
            if (shortest && chord_length(edge) > std::max(limit, shortest->value)) continue;
            const LengthRange length = curve_length(edge);
            const MeasuredValue found =
                at_least(length.middle(), length.bound() + net.coincidence(), limit,
                         net.world(curve_middle(edge)));
            shortest = shortest ? narrower(*shortest, found) : found;
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
std::optional<MeasuredValue> corner(const Net& net, const CurvePoints& a, const CurvePoints& b,
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
    for (const Net& net : nets) {
        const auto [low, high, left, right] = net.edges();
        const std::pair<CurvePoints, CurvePoints> corners[] = {{low, left},
                                                               {backwards(low), right},
                                                               {high, backwards(left)},
                                                               {backwards(high), backwards(right)}};
        for (const auto& [a, b] : corners)
            if (const auto found = corner(net, a, b, limit))
                sharpest = sharpest ? narrower(*sharpest, *found) : *found;
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
    const Nets nets = nets_of(model, instance, model.faces[face]);
    SpanStructure result;
    if (limits.degree) result.degree = degree(nets, *limits.degree);
    if (limits.spans) result.spans = span_count(nets, *limits.spans);
    if (limits.knot_distance) result.knot_distance = knot_distance(nets, *limits.knot_distance);
    if (limits.patch_edge) result.patch_edge = shortest_edge(nets, *limits.patch_edge, false);
    if (limits.degenerate_edge)
        result.degenerate_edge = shortest_edge(nets, *limits.degenerate_edge, true);
    if (limits.corner_angle) result.corner_angle = sharpest_corner(nets, *limits.corner_angle);
    return result;
}

} // namespace keiko
