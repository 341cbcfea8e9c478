#include "keiko/inspect/openings/missing_caps.h"

#include "keiko/base/parallel.h"
#include "keiko/inspect/openings/bodies.h"
#include "keiko/inspect/openings/face_area.h"
#include "keiko/inspect/openings/hole_form.h"

#include <algorithm>
#include <limits>
#include <set>

namespace keiko {
namespace {

using EdgeNumbers = std::vector<std::uint32_t>; ///< into FreeEdges::all

/// The outline that the free edges of a body form together, except for `negligible` mm of them;
/// nullopt if they form several, or none.
std::optional<Strand> only_outline(const FreeEdges& edges, const EdgeNumbers& of_body,
                                   double negligible) {
    constexpr double any_length = std::numeric_limits<double>::infinity();
    const auto shorter = [&](std::uint32_t a, std::uint32_t b) {
        return edges.all[a].length() < edges.all[b].length();
    };
    const FreeEnd start{*std::max_element(of_body.begin(), of_body.end(), shorter), false};
    const bool whole_loop = edges.all[start.edge].closed;
    const std::optional<FreeEnd> back =
        whole_loop ? FreeEnd{start.edge, true} : edges.next_of(start);
    if (!back) return std::nullopt;
    std::optional<Strand> outline(std::in_place, edges, start, *back, any_length);
    std::set<std::uint32_t> along;
    for (const FreePlace& place : outline->places(any_length)) along.insert(place.edge);
    double left_out = 0;
    for (const std::uint32_t e : of_body)
        if (along.count(e) == 0) left_out += edges.all[e].length();
    return outline->closed() && left_out <= negligible ? outline : std::nullopt;
}

bool is_flat(const HoleForm& form) {
    constexpr double share = 0.1;
    return form.depth <= share * form.width;
}

std::optional<Opening> cap_of(const SurfaceModel& model, const BoundaryCurves& curves,
                              const FreeEdges& edges, const EdgeNumbers& of_body,
                              const std::vector<PlacedFace>& faces, const OpeningLimits& limits) {
    if (of_body.empty()) return std::nullopt;
    const std::optional<Strand> outline = only_outline(edges, of_body, limits.from);
    if (!outline) return std::nullopt;
    const std::optional<HoleForm> form = hole_form(curves, edges, *outline);
    if (!form || !is_flat(*form) || form->width <= limits.gap) return std::nullopt;
    double area = 0;
    for (const PlacedFace& face : faces) area += rough_area(model, face);
    constexpr double largest_share = 0.5;
    if (form->area > largest_share * area) return std::nullopt;
    const PlacedFace first = edges.all[of_body.front()].face();
    const PlacedFace last = edges.all[of_body.back()].face();
    return Opening{.sides = {first, last},
                   .width = form->width,
                   .width_bound = 2 * outline->deviation(),
                   .length = form->length,
                   .place = form->middle};
}

} // namespace

std::vector<Opening> missing_caps(const SurfaceModel& model, const BoundaryCurves& curves,
                                  const FreeEdges& edges, std::span<const Seam> seams,
                                  const OpeningLimits& limits, std::span<const Opening> known,
                                  const Job& job) {
    const Bodies bodies(model, seams);
    std::vector<EdgeNumbers> of_body(bodies.count());
    for (std::uint32_t e = 0; e < edges.all.size(); ++e)
        of_body[bodies.of(edges.all[e].face())].push_back(e);
    std::vector<std::optional<Opening>> found(bodies.count());
    parallel_for(bodies.count(), job, "", [&](std::size_t i) {
        found[i] = cap_of(model, curves, edges, of_body[i], bodies.faces(i), limits);
    });
    std::vector<Opening> caps;
    for (const auto& cap : found) {
        const auto is_at = [&](const Opening& other) {
            return (other.place - cap->place).length() <= limits.join;
        };
        if (cap && std::none_of(known.begin(), known.end(), is_at)) caps.push_back(*cap);
    }
    return caps;
}

} // namespace keiko
