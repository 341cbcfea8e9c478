#include "keiko/report/json/json_parts.h"

namespace keiko {
namespace {

Json extreme_json(double value, const JointSection& at) {
    return {{"value", value}, {"place", point(at.place())}};
}

/// From the smallest to the largest value of a quantity.
Json range_json(Json smallest, Json largest, double hidden, double error) {
    return {{"unit", "mm"},
            {"smallest", std::move(smallest)},
            {"largest", std::move(largest)},
            {"bound", hidden + error}};
}

Json sides_json(const JointSection& s) {
    Json sides = Json::array();
    for (const JointSide& side : s.sides)
        sides.push_back({{"border", point(side.border)},
                         {"foremost", point(side.foremost)},
                         {"radius", side.radius}});
    return sides;
}

Json section_json(const JointStation& station) {
    Json json = {{"along", station.along}};
    if (!station.section) {
        json["place"] = point(station.place), json["gap"] = Json();
        return json;
    }
    const JointSection& s = *station.section;
    json.update({{"place", point(s.place())},
                 {"gap", s.gap},
                 {"flush", s.flush},
                 {"bound", s.bound},
                 {"across", point(s.across)},
                 {"outward", point(s.outward)},
                 {"sides", sides_json(s)}});
    return json;
}

Json joint_json(const Joint& joint, std::size_t number) {
    Json json = {{"number", number},
                 {"faces", joint.names},
                 {"length", joint.length},
                 {"closed", joint.closed},
                 {"unmeasured", joint.unmeasured}};
    if (const auto& e = joint.extremes) {
        json["gap"] =
            range_json(extreme_json(e->narrowest.gap, e->narrowest),
                       extreme_json(e->widest.gap, e->widest), e->hidden_gap, e->widest.bound);
        json["flush"] = range_json(extreme_json(e->deepest.flush, e->deepest),
                                   extreme_json(e->proudest.flush, e->proudest), e->hidden_flush,
                                   e->proudest.bound);
        json["parallelism"] = e->widest.gap - e->narrowest.gap;
        json["radius"] = extreme_json(e->sharpest.least_radius(), e->sharpest);
    }
    json["sections"] = Json::array();
    for (const JointStation& station : joint.stations)
        json["sections"].push_back(section_json(station));
    return json;
}

Json nominal_json(const NominalSize& size) {
    return {{"nominal", size.nominal}, {"tolerance", size.tolerance}};
}

} // namespace

Json joints_json(const std::vector<Joint>& joints) {
    Json json = Json::array();
    for (const Joint& joint : joints) json.push_back(joint_json(joint, json.size() + 1));
    return json;
}

Json joint_limits_json(const JointLimits& limits) {
    Json json = Json::object();
    if (limits.gap) json["gap"] = nominal_json(*limits.gap);
    if (limits.flush) json["flush"] = nominal_json(*limits.flush);
    if (limits.parallelism) json["parallelism"] = *limits.parallelism;
    if (limits.radius) json["radius"] = *limits.radius;
    json["widest"] = limits.widest;
    json["largest_radius"] = limits.largest_radius;
    json["corner_radius"] = limits.corner_radius;
    json["spacing"] = limits.spacing;
    return json;
}

} // namespace keiko
