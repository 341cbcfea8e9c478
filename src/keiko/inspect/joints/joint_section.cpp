#include "keiko/inspect/joints/joint_section.h"

#include "keiko/geometry/seam/border_run.h"
#include "keiko/inspect/joints/edge_trace.h"

#include <cmath>
#include <limits>

namespace keiko {
namespace {

/// mm: rounding of a section's values, and what Newton's iterations leave, for each metre of
/// coordinates from the origin.
constexpr double section_rounding = 1e-9;
/// Cosine of the largest angle between the skins of both panels.
constexpr double skins_facing = 0.7071067811865476;

/// A place of a border where a skin may end.
struct SkinEnd {
    const PanelBorder* border;
    double t;
    SurfaceCurve::Point point;
    BoundaryFrame frame;
};

std::optional<SkinEnd> skin_end(const PanelBorder& border, double t) {
    const auto frame = border.curve.frame(t);
    if (!frame) return std::nullopt;
    return SkinEnd{&border, t, border.curve.at(t), *frame};
}

/// 1/mm: the part along a unit vector of a curve's curvature.
double curvature_along(const SurfaceCurve::Point& p, const Vec3& direction) {
    return square_to(p.second, p.first).dot(direction) / p.first.length2();
}

/// The place of a border that faces a place of another: the chord between them is square to the
/// mean of both directions. nullopt if it has no such place, or runs another way.
std::optional<double> facing_place(const SkinEnd& a, const PanelBorder& b) {
    double s = b.polyline.nearest(a.point.position);
    constexpr int most_steps = 30;
    constexpr double enough = 1e-11, slack = 1e-7; // mm
    for (int i = 0; i < most_steps; ++i) {
        const SurfaceCurve::Point p = b.curve.at(s);
        const double speed = p.first.length();
        const Vec3 tangent = p.first / speed;
        const double sign = tangent.dot(a.frame.tangent) < 0 ? -1 : 1;
        const Vec3 mean = a.frame.tangent + tangent * sign;
        const Vec3 chord = p.position - a.point.position;
        const Vec3 turn = square_to(p.second, tangent) * (sign / speed);
        const double slope = p.first.dot(mean) + chord.dot(turn);
        const double step = -chord.dot(mean) / slope;
        const double next = std::clamp(s + step, 0.0, 1.0);
        if (!std::isfinite(next)) return std::nullopt;
        if (std::abs(s + step - next) * speed > slack && s == next) return std::nullopt;
        const double moved = std::abs(next - s) * speed;
        s = next;
        if (moved <= enough) return s;
    }
    return std::nullopt;
}

/// mm between the ends of two skins, along the mean of both.
double farthest_across(const JointLimits& limits) {
    return limits.widest + 2 * limits.largest_radius;
}

/// Box that holds all places of skins that may face one: the mean of both skins is within half of
/// `skins_facing` of the skin.
Box3 region_across(const SkinEnd& end, const JointLimits& limits) {
    constexpr double sine = 0.3826834323650898; // of 22.5 degrees
    const double across = farthest_across(limits), step = limits.widest;
    const double behind = step * sine, aside = across * sine + step;
    const double along = std::hypot(across, step) * std::sin(parallel_borders / 2);
    const BoundaryFrame& f = end.frame;
    Box3 box;
    for (const double x : {-along, along})
        for (const double y : {-behind, across + behind})
            for (const double z : {-aside, aside})
                box.extend(f.position + f.tangent * x - f.inward * y + f.normal * z);
    return box;
}

/// A section between two skins' ends before their edges are known.
class SectionMeasure {
public:
    SectionMeasure(const PanelBorders& borders, const JointLimits& limits, const SkinEnd& a,
                   const SkinEnd& b)
        : borders_(borders), limits_(limits), ends_{&a, &b} {}

    /// Whether both skins run side by side and end towards each other; sets up the plane.
    bool faces();
    /// Traces the edges and measures. Requires faces().
    AcrossResult measure();

private:
    Vec3 skin_direction(const SkinEnd& end) const;
    EdgeResult edge(std::size_t side) const;
    bool orient(const std::array<PanelEdge, 2>& edges);
    Vec3 file_normal(const SkinEnd& end) const;
    JointSide side(std::size_t i, const PanelEdge& edge) const;

