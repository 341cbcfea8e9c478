#include "keiko/report/content/spread_text.h"

#include "keiko/report/markup/html_text.h"

#include <cmath>
#include <string_view>

namespace keiko {
namespace {

/// Largest difference in degrees between the halves of a beam that is called symmetric.
constexpr double symmetric_within = 0.05;
constexpr int digits = 6;

/// Names of a principal plane and of its sides.
struct PlaneNames {
    std::string_view plane, positive, negative;
};

PlaneNames names_of(PhotometricType type, int plane) {
    if (type == PhotometricType::c)
        return plane == 0 ? PlaneNames{"C0-C180", "C0", "C180"}
                          : PlaneNames{"C90-C270", "C90", "C270"};
    return plane == 0 ? PlaneNames{"horizontal", "H > 0", "H < 0"}
                      : PlaneNames{"vertical", "V > 0", "V < 0"};
}

std::string degrees(double angle) {
    return short_number(angle, digits) + " degrees";
}

/// Edges of a beam that lies on one side alone, `near` with a negative angle.
std::string one_sided_text(const SpreadEdge& near, const SpreadEdge& far, std::string_view side) {
    return (near.reached ? "from " : "from at most ") + short_number(-near.angle, digits) +
           (far.reached ? " to " : " degrees, not reached within ") + degrees(far.angle) +
           " towards " + std::string(side);
}

std::string edge_text(const SpreadEdge& edge, std::string_view side) {
    return (edge.reached ? "" : "not reached within ") + degrees(edge.angle) + " towards " +
           std::string(side);
}

std::string edges_text(const BeamSpread& spread, const PlaneNames& names) {
    const auto& [positive, negative, opposite] = spread;
    if (negative.angle < 0) return one_sided_text(negative, positive, names.positive);
    if (positive.angle < 0) return one_sided_text(positive, negative, names.negative);
    return edge_text(positive, names.positive) + ", " + edge_text(negative, names.negative);
}

std::string spread_words(const BeamSpread& spread, const PlaneNames& names) {
    const auto& [positive, negative, opposite] = spread;
    const bool symmetric = std::abs(positive.angle - negative.angle) <= symmetric_within &&
                           positive.reached == negative.reached;
    if (symmetric && !positive.reached) return "not reached within " + degrees(positive.angle);
    const auto full = spread.full_angle();
    if (!full) return edges_text(spread, names);
    return degrees(*full) + (symmetric ? "" : ": " + edges_text(spread, names));
}

Json edge_json(const SpreadEdge& edge) {
    return {{"degrees", edge.angle}, {"reached", edge.reached}};
}

Json edges_of(const std::optional<BeamSpread>& spread) {
    if (!spread) return nullptr;
    return {{"positive", edge_json(spread->positive)},
            {"negative", edge_json(spread->negative)},
            {"opposite", spread->opposite}};
}

Json full_angle_of(const std::optional<BeamSpread>& spread) {
    const auto full = spread ? spread->full_angle() : std::nullopt;
    return full ? Json(*full) : Json();
}

} // namespace

std::string spread_text(PhotometricType type, int plane, const std::optional<BeamSpread>& spread) {
    const PlaneNames names = names_of(type, plane);
    const std::string begin = std::string(names.plane) + ": ";
    if (!spread) return begin + "dark";
    return begin + spread_words(*spread, names) + (spread->opposite ? ", about the zenith" : "");
}

Json full_angles_json(const PrincipalSpreads& spreads) {
    return {{"plane_0", full_angle_of(spreads.plane_0)},
            {"plane_90", full_angle_of(spreads.plane_90)}};
}

Json edges_json(const PrincipalSpreads& spreads) {
    return {{"plane_0", edges_of(spreads.plane_0)}, {"plane_90", edges_of(spreads.plane_90)}};
}

} // namespace keiko
