#include "keiko/inspect/lines/line_endpoint.h"

#include "keiko/base/units.h"
#include "keiko/geometry/model/closest_point.h"
#include "keiko/inspect/basics/placed_face.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace keiko {
namespace {

/// mm: largest distance of an end from a border that it belongs to, besides four of its gaps. Trim
/// curves of CAD files deviate from their faces' sides by some 1e-5 mm; where sides overlap, the
/// upper one hides the last bit of the lower.
constexpr double near_border = 1e-4;
/// mm: borders farther away are not searched.
constexpr double search_radius = 0.5;
/// Share of a curve's parameter that seams meeting at a T may leave uncovered.
constexpr double between_seams = 1e-7;

Vec3 facing(const LineField& field, const Vec3& place, const Vec3& normal) {
    return field.eye().towards(place).dot(normal) > 0 ? -normal : normal;
}

/// Parameter at which a line crosses a border curve, near t; t itself if the line is almost
/// parallel to the curve.
double crossing_at(const SurfaceCurve& curve, const LineField& field, double level, double t,
                   double within) {
    constexpr int most_steps = 8;
    constexpr double fine = 1e-11; // mm
    double at = t, moved = 0;
    for (int i = 0; i < most_steps; ++i) {
        const auto frame = curve.frame(at, 2);
        const auto course = frame ? line_course(field, level, frame->surface) : std::nullopt;
        if (!course) return t;
        const double step = -course->value / course->gradient().dot(frame->tangent);
        moved += step;
        if (!(std::abs(moved) <= within)) return t;
        at = std::clamp(at + step / curve.at(at).first.length(), 0.0, 1.0);
        if (std::abs(step) < fine) break;
    }
    return at;
}

bool holds(const BoundaryInterval& interval, double t) {
    const auto [low, high] = std::minmax(interval.begin, interval.end);
    return t >= low - between_seams && t <= high + between_seams;
}

/// Sets the other side's image at the nearest place; `position` and `normal` are the other side's.
void look_across(LineEndpoint& meeting, const LampLevels& lamps, const Vec3& position,
                 const Vec3& normal) {
    const LineField::Image image = lamps.field.image(position, normal);
    meeting.gap = (position - meeting.place).length();
    meeting.angle = radians_to_degrees(
        angle_between(meeting.course.normal, facing(lamps.field, position, normal)));
    meeting.jump = image.faces ? image.value - lamps.level(meeting.lamp)
                               : std::numeric_limits<double>::quiet_NaN();
}

} // namespace

LineBorders::LineBorders(const SurfaceModel& model, const BoundaryCurves& curves,
                         std::span<const Seam> seams,
                         const std::vector<std::vector<std::uint32_t>>& chains)
    : model_(model), curves_(curves), seams_(seams), chain_of_(seams.size(), no_index) {
    for (std::uint32_t c = 0; c < chains.size(); ++c)
        for (const std::uint32_t seam : chains[c]) chain_of_[seam] = c;
    for (const Face& face : model.faces) {
        trims_.emplace_back(model, face);
        grids_.emplace_back(model, face);
    }
    for (std::uint32_t i = 0; i < seams.size(); ++i)
        for (const bool second : {false, true}) {
            const BoundaryInterval& on = second ? seams[i].b : seams[i].a;
            sides_[{on.instance, on.face, on.curve}].push_back({i, second});
        }
}

LineBorders::End LineBorders::end_of(const SurfaceLine& piece, std::uint32_t index, bool head,
                                     const LampLevels& lamps) const {
    Asked asked{piece, head ? piece.line.points.front() : piece.line.points.back(), {}, lamps};
    asked.meeting.piece = index, asked.meeting.head = head;
    asked.meeting.plane = piece.plane, asked.meeting.lamp = piece.lamp;
    asked.meeting.instance = piece.instance, asked.meeting.face = piece.face;
    End end;
    for (const bool constant_u : {true, false})
        if (auto meeting = at_knot(asked, constant_u)) end.meetings.push_back(*meeting);
    const std::optional<BorderPlace> border = border_at(asked);
    if (!border) return end;
    const BoundaryInterval& on = border->curve;
    const auto sides = sides_.find({on.instance, on.face, on.curve});
    end.on_border = border->distance <= near_border;
    if (sides == sides_.end()) return end;
    for (const SeamSide& side : sides->second) {
        const auto meeting = at_seam(asked, *border, side);
        if (!meeting || border->distance > near_border + 4 * meeting->gap) continue;
        end.meetings.push_back(*meeting);
        end.on_border = true;
    }
    return end;
}

