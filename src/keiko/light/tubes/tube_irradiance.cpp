#include "keiko/light/tubes/tube_irradiance.h"

#include "keiko/light/luminance/projected_solid_angle.h"
#include "keiko/light/tubes/cylinder_irradiance.h"
#include "keiko/light/tubes/tube_lamp.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace keiko {

namespace {

/// Corners relative to the point, in circulation, both long sides parallel to the axis.
std::array<Vec3, 4> strip_corners(const TubeView& view, double begin, double end,
                                  double half_width) {
    const Vec3 foot = view.towards * -view.distance, side = view.sideways * half_width;
    const Vec3 a = foot + view.along * begin, b = foot + view.along * end;
    return {a - side, b - side, b + side, a + side};
}

double strip(const TubeView& view, double begin, double end, double half_width) {
    return projected_solid_angle(strip_corners(view, begin, end, half_width), Vec3(0), view.normal);
}

LinePiece piece_of(const TubeView& view, const VisiblePart& part) {
    return {part.begin, part.end, view.distance, view.n_along, view.n_lamp};
}

} // namespace

double nishita_solid_angle(const TubeView& view, const VisiblePart& part) {
    const LinePiece axis = above_horizon(piece_of(view, part));
    if (!(axis.begin < axis.end)) return 0;
    const auto corners = strip_corners(view, axis.begin, axis.end, view.radius);
    const double long_side = angle_between(corners[0], corners[1]);
    const double width = 2 * view.radius;
    const std::array<double, 4> angles{long_side, width / corners[1].length(), long_side,
                                       width / corners[0].length()};
    double sum = 0;
    for (std::size_t i = 0; i < 4; ++i) {
        const Vec3 plane = corners[i].cross(corners[(i + 1) % 4]);
        sum += angles[i] * view.normal.dot(plane) / plane.length();
    }
    return std::abs(sum) / 2;
}

double rectangle_solid_angle(const TubeView& view, const VisiblePart& part) {
    return strip(view, part.begin, part.end, view.radius);
}

double strip_solid_angle(const TubeView& view, const VisiblePart& part) {
    const double bulge = std::numbers::pi / 4 * view.radius;
    const double stretch = view.distance / (view.distance - bulge);
    const double sine = view.radius / view.distance;
    const double half_width = view.radius / std::sqrt((1 - sine) * (1 + sine));
    return strip(view, part.begins ? part.begin * stretch : part.begin,
                 part.ends ? part.end * stretch : part.end, half_width);
}

double line_solid_angle(const TubeView& view, const VisiblePart& part) {
    const LinePiece axis = above_horizon(piece_of(view, part));
    if (!(axis.begin < axis.end)) return 0;
    return 2 * view.radius * cosine_line_integral(axis);
}

namespace {

/// The strip's error, up to 0.28 (d/D)^2 of short lamps aside and normals aslant, stays below 1e-4,
/// the accuracy of the whole system.
constexpr double strip_up_to = 0.018;
/// Ratio d/D beyond which the strip is inaccurate for pictures too
/// (docs/theory/luminance.md#the-ladder-of-approximations).
constexpr double strip_in_pictures_up_to = 0.2;

TubeModel chosen(TubeModel model, const TubeView& view) {
    const bool exacting = model == TubeModel::automatic;
    if (!exacting && model != TubeModel::picture && model != TubeModel::preview) return model;
    const double limit = exacting ? strip_up_to : strip_in_pictures_up_to;
    return view.ratio() < limit ? TubeModel::strip : TubeModel::cylinder;
}

/// Nodes of the cylinder's quadrature: pictures need no more than these.
int nodes_of(TubeModel model) {
    return model == TubeModel::picture || model == TubeModel::preview ? 8 : 16;
}

double solid_angle_of(const VisiblePart& part, const TubeView& view, TubeModel model) {
    switch (chosen(model, view)) {
        case TubeModel::nishita:
            return nishita_solid_angle(view, part);
        case TubeModel::rectangle:
            return rectangle_solid_angle(view, part);
        case TubeModel::line:
            return line_solid_angle(view, part);
        case TubeModel::strip:
            return strip_solid_angle(view, part);
        default:
            return cylinder_solid_angle(view, part, {}, nodes_of(model));
    }
}

/// True for models of the round tube: they have caps, and lamps of a row hide each other.
bool is_round(TubeModel model) {
    return model != TubeModel::nishita && model != TubeModel::rectangle && model != TubeModel::line;
}

} // namespace

