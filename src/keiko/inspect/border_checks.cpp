#include "keiko/inspect/border_checks.h"

#include "keiko/inspect/basics/placed_face.h"
#include "keiko/inspect/check_sentence.h"
#include "keiko/inspect/flaws/narrow_bends.h"
#include "keiko/inspect/openings/grooves.h"
#include "keiko/inspect/openings/missing_caps.h"
#include "keiko/inspect/openings/torn_edges.h"
#include "keiko/inspect/overlaps/body_crossings.h"
#include "keiko/inspect/seams/narrow_faces.h"

#include <algorithm>
#include <array>
#include <initializer_list>
#include <iterator>

namespace keiko {
namespace {

/// Checks, each of one placed face.
class FaceChecks {
public:
    FaceChecks(const SurfaceModel& model, const FaceLimits& limits)
        : model_(model), limits_(limits), faces_(placed_faces(model)) {}

    /// Adds a check of the first of these faces that is judged, if one is.
    void add(std::initializer_list<PlacedFace> sides, Check check) {
        const auto* const of =
            std::find_if(sides.begin(), sides.end(),
                         [&](const PlacedFace& side) { return limits_.in_scope(side); });
        if (of == sides.end()) return;
        const auto before = [](const PlacedFace& a, const PlacedFace& b) {
            return std::pair(a.instance, a.face) < std::pair(b.instance, b.face);
        };
        const auto at = std::lower_bound(faces_.begin(), faces_.end(), *of, before);
        check.face = static_cast<std::uint32_t>(at - faces_.begin());
        checks_.push_back(std::move(check));
    }
    std::string name(const PlacedFace& of) const {
        return placed_face_name(model_, of.instance, of.face);
    }
    /// Names of both faces; a single name if both are the same.
    std::string names(const std::array<PlacedFace, 2>& of) const {
        return of[0] == of[1] ? name(of[0]) : faces_at_seam(model_, of[0], of[1]);
    }
    std::vector<Check> take() { return std::move(checks_); }

private:
    const SurfaceModel& model_;
    const FaceLimits& limits_;
    std::vector<PlacedFace> faces_;
    std::vector<Check> checks_;
};

std::vector<Overlap> all_overlaps(const ModelBorders& borders, const FreeEdges& edges,
                                  std::span<const Seam> pieces, const OverlapLimits& limits,
                                  const Job& job) {
    std::vector<Overlap> overlaps =
        find_overlaps(borders.model, borders.curves, edges, limits, job);
    const std::vector<Overlap> crossings =
        body_crossings(borders, pieces, overlaps, limits.join, job);
    overlaps.insert(overlaps.end(), crossings.begin(), crossings.end());
    return overlaps;
}

std::vector<Opening> all_openings(const ModelBorders& borders, const FreeEdges& edges,
                                  std::span<const Seam> pieces, const OpeningLimits& limits,
                                  const Job& job) {
    std::vector<Opening> openings = find_openings(borders.curves, edges, limits, job);
    const std::vector<Opening> caps =
        missing_caps(borders.model, borders.curves, edges, pieces, limits, openings, job);
    openings.insert(openings.end(), caps.begin(), caps.end());
    return openings;
}

/// G-SU-LG: the borders of an edge that faces share by the file are wider apart than the join
/// distance. Without faces.
Check check_of_torn_edge(const TornEdge& torn, double gap, double join) {
    const MeasuredValue worst{torn.distance, 0, gap, torn.place, Verdict::fail};
    Check check = judged_check("G-SU-LG", "mm", worst, {"the gap at a shared edge", " mm"});
    check.message += "; the file joins these faces there, but their borders are more than " +
                     short_number(join) + " mm apart for some " + short_number(torn.length) + " mm";
    return check;
}

/// Narrow strips beside creases, and strips that are kinks.
void add_strips(const ModelBorders& borders, std::span<const MeasuredSeam> seams,
                std::span<const Seam> pieces, const FaceLimits& limits, double join,
                FaceChecks& checks, const Job& job) {
    for (const NarrowFace& narrow : narrow_faces(borders, seams, pieces, join, job)) {
        Check check = check_of_narrow(narrow, join, checks.names(narrow.neighbours));
        check.faces = checks.name(narrow.face);
        checks.add({narrow.face, narrow.neighbours[0], narrow.neighbours[1]}, std::move(check));
    }
    for (const NarrowBend& bend : narrow_bends(borders, seams, pieces, limits, job)) {
        const CriteriaPreset& of_seam = limits.between(bend.seam[0], bend.seam[1]);
        Check check = check_of_bend(bend, of_seam, checks.names(bend.sides));
        check.faces = checks.name(bend.face);
        checks.add({bend.face, bend.sides[0], bend.sides[1]}, std::move(check));
    }
}

} // namespace

std::vector<Check> checks_at_borders(const ModelBorders& borders,
                                     std::span<const MeasuredSeam> seams,
                                     std::span<const Seam> pieces, const FaceLimits& limits,
                                     double join, const Job& job) {
    const SurfaceModel& model = borders.model;
    const CriteriaPreset& strictest = limits.strictest();
    const auto limits_at = [&](const std::array<PlacedFace, 2>& sides) -> const CriteriaPreset& {
        return limits.between(sides[0], sides[1]);
    };
    FaceChecks checks(model, limits);
    add_strips(borders, seams, pieces, limits, join, checks, job);
    const FreeEdges edges = free_edges(borders.curves, pieces, strictest.gap, join, job);
    for (const TornEdge& torn :
         torn_edges(model, borders.curves, edges, join, strictest.negligible, job)) {
        Check check = check_of_torn_edge(torn, limits_at(torn.sides).gap, join);
        check.faces = checks.names(torn.sides);
        checks.add({torn.sides[0], torn.sides[1]}, std::move(check));
    }
    const auto add = [&](const std::array<PlacedFace, 2>& sides, Check check) {
        checks.add({sides[0], sides[1]}, std::move(check));
    };
    const OpeningLimits small{join, strictest.negligible, strictest.gap};
    for (const Opening& opening : all_openings(borders, edges, pieces, small, job))
        add(opening.sides,
            check_of_opening(opening, limits_at(opening.sides), checks.names(opening.sides)));
    for (const Groove& groove : grooves(borders, seams, pieces, small, strictest))
        add(groove.sides,
            check_of_groove(groove, limits_at(groove.sides), checks.names(groove.sides)));
    for (const Overlap& overlap :
         all_overlaps(borders, edges, pieces, {join, strictest.negligible}, job))
        add(overlap.sides,
            check_of_overlap(overlap, limits_at(overlap.sides), checks.names(overlap.sides)));
    return checks.take();
}

} // namespace keiko
