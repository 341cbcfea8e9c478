#include "keiko/report/json/json_parts.h"

#include <algorithm>

namespace keiko {
namespace {

Json lines_json(const LineLimits& limits) {
    const auto optional = [](const std::optional<double>& limit) {
        return limit ? Json(*limit) : Json();
    };
    return {{"jump", optional(limits.jump)},
            {"turn", optional(limits.turn)},
            {"kink", optional(limits.kink)},
            {"bend", optional(limits.bend)}};
}

Json zone_json(const ZoneFacts& zone, const CriteriaPreset& preset) {
    Json json = {{"name", zone.name},
                 {"selection", zone.selection},
                 {"faces", zone.faces},
                 {"looser", zone.looser},
                 {"excused_seams", zone.excused_seams},
                 {"excused_faces", zone.excused_faces}};
    const auto of_preset = std::find_if(preset.zones.begin(), preset.zones.end(),
                                        [&](const Zone& other) { return other.name == zone.name; });
    if (of_preset == preset.zones.end()) return json;
    json["limits"] = limits_json(of_preset->limits);
    json["limits"]["lines"] = lines_json(of_preset->limits.lines);
    return json;
}

} // namespace

Json scope_json(const JudgedScope& scope, const CriteriaPreset& preset) {
    Json json = {{"selection", scope.selection}, {"faces", scope.faces},
                 {"all_faces", scope.all_faces}, {"seams", scope.seams},
                 {"all_seams", scope.all_seams}, {"out_of_scope", scope.outside},
                 {"in_no_zone", scope.zoneless}, {"zones", Json::array()}};
    for (const ZoneFacts& zone : scope.zones) json["zones"].push_back(zone_json(zone, preset));
    return json;
}

} // namespace keiko
