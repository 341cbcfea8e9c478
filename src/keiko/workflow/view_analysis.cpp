#include "keiko/workflow/view_analysis.h"

#include "keiko/report/content/view_facts.h"
#include "keiko/report/markup/json_text.h"
#include "keiko/workflow/analysis_file.h"
#include "keiko/workflow/hidden_faces.h"

namespace keiko {

Analysis requested_analysis(const ViewRequest& request, const LightRig& rig,
                            const SurfaceModel& body, const Job& job) {
    require_faces(body, request.hidden);
    Analysis analysis{.file = {},
                      .views = request.views,
                      .sections = request.sections,
                      .rig = request.planes ? with_planes(rig, *request.planes) : rig,
                      .hidden = hidden_faces(body, request.hidden, job),
                      .notes = request.notes};
    require_valid(analysis);
    return followed_analysis(std::move(analysis), body, job).analysis;
}

std::string view_analysis_json(const std::optional<FollowedAnalysis>& shown, const LightRig& rig) {
    Json json{{"format", "keiko-view-analysis/1"}, {"analysis", nullptr}};
    json["remarks"] = diagnostics_json(shown ? shown->remarks : Diagnostics());
    json["rig"] = Json::parse(rig_json(rig));
    if (shown) json["analysis"] = Json::parse(analysis_text(shown->analysis));
    return text_of(json);
}

} // namespace keiko
