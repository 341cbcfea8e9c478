#include "keiko/inspect/joints/edge_trace.h"

#include "keiko/base/job.h"
#include "keiko/base/units.h"
#include "keiko/geometry/bezier/differential_geometry.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace keiko {
namespace {

/// Radians; a seam that turns by more ends a roll, and a face that turns by less begins none.
constexpr double crease_turn = degrees_to_radians(5), first_turn = degrees_to_radians(10);
/// Cosine up to which a section counts as square to the forward direction.
constexpr double square = 1e-9;

/// A place of a section on a face.
struct TracePlace {
    PlacedFace face;
    Vec2 place{0};        ///< of its FaceSurface
    SurfaceDerivatives s; ///< there, world, mm
    Vec3 heading{0};      ///< unit, along the section
};

/// The step in parameters that moves by `way`, by least squares.
Vec2 step_along(const SurfaceDerivatives& s, const Vec3& way) {
    const double a = s.du().length2(), b = s.du().dot(s.dv()), c = s.dv().length2();
    const double x = s.du().dot(way), y = s.dv().dot(way), det = a * c - b * b;
    return {(c * x - b * y) / det, (a * y - b * x) / det};
}

Vec3 normal_of(const SurfaceDerivatives& s) {
    return s.du().cross(s.dv()).normalized();
}

class EdgeTrace {
public:
    EdgeTrace(const PanelBorders& borders, const EdgePlane& plane, double largest_radius)
        : borders_(borders),
          plane_(plane),
          outward_(plane.along.cross(plane.forward)),
          largest_radius_(largest_radius),
          reach_(3 * largest_radius) {}

    EdgeResult run(const PanelBorder& border, double t);

private:
    enum class End { none, edge, next_face, lost };

    const FaceSurface& surface(const PlacedFace& face) const { return borders_.surface(face); }
    double height(const Vec3& p) const { return (p - plane_.origin).dot(plane_.along); }
    double turned() const { return angle_between(at_.heading, plane_.forward); }
    bool evaluate(TracePlace& at) const;
    bool settle(TracePlace& at) const;
    bool is_material(const TracePlace& at) const;
    bool enter(const BorderNeighbour& neighbour);
    std::optional<TracePlace> advanced(double step) const;
    double step_here() const;
    void note_radius();
    End walk();
    End leave(double step);
    End end_at_border(const PanelBorder& border, double t);
    Vec2 step_to_foremost(const SurfaceDerivatives& s) const;
    End find_foremost(const TracePlace& beyond);
    std::optional<double> crossing(const PanelBorder& border, double step) const;

