#include "keiko/light/areas/contour_width.h"

#include "keiko/light/luminance/flush.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace keiko {
namespace {

constexpr double pi = std::numbers::pi;
/// Angle, rad, between places where the contour turns, below which they are one.
constexpr double one_turn = 1e-9;
/// Share of a chord that its ends lie within the outline at least, where rays just meet the body.
constexpr double inside = 1e-6;
/// Share of a chord that they lie within at most, and of all lines otherwise, as outlines are known
/// to about that.
constexpr double most_inside = 0.25, of_lines = 1e-6;

} // namespace

std::vector<ContourWidth> ContourWidth::all(const ContourLight& light, const Vec3& point,
                                            const Vec3& normal, double error) {
    std::vector<ContourWidth> widths;
    const Vec3 from = light.body->in_front(point, normal);
    if (light.body->contains(from)) return widths;
    for (const ContourView& view : ContourView::all(*light.body, from, normal)) {
        ContourWidth width(*light.body, view, normal, error);
        if (!width.turns_.empty()) widths.push_back(std::move(width));
    }
    return widths;
}

std::optional<ContourWidth> ContourWidth::of(const ContourLight& light, const Vec3& point,
                                             const Vec3& normal) {
    const Vec3 from = light.body->in_front(point, normal);
    if (light.body->contains(from)) return std::nullopt;
    const auto view = ContourView::one(*light.body, from, normal);
    if (!view) return std::nullopt;
    constexpr double of_lobes = 1e-3; // whose rules halve the width where they must
    ContourWidth width(*light.body, *view, normal, of_lobes);
    if (width.turns_.empty()) return std::nullopt;
    return width;
}

ContourWidth::ContourWidth(const LuminousBody& body, const ContourView& view, const Vec3& normal,
                           double error)
    : AreaWidth(view.point + view.ahead * view.distance, -view.ahead, view.along, view.point,
                normal),
      body_(&body),
      view_(view) {
    set_extent(view.extent);
    std::vector<Vec3> region;
    for (const double u : {view.extent.begin, view.extent.end})
        for (const double angle : {view.turn.begin, view.turn.end})
            region.push_back(view.on_plane(u, angle));
    outline_ = body.outline_from(view.point, std::move(region));
    find_turns(error);
}

bool ContourWidth::is_dark(double begin, double end) const {
    constexpr std::array places{0.02, 0.25, 0.5, 0.75, 0.98};
    return std::all_of(places.begin(), places.end(), [&](double place) {
        return chords_at(begin + (end - begin) * place).empty();
    });
}

double ContourWidth::share_of_view() const {
    constexpr int lines = 8;
    double sum = 0;
    for (int i = 0; i < lines; ++i) {
        const double place = (i + 0.5) / lines;
        for (const ParameterInterval& chord :
             chords_at(view_.turn.begin + view_.turn.length() * place))
            sum += chord.length();
    }
    return sum / lines / view_.extent.length();
}

std::vector<double> ContourWidth::turning_angles(double missed) const {
    const auto line = [&](double angle) {
        return Segment{view_.on_plane(view_.extent.begin, angle),
                       view_.on_plane(view_.extent.end, angle)};
    };
    const Segment first = line(view_.turn.begin), last = line(view_.turn.end);
    std::vector<double> angles{view_.turn.begin, view_.turn.end};
    const TurnRule rule{.spacing = 0.5, .missed = missed};
    for (const CriticalSlice& slice : outline_->turns({first, first, last, last}, rule))
        if (const double at = wedge_angle(slice.way); at > view_.turn.begin && at < view_.turn.end)
            angles.push_back(at);
    std::sort(angles.begin(), angles.end());
    const auto near = [](double a, double b) { return b - a < one_turn; };
    angles.erase(std::unique(angles.begin(), angles.end(), near), angles.end());
    return angles;
}

std::vector<double> ContourWidth::lit_angles(std::vector<double> angles) const {
    while (angles.size() > 1 && is_dark(angles[0], angles[1])) angles.erase(angles.begin());
    while (angles.size() > 1 && is_dark(angles[angles.size() - 2], angles.back()))
        angles.pop_back();
    if (angles.size() < 2) angles.clear();
    return angles;
}

bool ContourWidth::parts_change(double before, double at, double after) const {
    constexpr double beside = 1e-3; // of the way to the neighbours
    return chords_at(at - beside * (at - before)).size() !=
           chords_at(at + beside * (after - at)).size();
}

/// Finds the wedge angles at which the contour turns, as far as there is light between.
void ContourWidth::find_turns(double error) {
    // Below the first every turn counts, and in pictures where a body leaves most of its view dark.
    constexpr double in_numbers = 1e-4, sparse = 0.1;
    const double share = error < in_numbers ? 0 : share_of_view();
    const bool all_count = share < sparse;
    const std::vector<double> angles = lit_angles(turning_angles(all_count ? 0 : error * share));
    if (angles.empty()) return;
    // In pictures some turns suffice: rules halve the width where others matter.
    const double apart = all_count ? 0 : 0.08 * (angles.back() - angles.front());
    turns_.push_back(angles.front());
    for (std::size_t i = 1; i + 1 < angles.size(); ++i)
        if (angles[i] - turns_.back() >= apart ||
            parts_change(angles[i - 1], angles[i], angles[i + 1]))
            turns_.push_back(angles[i]);
    turns_.push_back(angles.back());
}

std::vector<double> ContourWidth::cuts() const {
    std::vector<double> places;
    const double from = turns_.front(), length = turns_.back() - from;
    for (const double angle : turns_) places.push_back(2 * (angle - from) / length - 1);
    places.back() = 1;
    return places;
}

