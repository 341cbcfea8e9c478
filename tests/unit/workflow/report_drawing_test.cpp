#include "keiko/workflow/report_drawing.h"

#include "tests/support/shapes.h"
#include <gtest/gtest.h>

namespace keiko {
namespace {

/// A square that is placed a number of times.
SurfaceModel squares(std::size_t number) {
    test::ShapeBuilder builder;
    builder.face({test::rectangle(0, 1, 0, 1, 0)});
    builder.place(std::vector<Affine>(number, Affine::scale(1)));
    return builder.model();
}

TEST(ReportDrawing, SaysWhyABodyOfManyPlacedFacesHasNone) {
    EXPECT_EQ(drawing_remark(squares(500)), "");
    EXPECT_EQ(drawing_remark(squares(501)),
              "No line drawing: of more than 500 faces it would hold up the report, and this body "
              "has 501; keiko draw makes one.");
}

TEST(ReportDrawing, CountsNoPatches) {
    const std::vector<test::PatchData> patches(2000, test::rectangle(0, 1, 0, 1, 0));
    EXPECT_EQ(drawing_remark(test::ShapeBuilder().face(patches).model()), "");
}

} // namespace
} // namespace keiko