    const PanelBorders& borders_;
    const EdgePlane& plane_;
    Vec3 outward_; ///< or inward: square to the plane's two directions
    double largest_radius_, reach_;
    TracePlace at_;
    Vec3 entry_{0};
    double way_ = 0;
    bool is_first_face_ = true;
    double sharpest_ = 0; ///< 1/mm
    PanelEdge edge_;
};

/// Evaluates a place and its heading, which keeps its direction; false if there is no surface.
bool EdgeTrace::evaluate(TracePlace& at) const {
    const auto s = surface(at.face).evaluate_beyond(at.place, 2);
    if (!s) return false;
    at.s = *s;
    const Vec3 direction = normal_of(at.s).cross(plane_.along);
    constexpr double tangential = 1e-6; // the surface lies along the plane
    if (!(direction.length() > tangential)) return false;
    at.heading = direction.normalized() * (direction.dot(at.heading) < 0 ? -1.0 : 1.0);
    return true;
}

/// Moves a place over its face into the plane.
bool EdgeTrace::settle(TracePlace& at) const {
    constexpr int most_steps = 12;
    constexpr double enough = 1e-11; // mm
    for (int i = 0; i < most_steps; ++i) {
        if (!evaluate(at)) return false;
        const double off = height(at.s.position());
        if (std::abs(off) <= enough) return true;
        const Vec3 way = square_to(plane_.along, normal_of(at.s));
        at.place += step_along(at.s, way * (-off / way.dot(plane_.along)));
    }
    constexpr double tolerated = 1e-9; // mm, where coordinates are large
    return evaluate(at) && std::abs(height(at.s.position())) <= tolerated;
}

/// True if there is material at a place or right beside it, for sections along a border.
bool EdgeTrace::is_material(const TracePlace& at) const {
    constexpr double aside = 1e-6; // mm
    const Vec2 step = step_along(at.s, plane_.along * aside);
    const FaceSurface& face = surface(at.face);
    return face.has_material(at.place) || face.has_material(at.place + step) ||
           face.has_material(at.place - step);
}

bool EdgeTrace::enter(const BorderNeighbour& neighbour) {
    at_.face = neighbour.face;
    at_.place = surface(neighbour.face).place_of(neighbour.parameters);
    at_.heading = neighbour.frame.inward;
    edge_.approximated =
        std::max(edge_.approximated, borders_.model().faces[neighbour.face.face].approximated);
    entry_ = neighbour.frame.position;
    return settle(at_);
}

/// mm: turns by a tenth of a radian at most.
double EdgeTrace::step_here() const {
    constexpr double most_turn = 0.1, longest = 0.5, shortest = 1e-3; // mm
    const double bend = std::abs(normal_curvature(at_.s, normal_of(at_.s), at_.heading));
    return std::clamp(most_turn / std::max(bend, 1e-9), shortest, longest);
}

std::optional<TracePlace> EdgeTrace::advanced(double step) const {
    TracePlace next = at_;
    next.place += step_along(at_.s, at_.heading * step);
    return settle(next) ? std::optional(next) : std::nullopt;
}

void EdgeTrace::note_radius() {
    if (const auto k = reliable_curvatures(at_.s, normal_of(at_.s)))
        sharpest_ = std::max({sharpest_, std::abs(k->k1), std::abs(k->k2)});
}

EdgeTrace::End EdgeTrace::walk() {
    for (;;) {
        check_stop();
        note_radius();
        const double step = step_here();
        const auto next = advanced(step);
        if (!next || !is_material(*next)) return leave(step);
        if (next->heading.dot(plane_.forward) <= square) return find_foremost(*next);
        at_ = *next, way_ += step;
        if (way_ > reach_) return turned() < least_edge_turn ? End::none : End::lost;
    }
}

/// Parameter at which a border crosses the plane within about `step` mm ahead.
std::optional<double> EdgeTrace::crossing(const PanelBorder& border, double step) const {
    const Vec3 from = at_.s.position();
    const double near = 3 * step + border.polyline.deviation;
    if (border.polyline.distance(from) > near) return std::nullopt;
    double t = border.polyline.nearest(from);
    constexpr int most_steps = 20;
    constexpr double enough = 1e-10; // mm
    SurfaceCurve::Point p = border.curve.at(t);
    for (int i = 0; i < most_steps && std::abs(height(p.position)) > enough; ++i) {
        t = std::clamp(t - height(p.position) / p.first.dot(plane_.along), 0.0, 1.0);
        if (!std::isfinite(t)) return std::nullopt;
        p = border.curve.at(t);
    }
    constexpr double tolerated = 1e-6, behind = -1e-7; // mm
    constexpr double least_sine = 0.02;                // else the border runs along the section
    if (std::abs(p.first.dot(plane_.along)) < least_sine * p.first.length()) return std::nullopt;
    const Vec3 off = p.position - from;
    const bool is_entry = (p.position - entry_).length() <= tolerated;
    if (is_entry || std::abs(height(p.position)) > tolerated || off.length() > near ||
        off.dot(at_.heading) < behind)
        return std::nullopt;
    return t;
}

/// Goes on to the border of the face, which lies within a step.
EdgeTrace::End EdgeTrace::leave(double step) {
    const PanelBorder* exit = nullptr;
    double at = 0, least = std::numeric_limits<double>::infinity();
    for (const std::uint32_t i : borders_.of(at_.face)) {
        const PanelBorder& border = borders_.all()[i];
        const auto t = crossing(border, step);
        if (!t) continue;
        const double way = (border.curve.at(*t).position - at_.s.position()).length();
        if (way < least) exit = &border, at = *t, least = way;
    }
    if (!exit) return End::lost;
    TracePlace end = at_;
    end.place = surface(at_.face).place_of(exit->curve.parameters(at));
    if (!settle(end)) return End::lost;
    if (end.heading.dot(plane_.forward) < -square) return find_foremost(end);
    way_ += least, at_ = end;
    note_radius();
    return end_at_border(*exit, at);
}

/// Decides at the far border of a face whether the roll ends there.
EdgeTrace::End EdgeTrace::end_at_border(const PanelBorder& border, double t) {
    edge_.foremost = at_.s.position(), edge_.onward = at_.heading;
    const bool turns = turned() >= least_edge_turn;
    if (is_first_face_ && turned() < first_turn) return End::none;
    constexpr double nearly_square = 1e-7;
    if (at_.heading.dot(plane_.forward) <= nearly_square) return End::edge;
    const auto neighbour = borders_.beyond(border, t);
    if (!neighbour) return turns ? End::edge : End::none;
    const Vec3 before = at_.heading;
    if (!enter(*neighbour)) return End::lost;
    const double bend = std::abs(normal_curvature(at_.s, normal_of(at_.s), at_.heading));
    const bool goes_on =
        angle_between(before, at_.heading) <= crease_turn && bend * largest_radius_ >= 1;
    if (!goes_on) return turns ? End::edge : End::none;
    is_first_face_ = false;
    return End::next_face;
}

/// Step of Newton's iteration for the place in the plane whose tangent is square to the forward
/// direction; in parameters.
Vec2 EdgeTrace::step_to_foremost(const SurfaceDerivatives& s) const {
    const Vec3 normal = s.du().cross(s.dv());
    const Vec3 by_u = s.duu().cross(s.dv()) + s.du().cross(s.duv());
    const Vec3 by_v = s.duv().cross(s.dv()) + s.du().cross(s.dvv());
    const double f = height(s.position());
    const double fu = s.du().dot(plane_.along), fv = s.dv().dot(plane_.along);
    const double q = normal.dot(outward_), qu = by_u.dot(outward_), qv = by_v.dot(outward_);
    const double det = fu * qv - fv * qu;
    return {(fv * q - f * qv) / det, (f * qu - fu * q) / det};
}

/// Finds the foremost place between the last one and one beyond it.
EdgeTrace::End EdgeTrace::find_foremost(const TracePlace& beyond) {
    const double before = at_.heading.dot(plane_.forward);
    const double after = beyond.heading.dot(plane_.forward);
    TracePlace at = at_;
    at.place += (beyond.place - at_.place) * (before / (before - after));
    constexpr int most_steps = 30;
    constexpr double enough = 1e-11; // mm
    for (int i = 0; i < most_steps; ++i) {
        if (!evaluate(at)) return End::lost;
        const Vec2 step = step_to_foremost(at.s);
        at.place += step;
        if (!((at.s.du() * step.x + at.s.dv() * step.y).length() > enough)) break;
    }
    constexpr double largest_step = 1; // mm: the iteration went elsewhere
    if (!settle(at) || !((at.s.position() - at_.s.position()).length() < largest_step))
        return End::lost;
    at_ = at;
    note_radius();
    edge_.foremost = at_.s.position(), edge_.onward = beyond.heading;
    return End::edge;
}

EdgeResult EdgeTrace::run(const PanelBorder& border, double t) {
    edge_.approximated = borders_.model().faces[border.on.face].approximated;
    edge_.foremost = border.curve.at(t).position;
    if (borders_.is_free(border, t)) return {edge_, false};
    const auto neighbour = borders_.beyond(border, t);
    if (!neighbour || !enter(*neighbour)) return {std::nullopt, true};
    if (turned() >= least_edge_turn) {
        edge_.onward = at_.heading;
        return {edge_, false};
    }
    constexpr int most_faces = 16;
    End end = walk();
    for (int i = 0; i < most_faces && end == End::next_face; ++i) end = walk();
    if (end == End::none) return {};
    if (end != End::edge) return {std::nullopt, true};
    edge_.radius = sharpest_ > 0 ? 1 / sharpest_ : 0;
    return {edge_, false};
}

} // namespace

EdgeResult trace_edge(const PanelBorders& borders, const PanelBorder& border, double t,
                      const EdgePlane& plane, double largest_radius) {
    return EdgeTrace(borders, plane, largest_radius).run(border, t);
}

} // namespace keiko
