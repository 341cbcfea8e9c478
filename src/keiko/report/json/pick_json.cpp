#include "keiko/report/content/picked_place.h"
#include "keiko/report/markup/json_text.h"

#include <cmath>

namespace keiko {
namespace {

/// Both ends, or null where nothing is proved.
Json range_json(const Interval& range) {
    if (!std::isfinite(range.low) || !std::isfinite(range.high)) return {};
    return {range.low, range.high};
}

Json place_json(const PickedPlace& picked) {
    return {{"face", picked.face},
            {"place", point(picked.place)},
            {"bound", picked.bound},
            {"unique", picked.unique},
            {"normal", point(picked.normal)},
            {"curvatures", {range_json(picked.k1), range_json(picked.k2)}}};
}

} // namespace

std::string pick_json(const std::optional<PickedPlace>& picked) {
    return text_of({{"format", "keiko-pick/1"}, {"picked", picked ? place_json(*picked) : Json()}});
}

} // namespace keiko