std::optional<LineBorders::BorderPlace> LineBorders::border_at(const Asked& end) const {
    const SurfaceLine& piece = end.piece;
    const Patch& patch = model_.patches[piece.patch];
    const Vec2 uv = model_.face_parameters(piece.patch, end.point.uv);
    BorderPlace place{{piece.instance, piece.face, 0, 0, 1}, 0, 0};
    if (!trims_[piece.face].untrimmed()) {
        const SurfaceDerivatives s =
            placed_derivatives(model_, piece.instance, piece.patch, end.point.uv);
        const ParameterMetric metric(s.du() / patch.map_u.derivative(end.point.uv.x),
                                     s.dv() / patch.map_v.derivative(end.point.uv.y));
        const auto near = trims_[piece.face].nearest_curve(uv, metric, search_radius);
        if (!near) return std::nullopt;
        place.curve.curve = near->curve, place.t = near->t, place.distance = near->distance;
        return place;
    }
    const Box2 domain = grids_[piece.face].domain();
    const Vec2 share = (uv - domain.lower) / domain.extent();
    constexpr double rounding = 1e-12;
    const double from_side[4] = {share.y, 1 - share.x, 1 - share.y, share.x};
    const double run[4] = {share.x, share.y, 1 - share.x, 1 - share.y};
    for (std::uint32_t side = 0; side < 4; ++side)
        if (from_side[side] <= rounding) {
            place.curve.curve = natural_side + side, place.t = run[side];
            return place;
        }
    return std::nullopt;
}

std::optional<LineEndpoint> LineBorders::at_seam(const Asked& end, const BorderPlace& border,
                                                 const SeamSide& side) const {
    const Seam& seam = seams_[side.seam];
    const BoundaryInterval &own = side.second ? seam.b : seam.a,
                           &far = side.second ? seam.a : seam.b;
    if (!holds(own, border.t)) return std::nullopt;
    const LineField& field = end.lamps.field;
    const double level = end.lamps.level(end.piece.lamp);
    const SurfaceCurve curve = curves_.curve(own), other = curves_.curve(far);
    const double within = 50 * (border.distance + near_border / 10);
    const double t = crossing_at(curve, field, level, border.t, within);
    const auto frame = curve.frame(t, 3);
    const auto course = frame ? line_course(field, level, frame->surface) : std::nullopt;
    if (!course) return std::nullopt;
    const double share = own.end == own.begin ? 0 : (t - own.begin) / (own.end - own.begin);
    const ClosestPoint foot = closest_point(
        other, frame->position, far.begin + share * (far.end - far.begin), far.begin, far.end);
    const auto across = other.frame(foot.t, 3);
    if (!across) return std::nullopt;
    LineEndpoint meeting = end.meeting;
    meeting.border.seam = chain_of_[side.seam];
    meeting.second = side.second;
    meeting.place = frame->position;
    meeting.along = own.begin < own.end ? frame->tangent : -frame->tangent;
    meeting.surface = frame->surface, meeting.degree = degree(curve.patch_at(t));
    meeting.course = *course;
    meeting.off = std::abs(course->value / meeting.slope()) + model_.faces[own.face].approximated;
    meeting.other = across->surface, meeting.other_degree = degree(other.patch_at(foot.t));
    look_across(meeting, end.lamps, across->position, across->normal);
    return meeting;
}

