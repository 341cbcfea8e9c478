#include "keiko/base/units.h"
#include "keiko/inspect/lines/joined_lines.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>

namespace keiko {
namespace {

/// mm: ends this near each other on the part need no jump to explain it. Rounding of files causes
/// such distances, and so do ends that run nearly along the border.
constexpr double same_place = 1e-5;
/// Relative difference allowed between the jumps of both sides, as the field may change along the
/// border.
constexpr double alike = 0.5;
/// Factor by which the field's slope along the border may change between the ends. It predicts the
/// distance of the sides' ends and is evaluated at either end.
constexpr double prediction_slack = 4;

double distance(const LineEndpoint& a, const LineEndpoint& b) {
    return (a.place - b.place).length();
}

/// True if the field's jump between the sides explains the distance of the ends.
bool explained(const LineEndpoint& tail, const LineEndpoint& head) {
    const double jump = std::max(std::abs(tail.jump), std::abs(head.jump));
    const double least_slope = std::min(std::abs(tail.slope()), std::abs(head.slope()));
    const double reach = std::max(tail.gap, head.gap) + prediction_slack * jump / least_slope;
    if (!(distance(tail, head) <= reach + same_place)) return false;
    // A shift by same_place changes the field by that length times its gradient.
    const double noise = same_place * std::max(tail.course.density, head.course.density);
    return std::abs(tail.jump + head.jump) <= alike * jump + noise;
}

using Candidate = std::tuple<double, std::uint32_t, std::uint32_t>;

class Pairing {
public:
    Pairing(std::span<const LineEndpoint> meetings, double crease)
        : meetings_(meetings), crease_(crease) {}

    std::vector<LinePair> run() {
        join(candidates([](const LineEndpoint& m) { return m.border; }, false));
        join(candidates([](const LineEndpoint&) { return LineBorder{}; }, true));
        return std::move(pairs_);
    }

private:
    bool crossable(const LineEndpoint& meeting) const {
        return std::isfinite(meeting.jump) && meeting.angle <= crease_ &&
               !done_.count({meeting.piece, meeting.head});
    }

    /// Groups meetings by border and lamp, and lists matching pairs in each group.
    template <class BorderOf>
    std::vector<Candidate> candidates(const BorderOf& border_of, bool any_seam) const {
        std::map<std::tuple<LineBorder, std::uint32_t, std::uint32_t>, std::vector<std::uint32_t>>
            groups;
        for (std::uint32_t i = 0; i < meetings_.size(); ++i) {
            const LineEndpoint& m = meetings_[i];
            const bool asked = !any_seam || m.border.seam != no_index;
            if (asked && crossable(m)) groups[{border_of(m), m.plane, m.lamp}].push_back(i);
        }
        std::vector<Candidate> found;
        for (const auto& [key, members] : groups)
            for (const std::uint32_t tail : members)
                for (const std::uint32_t head : members)
                    if (!meetings_[tail].head && meetings_[head].head &&
                        (any_seam || meetings_[tail].second != meetings_[head].second) &&
                        explained(meetings_[tail], meetings_[head]))
                        found.emplace_back(distance(meetings_[tail], meetings_[head]), tail, head);
        return found;
    }

    void join(std::vector<Candidate> found) {
        std::sort(found.begin(), found.end());
        for (const auto& [apart, tail, head] : found) {
            const LineEndpoint &t = meetings_[tail], &h = meetings_[head];
            if (done_.count({t.piece, false}) || done_.count({h.piece, true})) continue;
            done_.insert({t.piece, false});
            done_.insert({h.piece, true});
            pairs_.push_back({tail, head});
        }
    }

