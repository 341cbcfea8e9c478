#include "keiko/report/content/mesh_error.h"

#include <gtest/gtest.h>

namespace keiko {
namespace {

/// One mesh in two views without pictures.
MeshErrorReport report_of(const MeshErrors& first, const MeshErrors& second) {
    MeshErrorReport report{"1.0", "part.step", "of the scene"};
    report.meshes.push_back({1, 0.9, 12, {}});
    for (const MeshErrors& errors : {first, second}) {
        MeshErrorView view{"view", 10, 10};
        view.meshes.push_back({errors});
        report.views.push_back(view);
    }
    return report;
}

TEST(MeshErrorText, SumsPixelsOverTheViews) {
    MeshErrors first, second;
    first.compared = 100, first.wrong = 30, first.missed.all = 2, first.added.all = 1;
    second.compared = 300, second.wrong = 10, second.missed.all = 3, second.other_face.all = 4;
    const MeshErrorReport report = report_of(first, second);
    EXPECT_EQ(wrong_share(report, 0), 0.1);
    EXPECT_EQ(mesh_error_head(report, 0),
              "10.00 % of the mirrored pixels wrong; "
              "5 pixels missed, 1 added, 4 of another face");
}

TEST(MeshErrorText, HasNoShareOfNothing) {
    MeshErrors missed;
    missed.body = 5, missed.missed.all = 5;
    const MeshErrorReport report = report_of(missed, {});
    EXPECT_EQ(wrong_share(report, 0), std::nullopt);
    const std::string text = mesh_error_text(report);
    EXPECT_NE(text.find("no pixel mirrors the lamps; 5 pixels missed"), std::string::npos) << text;
    EXPECT_EQ(text.find("% of the mirrored"), std::string::npos);
    EXPECT_NE(mesh_error_json(report).find("\"wrong_share\": null"), std::string::npos);
}

} // namespace
} // namespace keiko
