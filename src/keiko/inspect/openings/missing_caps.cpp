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

constexpr int lines = 8; ///< of a patch, and places of each stretch of a line

/// Adds the area of a patch by lines of constant v: of the stretches of each that are material.
class PatchArea {
public:
    PatchArea(const SurfaceModel& model, const PlacedFace& of, std::uint32_t patch,
              const TrimRegion& trims)
        : model_(model), of_(of), patch_(patch), trims_(trims) {}

    double all() const {
        double area = 0;
        for (int j = 0; j < lines; ++j) area += along((j + 0.5) / lines) / lines;
        return area;
    }

private:
    double along(double v) const {
        if (trims_.untrimmed()) return stretch(0, 1, v);
        const Patch& patch = model_.patches[patch_];
        std::vector<double> ends{0, 1};
        for (const double u : trims_.crossings(1, patch.map_v.to_face(v)))
            ends.push_back(std::clamp(patch.map_u.to_patch(u), 0.0, 1.0));
        std::sort(ends.begin(), ends.end());
        double sum = 0;
        for (std::size_t i = 1; i < ends.size(); ++i) {
            const Vec2 middle((ends[i - 1] + ends[i]) / 2, v);
            if (trims_.contains(model_.face_parameters(patch_, middle)))
                sum += stretch(ends[i - 1], ends[i], v);
        }
        return sum;
    }

    double stretch(double from, double to, double v) const {
        double sum = 0;
        for (int i = 0; i < lines && to > from; ++i) {
            const Vec2 uv(from + (to - from) * (i + 0.5) / lines, v);
            const SurfaceDerivatives s = placed_derivatives(model_, of_.instance, patch_, uv);
            sum += s.du().cross(s.dv()).length() * (to - from) / lines;
        }
        return sum;
    }

    const SurfaceModel& model_;
    const PlacedFace& of_;
    std::uint32_t patch_;
    const TrimRegion& trims_;
};

/// Area of the material of a placed face to some ten per cent, mm2: by the material's stretches on
/// 8 lines of each patch.
double rough_area(const SurfaceModel& model, const PlacedFace& of) {
    const Face& face = model.faces[of.face];
    const TrimRegion trims(model, face);
    double area = 0;
    for (std::uint32_t k = 0; k < face.patch_count; ++k)
        area += PatchArea(model, of, face.first_patch + k, trims).all();
    return area;
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