    const PanelBorders& borders_;
    const JointLimits& limits_;
    std::array<const SkinEnd*, 2> ends_;
    JointSection section_;
};

/// Unit, in the plane: from the skin over its end.
Vec3 SectionMeasure::skin_direction(const SkinEnd& end) const {
    const Vec3 in_plane = end.frame.normal.cross(section_.along).normalized();
    return in_plane.dot(end.frame.inward) > 0 ? -in_plane : in_plane;
}

bool SectionMeasure::faces() {
    const Vec3 &first = ends_[0]->frame.tangent, &second = ends_[1]->frame.tangent;
    if (!nearly_parallel(first, second, std::sin(parallel_borders))) return false;
    section_.along = (first + second * (first.dot(second) < 0 ? -1.0 : 1.0)).normalized();
    const Vec3 a = skin_direction(*ends_[0]), b = skin_direction(*ends_[1]);
    if (a.dot(b) > -skins_facing) return false;
    section_.across = (a - b).normalized();
    section_.outward = section_.across.cross(section_.along);
    const Vec3 chord = ends_[1]->point.position - ends_[0]->point.position;
    section_.flush = chord.dot(section_.outward);
    return chord.dot(section_.across) > 0 && std::abs(section_.flush) <= limits_.widest &&
           chord.dot(section_.across) <= farthest_across(limits_);
}

EdgeResult SectionMeasure::edge(std::size_t side) const {
    const SkinEnd& end = *ends_[side];
    const EdgePlane plane{ends_[0]->point.position, section_.along,
                          side == 0 ? section_.across : -section_.across};
    return trace_edge(borders_, *end.border, end.t, plane, limits_.largest_radius);
}

/// Outward unit normal by the file.
Vec3 SectionMeasure::file_normal(const SkinEnd& end) const {
    const PlacedFace face = end.border->face();
    const bool reversed = borders_.model().faces[face.face].reversed !=
                          borders_.model().instances[face.instance].transform.mirrored();
    return reversed ? -end.frame.normal : end.frame.normal;
}

/// Turns the outward direction away from what lies beyond the skins, or else by the file. False if
/// both panels have their outsides on different sides.
bool SectionMeasure::orient(const std::array<PanelEdge, 2>& edges) {
    constexpr double sideways = 0.1;
    const auto outside = [&](const PanelEdge& edge) {
        const double inside = edge.onward.dot(section_.outward);
        return std::abs(inside) < sideways ? 0.0 : inside > 0 ? -1.0 : 1.0;
    };
    const double first = outside(edges[0]), second = outside(edges[1]);
    if (first * second < 0) return false;
    double sign = first != 0 ? first : second;
    if (sign == 0) sign = file_normal(*ends_[0]).dot(section_.outward) < 0 ? -1 : 1;
    section_.outward *= sign, section_.flush *= sign;
    return true;
}

JointSide SectionMeasure::side(std::size_t i, const PanelEdge& edge) const {
    const SkinEnd& end = *ends_[i];
    const Vec3 forward = i == 0 ? section_.across : -section_.across;
    return {end.border->face(), end.point.position, edge.foremost, edge.radius,
            curvature_along(end.point, forward)};
}

AcrossResult SectionMeasure::measure() {
    const std::size_t body = ends_[1]->border->body;
    const EdgeResult first = edge(0);
    if (!first.edge && !first.is_unmeasured) return {};
    const EdgeResult second = edge(1);
    if (!second.edge && !second.is_unmeasured) return {};
    if (!first.edge || !second.edge) return {std::nullopt, body, true};
    if (!orient({*first.edge, *second.edge})) return {};
    section_.sides = {side(0, *first.edge), side(1, *second.edge)};
    const Vec3 between = second.edge->foremost - first.edge->foremost;
    section_.gap = between.dot(section_.across);
    const double metres = 1 + section_.place().length() / 1000;
    section_.bound =
        section_rounding * metres + first.edge->approximated + second.edge->approximated;
    if (section_.gap > limits_.widest) return {};
    return {section_, body, false};
}

/// Takes the nearer of two results; one that was measured before one that was not.
void keep_nearer(AcrossResult& best, const AcrossResult& found) {
    if (!found.section) {
        if (!best.section && !best.is_unmeasured) best = found;
        return;
    }
    const auto distance = [](const AcrossResult& result) {
        const auto& sides = result.section->sides;
        return (sides[1].foremost - sides[0].foremost).length();
    };
    if (!best.section || distance(found) < distance(best)) best = found;
}

} // namespace

AcrossResult measure_across(const PanelBorders& borders, const PanelBorder& border, double t,
                            const JointLimits& limits) {
    AcrossResult best;
    const auto a = skin_end(border, t);
    if (!a) return best;
    const double reach = std::hypot(farthest_across(limits), limits.widest);
    for (const std::uint32_t i : borders.others_facing(
             border.body, a->point.position, a->frame.tangent, reach, region_across(*a, limits))) {
        const PanelBorder& other = borders.all()[i];
        const auto s = facing_place(*a, other);
        const auto b = s ? skin_end(other, *s) : std::nullopt;
        if (!b) continue;
        SectionMeasure measure(borders, limits, *a, *b);
        if (measure.faces()) keep_nearer(best, measure.measure());
    }
    return best;
}

} // namespace keiko
