#include "keiko/inspect/openings/missing_caps.h"

#include "keiko/base/parallel.h"
#include "keiko/geometry/trim/trim_region.h"
#include "keiko/inspect/basics/placed_face.h"
#include "keiko/inspect/openings/bodies.h"
#include "keiko/inspect/openings/hole_form.h"

#include <algorithm>
#include <limits>
#include <set>

namespace keiko {
namespace {

using EdgeNumbers = std::vector<std::uint32_t>; ///< into FreeEdges::all

/// The outline that all free edges of a body form together; nullopt if they form several, or none.
std::optional<Strand> only_outline(const FreeEdges& edges, const EdgeNumbers& of_body) {
    constexpr double any_length = std::numeric_limits<double>::infinity();
    const FreeEnd start{of_body.front(), false};
    const bool whole_loop = edges.all[start.edge].closed;
    const std::optional<FreeEnd> back =
        whole_loop ? FreeEnd{start.edge, true} : edges.next_of(start);
    if (!back) return std::nullopt;
    std::optional<Strand> outline(std::in_place, edges, start, *back, any_length);
    std::set<std::uint32_t> along;
    for (const FreePlace& place : outline->places(any_length)) along.insert(place.edge);
    const bool single = outline->closed() && along.size() == of_body.size();
    return single ? outline : std::nullopt;
}

/// Area of the material of a placed face to a few per cent, mm2: by the middles of 8 x 8 cells of
/// each patch.
double rough_area(const SurfaceModel& model, const PlacedFace& of) {
    constexpr int cells = 8;
    const Face& face = model.faces[of.face];
    const TrimRegion trims(model, face);
    double area = 0;
    for (std::uint32_t k = 0; k < face.patch_count; ++k)
        for (int i = 0; i < cells; ++i)
            for (int j = 0; j < cells; ++j) {
                const std::uint32_t patch = face.first_patch + k;
                const Vec2 uv((i + 0.5) / cells, (j + 0.5) / cells);
                if (!trims.untrimmed() && !trims.contains(model.face_parameters(patch, uv)))
                    continue;
                const SurfaceDerivatives s = placed_derivatives(model, of.instance, patch, uv);
                area += s.du().cross(s.dv()).length() / (cells * cells);
            }
    return area;
}

bool is_flat(const HoleForm& form) {
    constexpr double share = 0.1;
    return form.depth <= share * form.width;
}

std::optional<Opening> cap_of(const SurfaceModel& model, const BoundaryCurves& curves,
                              const FreeEdges& edges, const EdgeNumbers& of_body,
                              const std::vector<PlacedFace>& faces, double gap) {
    if (of_body.empty()) return std::nullopt;
    const std::optional<Strand> outline = only_outline(edges, of_body);
    if (!outline) return std::nullopt;
    const std::optional<HoleForm> form = hole_form(curves, edges, *outline);
    if (!form || !is_flat(*form) || form->width <= gap) return std::nullopt;
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
                                  const FreeEdges& edges, std::span<const Seam> seams, double gap,
                                  std::span<const Opening> known, const Job& job) {
    const Bodies bodies(model, seams);
    std::vector<EdgeNumbers> of_body(bodies.count());
    for (std::uint32_t e = 0; e < edges.all.size(); ++e)
        of_body[bodies.of(edges.all[e].face())].push_back(e);
    std::vector<std::optional<Opening>> found(bodies.count());
    parallel_for(bodies.count(), job, "", [&](std::size_t i) {
        found[i] = cap_of(model, curves, edges, of_body[i], bodies.faces(i), gap);
    });
    std::vector<Opening> caps;
    for (const auto& cap : found) {
        const auto is_at = [&](const Opening& other) { return other.place == cap->place; };
        if (cap && std::none_of(known.begin(), known.end(), is_at)) caps.push_back(*cap);
    }
    return caps;
}

} // namespace keiko