double cap_solid_angle(const TubeLamp& lamp, const Vec3& point, const Vec3& normal,
                       const IntervalSet& visible) {
    if (!lamp.luminous_caps || visible.empty()) return 0;
    const double length = (lamp.b - lamp.a).length();
    if (!(length > 0)) return 0;
    const Vec3 along = (lamp.b - lamp.a) / length;
    const double x = along.dot(point - lamp.a);
    const bool before = x < 0 && visible[0].begin <= 0;
    const bool behind = x > length && visible[visible.size() - 1].end >= 1;
    if (!before && !behind) return 0;
    return projected_solid_angle(Disc{before ? lamp.a : lamp.b, along, lamp.diameter / 2}, point,
                                 normal);
}

double projected_solid_angle(const TubeLamp& lamp, const Vec3& point, const Vec3& normal,
                             const IntervalSet& visible, TubeModel model) {
    if (below_horizon(lamp, point, normal)) return 0;
    const double caps = is_round(model) ? cap_solid_angle(lamp, point, normal, visible) : 0;
    const auto view = view_of(lamp, point, normal);
    if (!view) return caps;
    return caps + sum_over_parts(*view, visible, [&](const VisiblePart& part) {
               return solid_angle_of(part, *view, model);
           });
}

TubeRowIrradiance::TubeRowIrradiance(const CPlaneFrame& frame, const Vec3& point,
                                     const Vec3& normal, TubeModel model)
    : frame_(frame), point_(point), normal_(normal), at_(frame.point(point)), model_(model) {
    if (frame.lamps < 2 || !is_round(model) || surely_apart()) return;
    wedges_.reserve(static_cast<std::size_t>(frame.lamps));
    for (int i = 0; i < frame.lamps; ++i) wedges_.push_back(wedge_of(i));
    if (std::adjacent_find(wedges_.begin(), wedges_.end(), overlap) == wedges_.end())
        wedges_.clear();
}

bool TubeRowIrradiance::overlap(const Wedge& a, const Wedge& b) {
    return std::abs(a.angle - b.angle) < a.half + b.half;
}

/// Wedge of a lamp. A point within an endless tube, beyond an end, has that lamp in all directions.
TubeRowIrradiance::Wedge TubeRowIrradiance::wedge_of(int lamp) const {
    const double across = frame_.axis(lamp) - at_.y, distance = std::hypot(across, at_.z);
    const double half =
        distance > frame_.radius() ? std::asin(frame_.radius() / distance) : std::numbers::pi;
    return {std::atan2(across, std::abs(at_.z)), half, distance};
}

/// True if the point is far enough from the plane that no line through it meets two tubes: the
/// cosine of such a line's angle to the perpendicular is at most d / pitch.
bool TubeRowIrradiance::surely_apart() const {
    const double cosine = frame_.diameter / frame_.pitch;
    if (!(cosine < 1)) return false;
    const double aside = std::max(std::abs(frame_.first - at_.y), std::abs(frame_.last() - at_.y));
    return std::abs(at_.z) * std::sqrt(1 - cosine * cosine) > frame_.radius() + aside * cosine;
}

/// Tubes whose wedges overlap that of the lamp.
std::vector<OccludingTube> TubeRowIrradiance::hiding_tubes(int lamp) const {
    std::vector<OccludingTube> hiding;
    if (!overlapping()) return hiding;
    const double sense = at_.z > 0 ? -1 : 1; // of `sideways` viewed from either side of the plane
    const Wedge& own = wedges_[static_cast<std::size_t>(lamp)];
    for (const Wedge& other : wedges_)
        if (&other != &own && overlap(own, other))
            hiding.push_back({other.distance, sense * (other.angle - own.angle)});
    return hiding;
}

double TubeRowIrradiance::solid_angle(int lamp, const IntervalSet& visible) const {
    if (visible.empty()) return 0;
    const TubeLamp tube = lamp_of(frame_, lamp, Rgb());
    const std::vector<OccludingTube> hiding = hiding_tubes(lamp);
    if (hiding.empty()) return projected_solid_angle(tube, point_, normal_, visible, model_);
    const double cap = cap_solid_angle(tube, point_, normal_, visible);
    const auto view = view_of(tube, point_, normal_);
    if (!view) return cap;
    return cap + sum_over_parts(*view, visible, [&](const VisiblePart& part) {
               return cylinder_solid_angle(*view, part, hiding, nodes_of(model_));
           });
}

} // namespace keiko