std::optional<LineEndpoint> LineBorders::at_knot(const Asked& end, bool constant_u) const {
    const SurfaceLine& piece = end.piece;
    const double x = constant_u ? end.point.uv.x : end.point.uv.y;
    if (x != 0 && x != 1) return std::nullopt;
    const Patch& own = model_.patches[piece.patch];
    const ParameterMap& own_map = constant_u ? own.map_u : own.map_v;
    const double at = x == 0 ? own_map.begin : own_map.end; // exactly the neighbour's parameter
    Vec2 uv = model_.face_parameters(piece.patch, end.point.uv);
    (constant_u ? uv.x : uv.y) = at;
    const Vec2 outward = constant_u ? Vec2(x == 0 ? -1 : 1, 0) : Vec2(0, x == 0 ? -1 : 1);
    const std::uint32_t beyond = grids_[piece.face].locate(uv, outward);
    const Patch& far = model_.patches[beyond];
    const ParameterMap& far_map = constant_u ? far.map_u : far.map_v;
    // Beyond the last line of the grid, it locates a patch that ends there, too.
    if (beyond == piece.patch || (x == 0 ? far_map.end : far_map.begin) != at) return std::nullopt;
    const SurfaceDerivatives s =
        placed_derivatives(model_, piece.instance, piece.patch, end.point.uv);
    const auto course = line_course(end.lamps.field, end.lamps.level(piece.lamp), s);
    const Vec2 far_uv(std::clamp(far.map_u.to_patch(uv.x), 0.0, 1.0),
                      std::clamp(far.map_v.to_patch(uv.y), 0.0, 1.0));
    const SurfaceDerivatives across = placed_derivatives(model_, piece.instance, beyond, far_uv);
    const Vec3 normal = across.du().cross(across.dv());
    if (!course || !(normal.length() > 0)) return std::nullopt;
    LineEndpoint meeting = end.meeting;
    meeting.border = {no_index, piece.instance, piece.face, constant_u, at};
    meeting.second = x == 0;
    meeting.place = s.position();
    meeting.along = (constant_u ? s.dv() : s.du()).normalized();
    meeting.surface = s, meeting.degree = degree(piece.patch);
    meeting.course = *course;
    meeting.off = std::abs(course->value / meeting.slope());
    meeting.other = across, meeting.other_degree = degree(beyond);
    look_across(meeting, end.lamps, across.position(), normal.normalized());
    return meeting;
}

int LineBorders::degree(std::uint32_t patch) const {
    return std::max(model_.patches[patch].degree_u, model_.patches[patch].degree_v);
}

std::string_view name_of(LineEnd end) {
    constexpr std::array<std::string_view, 8> names{"closed",      "lamp",   "silhouette", "hidden",
                                                    "free-border", "crease", "seam",       "patch"};
    return names[static_cast<std::size_t>(end)];
}

LineEnd line_end(const SurfaceModel& model, const SurfaceLine& piece, bool head,
                 const LineBorders::End& end, const LineField& field, double feature_angle) {
    bool at_seam = false;
    for (const LineEndpoint& meeting : end.meetings) {
        if (meeting.angle > feature_angle) return LineEnd::crease;
        at_seam = at_seam || meeting.border.seam != no_index;
    }
    if (at_seam) return LineEnd::seam;
    if (end.on_border) return LineEnd::free_border;
    if (!end.meetings.empty()) return LineEnd::patch;
    const LinePoint& point = head ? piece.line.points.front() : piece.line.points.back();
    const SurfaceDerivatives s = placed_derivatives(model, piece.instance, piece.patch, point.uv);
    const Vec3 normal = s.du().cross(s.dv()).normalized();
    constexpr double grazing = 1e-4, at_lamp_end = 1e-6; // radians; share of the lamp
    if (!(std::abs(field.eye().towards(s.position()).normalized().dot(normal)) > grazing))
        return LineEnd::silhouette;
    const double along = field.image(s.position(), normal).along / field.plane().length;
    const bool ends_with_lamp = std::min(std::abs(along), std::abs(along - 1)) < at_lamp_end;
    return field.look() != LineLook::isophote && ends_with_lamp ? LineEnd::lamp : LineEnd::hidden;
}

} // namespace keiko
