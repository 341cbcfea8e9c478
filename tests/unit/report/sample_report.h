#pragma once

#include "keiko/base/units.h"
#include "keiko/report/content/report.h"

#include "tests/support/model_builder.h"

#include <cmath>

namespace keiko::test {

/// Two sheets with a gap of 0.04 mm, then one at 0.3 degrees, then a crease.
inline SurfaceModel model() {
    ModelBuilder builder;
    builder.plane({0, 0.04, 0}, {100, 0, 0}, {0, 50, 0});
    builder.plane({0, 0, 0}, {100, 0, 0}, {0, -50, 0});
    const auto down = [](double degrees) {
        const double angle = degrees_to_radians(degrees);
        return Vec3(0, -50 * std::cos(angle), -50 * std::sin(angle));
    };
    builder.plane({0, -50, 0}, {100, 0, 0}, down(0.3));
    builder.plane(Vec3(0, -50, 0) + down(0.3), {100, 0, 0}, down(40));
    SurfaceModel result = builder.build();
    result.source = "door <left>.step";
    result.faces[1].name = "A&B";
    result.lost_faces.push_back({7, "rear", "no surface"});
    result.repairs.push_back({2, RepairKind::loop_closed, 1, 0.25, ""});
    result.repairs.push_back({2, RepairKind::by_reader, 3, 0, "a <seam> added"});
    result.diagnostics.push_back({Severity::note, "face 2", "invalid in the file"});
    return result;
}

inline Report report() {
    Report result;
    result.tool_version = "9.9";
    result.inspection = inspect(model());
    result.coverage = CoverageSummary{"auto.toml", 0.875, {"face 4"}};
    ReportPicture picture{"front", "12 lamps", "front.png",  "not really a PNG",
                          200,     100,        {{1, 50, 25}}};
    result.pictures.push_back(picture);
    picture.file_name = "seam-1.png", picture.markers.clear();
    result.close_ups.push_back({CloseUp::Of::seam, 0, picture, {}});
    return result;
}

/// Two views; in the second a line jumps by 4 mm, in the first two pass, one of them all but.
inline LineList lines() {
    LineList list;
    list.rig = "tubes & more";
    list.views.resize(2);
    list.views[0].view = "front", list.views[1].view = "top";
    const auto add = [&](ViewLines& view, const char* faces, Verdict verdict, double severity) {
        LineCrossing crossing;
        crossing.faces = faces;
        crossing.to = 1;
        crossing.turn = {-0.25, 1e-6, 0.1, verdict};
        crossing.jump = {4, 1e-6, std::nullopt, Verdict::pass};
        crossing.verdict = verdict;
        crossing.severity = severity;
        view.found.crossings.push_back(crossing);
    };
    add(list.views[0], "near", Verdict::pass, 0.9);
    add(list.views[0], "good", Verdict::pass, 0.1);
    add(list.views[1], "bad <1>", Verdict::fail, 2.5);
    LineCrossing lost;
    list.views[1].found.crossings.push_back(lost);
    return list;
}

} // namespace keiko::test