SubAxis ContourWidth::sub_axis(double place) const {
    const double from = turns_.front(), length = turns_.back() - from;
    const double even = from + length * (place + 1) / 2;
    const auto next = std::upper_bound(turns_.begin() + 1, turns_.end() - 1, even);
    const double middle = (*next + next[-1]) / 2, half = (*next - next[-1]) / 2;
    const double s = pi / 2 * std::clamp((even - middle) / half, -1.0, 1.0);
    return line_at(distance() * std::tan(middle + half * std::sin(s)),
                   pi / 4 * length * std::cos(s));
}

double ContourWidth::place_in(const Vec3& way) const {
    const double from = turns_.front(), length = turns_.back() - from, angle = wedge_angle(way);
    if (!(angle > from && angle < turns_.back()))
        return std::copysign(2, angle - from - length / 2);
    const auto next = std::upper_bound(turns_.begin() + 1, turns_.end() - 1, angle);
    const double middle = (*next + next[-1]) / 2, half = (*next - next[-1]) / 2;
    const double even =
        middle + half * std::asin(std::clamp((angle - middle) / half, -1.0, 1.0)) * (2 / pi);
    return 2 * (even - from) / length - 1;
}

std::vector<ParameterInterval> ContourWidth::chords(double v) const {
    constexpr double rounding = 1e-13; // of the distance
    constexpr std::size_t most_known = 64;
    for (const auto& [at, chords] : known_)
        if (std::abs(at - v) <= rounding * (distance() + std::abs(v))) return chords;
    const double from = extent().begin, length = extent().length();
    const double angle = std::atan2(v, distance());
    std::vector<ParameterInterval> chords;
    const Segment line{view_.on_plane(from, angle), view_.on_plane(extent().end, angle)};
    for (const ParameterInterval& part : outline_->intervals(line).complement())
        chords.push_back({from + part.begin * length, from + part.end * length});
    if (known_.size() < most_known) known_.emplace_back();
    known_[oldest_++ % most_known] = {v, chords};
    return chords;
}

Vec3 ContourWidth::way_to(double u, double v) const {
    return (view_.along * u + view_.across() * v + view_.ahead * distance()).normalized();
}

Vec3 ContourWidth::front(const Vec3& way) const {
    const auto t = body_->distance(point(), way);
    const double middle = view_.reach.center().z / way.dot(view_.ahead);
    return point() + way * (t.value_or(middle) * (1 - flush));
}

Vec3 ContourWidth::place(const SubAxis& axis, double half_tangent) const {
    return front(direction(axis, half_tangent));
}

double ContourWidth::u_of(const Vec3& at) const {
    const Vec3 way = at - point();
    return distance() * way.dot(view_.along) / way.dot(view_.ahead);
}

Prism ContourWidth::around() const {
    Prism prism;
    const Vec3 &low = view_.reach.lower, &high = view_.reach.upper;
    std::size_t i = 0;
    for (const double y : {low.y, high.y})
        for (const double z : {low.z, high.z}) {
            const Vec3 edge = point() + view_.across() * y + view_.ahead * z;
            prism[i++] = {edge + view_.along * low.x, edge + view_.along * high.x};
        }
    return prism;
}

void ContourWidth::add_pieces(const Vec3& from, const Vec3& to, double v, int depth,
                              std::vector<Segment>& pieces) const {
    constexpr double hollow = 1e-3; // of the distance, by which the front lies behind its chord
    const double middle = (u_of(from) + u_of(to)) / 2;
    const Vec3 at = front(way_to(middle, v)), a = from - point(), b = to - point();
    const double level_a = a.dot(view_.along) * distance() - middle * a.dot(view_.ahead);
    const double level_b = b.dot(view_.along) * distance() - middle * b.dot(view_.ahead);
    const Vec3 on_chord = a + (b - a) * (level_a / (level_a - level_b));
    const bool is_hollow = (at - point()).length() > on_chord.length() * (1 + hollow);
    if (depth == 0 || !is_hollow) return pieces.push_back({from, to});
    add_pieces(from, at, v, depth - 1, pieces);
    add_pieces(at, to, v, depth - 1, pieces);
}

IntervalSet ContourWidth::visible_on(const Segment& line, const Visibility& others) const {
    constexpr int most_halvings = 4;
    const Vec3 way = line.a - point();
    const double v = distance() * way.dot(view_.across()) / way.dot(view_.ahead);
    const double from = u_of(line.a), whole = u_of(line.b) - from;
    std::vector<ParameterInterval> hidden;
    for (const ParameterInterval& chord : chords(v)) {
        const double length = chord.length();
        const double inset =
            std::clamp(of_lines * extent().length(), inside * length, most_inside * length);
        std::vector<Segment> pieces;
        add_pieces(front(way_to(chord.begin + inset, v)), front(way_to(chord.end - inset, v)), v,
                   most_halvings, pieces);
        const std::vector<IntervalSet> seen = others.intervals(pieces);
        for (std::size_t i = 0; i < pieces.size(); ++i)
            for (const ParameterInterval& dark : seen[i].complement()) {
                const bool begins = i == 0 && dark.begin == 0;
                const bool ends = i + 1 == pieces.size() && dark.end == 1;
                hidden.push_back(
                    {((begins ? chord.begin : u_of(pieces[i].at(dark.begin))) - from) / whole,
                     ((ends ? chord.end : u_of(pieces[i].at(dark.end))) - from) / whole});
            }
    }
    return IntervalSet(std::move(hidden)).complement();
}

} // namespace keiko