    std::span<const LineEndpoint> meetings_;
    double crease_;
    std::set<std::pair<std::uint32_t, bool>> done_; ///< ends by piece; true: its head
    std::vector<LinePair> pairs_;
};

/// mm: accuracy of the nearest place of the other border.
constexpr double foot_error = 1e-9;
/// radians: error of a border's own direction.
constexpr double direction_rounding = 1e-12;

LineValue judged(double value, double bound, const std::optional<double>& limit) {
    LineValue result{value, bound, limit, Verdict::pass};
    if (limit) result.verdict = judge(std::abs(value), bound, *limit);
    return result;
}

/// Errors of one side of a crossing.
struct SideErrors {
    LineGeometryBounds course;
    double place = 0; ///< mm along the border
};

SideErrors errors_of(const LineEndpoint& m, const LampLevels& lamps) {
    const auto bounds = [&](double off) {
        return line_course_bounds(lamps.field, lamps.level(m.lamp), m.surface, m.degree, off);
    };
    SideErrors errors;
    errors.place = m.off + bounds(0).value / std::abs(m.slope());
    errors.course = bounds(errors.place);
    return errors;
}

/// Angle of the line to its border, positive to the left, radians.
double angle_to_border(const LineEndpoint& m) {
    const Vec3 beside = m.course.normal.cross(m.along);
    return std::atan2(beside.dot(m.course.tangent), m.along.dot(m.course.tangent));
}

void take(LineCrossing& crossing, const LineValue& value) {
    if (!value.limit) return;
    crossing.verdict = std::max(*crossing.verdict, value.verdict);
    crossing.severity = std::max(crossing.severity, std::abs(value.value) / *value.limit);
}

LineCrossing crossing_at(const LineEndpoint& end, const LampLevels& lamps, double place_error,
                         const LineLimits& limits) {
    LineCrossing crossing;
    crossing.from = end.piece, crossing.plane = end.plane, crossing.lamp = end.lamp;
    crossing.border = end.border, crossing.place = end.place;
    crossing.gap = end.gap, crossing.angle = end.angle;
    // Viewed from the following piece, the other side is the one that it comes from.
    crossing.plane_jump = end.head ? -end.jump : end.jump;
    const double off = place_error + foot_error;
    const double error =
        line_course_bounds(lamps.field, lamps.level(end.lamp), end.other, end.other_degree, off)
            .value;
    const double gain =
        lamps.field.turn_gain(end.other.position(), end.other.du().cross(end.other.dv()));
    crossing.turn = judged(radians_to_degrees(std::atan(crossing.plane_jump / gain)),
                           radians_to_degrees(error / gain), limits.turn);
    return crossing;
}

} // namespace

std::vector<LinePair> pair_meetings(std::span<const LineEndpoint> meetings, double crease) {
    return Pairing(meetings, crease).run();
}

LineCrossing line_crossing(const LineEndpoint& tail, const LineEndpoint& head,
                           const LampLevels& lamps, const LineLimits& limits) {
    const SideErrors from = errors_of(tail, lamps), into = errors_of(head, lamps);
    LineCrossing crossing = crossing_at(tail, lamps, from.place, limits);
    crossing.to = head.piece;
    crossing.verdict = Verdict::pass;
    const Vec3 left = (tail.course.left() + head.course.left()).normalized();
    crossing.jump =
        judged((head.place - tail.place).dot(left), from.place + into.place, limits.jump);
    const double kink =
        std::remainder(angle_to_border(head) - angle_to_border(tail), 2 * std::numbers::pi);
    crossing.kink = {
        radians_to_degrees(kink),
        radians_to_degrees(from.course.direction + into.course.direction + direction_rounding),
        std::nullopt, Verdict::pass};
    crossing.bend = {head.course.bend - tail.course.bend, from.course.bend + into.course.bend,
                     std::nullopt, Verdict::pass};
    take(crossing, crossing.turn);
    take(crossing, crossing.jump);
    if (crossing.verdict != Verdict::pass) return crossing;
    crossing.kink = judged(crossing.kink.value, crossing.kink.bound, limits.kink);
    take(crossing, crossing.kink);
    if (crossing.verdict != Verdict::pass) return crossing;
    crossing.bend = judged(crossing.bend.value, crossing.bend.bound, limits.bend);
    take(crossing, crossing.bend);
    return crossing;
}

LineCrossing line_break(const LineEndpoint& end, const LampLevels& lamps,
                        const LineLimits& limits) {
    LineCrossing crossing = crossing_at(end, lamps, errors_of(end, lamps).place, limits);
    if (crossing.turn.limit && crossing.turn.verdict == Verdict::fail) {
        crossing.verdict = Verdict::pass;
        take(crossing, crossing.turn);
    }
    return crossing;
}

} // namespace keiko
