#include "keiko/workflow/followed_analysis.h"

#include "keiko/compare/alignment/closest_point_query.h"
#include "keiko/geometry/trim/material_bounds.h"

#include <algorithm>
#include <map>
#include <optional>
#include <set>
#include <sstream>

namespace keiko {
namespace {

/// Share of a body's size over which places are followed: surfaces that are worked over move by
/// millimetres, on bodies of metres.
constexpr double followed_share = 0.01;

std::string millimetres(double length) {
    std::ostringstream text;
    text.precision(3);
    text << length << " mm";
    return text.str();
}

/// A body that places are followed on. Its trees are built when the first place is.
class FollowedBody {
public:
    FollowedBody(const SurfaceModel& model, const Job& job) : model_(model), job_(job) {}

    /// The nearest point within reach; of the faces of a name, unless that is empty.
    std::optional<ClosestSurfacePoint> nearest(const Vec3& place, const std::string& name = {}) {
        check_stop();
        const FaceFilter is_named = [&](std::uint32_t face) { return face_of(face).name == name; };
        return query().foot(place, reach_, name.empty() ? FaceFilter() : is_named);
    }
    /// The face of such a point.
    const Face& face_of(std::uint32_t placed) const {
        return model_.faces[query_->body().origin[placed].face];
    }
    /// "none of the part within 12 mm of its place"
    std::string reason() {
        query();
        return "nothing of the part is within " + millimetres(reach_) + " of its place";
    }

private:
    const ClosestPointQuery& query() {
        if (!query_) {
            query_.emplace(placed_model(model_), job_);
            reach_ = followed_share * material_bounds(model_, job_).size();
        }
        return *query_;
    }

    const SurfaceModel& model_;
    const Job& job_;
    std::optional<ClosestPointQuery> query_;
    double reach_ = 0; ///< mm
};

HiddenFace hidden_as(const Face& face, const std::optional<Vec3>& place) {
    return {face.id, face.name, place};
}

/// The face of the body that a hidden one is; nullopt if there is none.
std::optional<HiddenFace> followed(const HiddenFace& hidden, const SurfaceModel& model,
                                   FollowedBody& body) {
    std::vector<const Face*> named;
    for (const Face& face : model.faces)
        if (!hidden.name.empty() && face.name == hidden.name) named.push_back(&face);
    if (named.size() == 1) return hidden_as(*named.front(), hidden.place);
    if (!hidden.place) return {};
    const auto found = body.nearest(*hidden.place, named.empty() ? "" : hidden.name);
    if (!found) return {};
    return hidden_as(body.face_of(found->face), found->position);
}

std::string reason_of(const HiddenFace& hidden, FollowedBody& body) {
    const std::string name = hidden.name.empty() ? "" : "no face, or more than one, has the name; ";
    return "is not hidden: " + name + (hidden.place ? body.reason() : "it has no place");
}

void follow_hidden(FollowedAnalysis& all, const SurfaceModel& model, FollowedBody& body) {
    std::set<std::uint32_t> there;
    std::vector<HiddenFace> faces;
    for (const HiddenFace& hidden : all.analysis.hidden) {
        const auto face = followed(hidden, model, body);
        if (face && there.insert(face->face).second) faces.push_back(*face);
        if (face) continue;
        const std::string name = hidden.name.empty() ? "" : " (" + hidden.name + ")";
        all.remarks.push_back({Severity::warning,
                               "hidden face " + std::to_string(hidden.face) + name,
                               reason_of(hidden, body)});
    }
    all.analysis.hidden = std::move(faces);
}

void follow_notes(FollowedAnalysis& all, FollowedBody& body) {
    for (AnalysisNote& note : all.analysis.notes) {
        const auto found = body.nearest(note.place);
        note.face = found ? body.face_of(found->face).id : 0;
        if (found)
            note.place = found->position;
        else
            all.remarks.push_back({Severity::warning, "note " + in_quotes(shortened(note.text, 60)),
                                   "has no place any more: " + body.reason()});
    }
}

/// A place of each placed face, where it has one: of the middles of its pieces the one that is
/// farthest from borders, or else a point of its own border.
std::vector<std::optional<Vec3>> inner_places(const ClosestPointQuery& faces) {
    std::vector<std::optional<Vec3>> places(faces.body().origin.size());
    std::vector<double> farthest(places.size(), -1);
    for (std::size_t piece = 0; piece < faces.piece_count(); ++piece) {
        check_stop();
        const auto point = faces.point(piece, Vec2(0.5, 0.5));
        const double away = point ? faces.border_distance(point->position) : -1;
        if (!point || away <= farthest[point->face]) continue;
        farthest[point->face] = away, places[point->face] = point->position;
    }
    for (const BorderPoint& point : faces.border_points())
        if (!places[point.face]) places[point.face] = point.position;
    return places;
}

} // namespace

std::vector<std::uint32_t> FollowedAnalysis::hidden() const {
    std::vector<std::uint32_t> ids;
    for (const HiddenFace& face : analysis.hidden) ids.push_back(face.face);
    std::sort(ids.begin(), ids.end());
    return ids;
}

FollowedAnalysis followed_analysis(Analysis analysis, const SurfaceModel& body, const Job& job) {
    FollowedAnalysis all{std::move(analysis)};
    FollowedBody followed_body(body, job);
    follow_hidden(all, body, followed_body);
    follow_notes(all, followed_body);
    return all;
}

std::vector<HiddenFace> hidden_faces(const SurfaceModel& body,
                                     const std::vector<std::uint32_t>& ids, const Job& job) {
    std::vector<std::uint32_t> chosen;
    for (std::uint32_t face = 0; face < body.faces.size(); ++face)
        if (std::find(ids.begin(), ids.end(), body.faces[face].id) != ids.end())
            chosen.push_back(face);
    if (chosen.empty()) return {};
    const ClosestPointQuery query(placed_model(body, {}, chosen), job);
    const auto places = inner_places(query);
    std::map<std::uint32_t, HiddenFace> hidden; // by index: a face may be placed several times
    for (std::size_t i = 0; i < places.size(); ++i) {
        const std::uint32_t face = query.body().origin[i].face;
        hidden.emplace(face, hidden_as(body.faces[face], places[i]));
    }
    std::vector<HiddenFace> all;
    for (auto& [face, entry] : hidden) all.push_back(std::move(entry));
    return all;
}

} // namespace keiko
