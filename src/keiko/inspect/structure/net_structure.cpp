#include "keiko/inspect/structure/net_structure.h"

#include "keiko/base/units.h"
#include "keiko/inspect/structure/least_value.h"

#include <algorithm>

namespace keiko {
namespace {

/// The way from one control point of a row to the next.
struct Leg {
    Vec3 from{0}, way{0}; ///< mm, about the middle of the net
    double length = 0;    ///< mm
};

using Legs = std::vector<Leg>;

Legs legs_of(const CurvePoints& row) {
    Legs legs;
    for (std::size_t i = 0; i + 1 < row.size(); ++i) {
        const Vec3 from = euclidean(row[i]), way = euclidean(row[i + 1]) - from;
        legs.push_back({from, way, way.length()});
    }
    return legs;
}

/// The worst of the values that `measure` has for the net and legs of each row that is no point.
template <class Measure, class Worse>
std::optional<MeasuredValue> worst_row(const std::vector<SpanNet>& nets, const Measure& measure,
                                       const Worse& worse) {
    std::optional<MeasuredValue> worst;
    for (const SpanNet& net : nets)
        for (const bool in_u : {true, false})
            for (const CurvePoints& row : net.rows(in_u)) {
                if (is_point(row, net.coincidence())) continue;
                const std::optional<MeasuredValue> found = measure(net, legs_of(row));
                if (found) worst = worst ? worse(*worst, *found) : *found;
            }
    return worst;
}

/// The angle between two legs at a place of the net, held to `limit` degrees; nullopt if either has
/// no length. The error of an end of a leg is the rounding.
std::optional<MeasuredValue> angle(const SpanNet& net, const Leg& a, const Leg& b, double limit) {
    const double shorter = std::min(a.length, b.length);
    if (!(shorter > net.coincidence())) return std::nullopt;
    const double value = radians_to_degrees(angle_between(a.way, b.way));
    const double bound = radians_to_degrees(4 * net.placed.rounding / shorter);
    return MeasuredValue{value, bound, limit, net.world(b.from), judge(value, bound, limit), false};
}

std::optional<MeasuredValue> turn_of_row(const SpanNet& net, const Legs& legs, double limit) {
    std::optional<MeasuredValue> worst;
    const Leg* last = nullptr;
    // Legs of no length are skipped: the row goes on in the direction of the next one.
    for (const Leg& leg : legs) {
        if (!(leg.length > net.coincidence())) continue;
        if (last != nullptr) keep_worse(worst, angle(net, *last, leg, limit));
        last = &leg;
    }
    return worst;
}

std::optional<MeasuredValue> ratio_of_row(const SpanNet& net, const Legs& legs, double limit) {
    std::optional<MeasuredValue> worst;
    for (std::size_t i = 0; i + 1 < legs.size(); ++i) {
        const double least = net.coincidence();
        const double a = std::max(legs[i].length, least), b = std::max(legs[i + 1].length, least);
        const double value = std::max(a, b) / std::min(a, b);
        const double bound = value * (2 * net.placed.rounding) * (1 / a + 1 / b);
        keep_worse(worst, MeasuredValue{value, bound, limit, net.world(legs[i + 1].from),
                                        judge(value, bound, limit), false});
    }
    return worst;
}

std::optional<MeasuredValue> shortest_of_row(const SpanNet& net, const Legs& legs, double limit) {
    const Leg& leg = *std::min_element(
        legs.begin(), legs.end(), [](const Leg& a, const Leg& b) { return a.length < b.length; });
    return at_least(leg.length, 2 * net.placed.rounding, limit, net.world(leg.from));
}

} // namespace

std::optional<MeasuredValue> largest_turn(const std::vector<SpanNet>& nets, double limit) {
    return worst_row(
        nets,
        [limit](const SpanNet& net, const Legs& legs) { return turn_of_row(net, legs, limit); },
        worse_of);
}

std::optional<MeasuredValue> largest_twist(const std::vector<SpanNet>& nets, double limit) {
    std::optional<MeasuredValue> worst;
    for (const SpanNet& net : nets)
        for (const bool in_u : {true, false}) {
            const std::vector<CurvePoints> rows = net.rows(in_u);
            for (std::size_t k = 0; k + 1 < rows.size(); ++k) {
                const Legs one = legs_of(rows[k]), next = legs_of(rows[k + 1]);
                for (std::size_t i = 0; i < one.size(); ++i)
                    keep_worse(worst, angle(net, one[i], next[i], limit));
            }
        }
    return worst;
}

std::optional<MeasuredValue> largest_ratio(const std::vector<SpanNet>& nets, double limit) {
    return worst_row(
        nets,
        [limit](const SpanNet& net, const Legs& legs) { return ratio_of_row(net, legs, limit); },
        worse_of);
}

std::optional<MeasuredValue> shortest_leg(const std::vector<SpanNet>& nets, double limit) {
    return worst_row(
        nets,
        [limit](const SpanNet& net, const Legs& legs) { return shortest_of_row(net, legs, limit); },
        lesser_of);
}

} // namespace keiko
