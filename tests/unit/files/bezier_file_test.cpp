#include "keiko/files/model/bezier_file.h"

#include "keiko/base/error.h"

#include "tests/support/paths.h"
#include "tests/support/temporary_folder.h"
#include <gtest/gtest.h>

namespace keiko {
namespace {

std::string reason_for(const std::string& text) {
    const test::TemporaryFolder folder;
    try {
        read_bezier_file(folder.file("x.bpt", text));
    } catch (const Error& e) {
        return "line " + e.where() + ": " + e.reason();
    }
    return "";
}

constexpr const char* bilinear = "1\n1 1\n0 0 0\n0 1 0\n1 0 0\n1 1 2\n";

TEST(BezierFile, ReadsAPatchWithUOuter) {
    const test::TemporaryFolder folder;
    const SurfaceModel model = read_bezier_file(folder.file("x.bpt", bilinear));
    ASSERT_EQ(model.faces.size(), 1u);
    EXPECT_EQ(evaluate(model.patch(0), {1, 0}, 0).position(), Vec3(1, 0, 0));
    EXPECT_EQ(evaluate(model.patch(0), {0, 1}, 0).position(), Vec3(0, 1, 0));
    EXPECT_EQ(model.format, "BPT");
    EXPECT_EQ(model.loops_of(model.faces[0]).size(), 1u);
}

TEST(BezierFile, FourNumbersMakeARationalPatch) {
    const test::TemporaryFolder folder;
    const SurfaceModel model = read_bezier_file(
        folder.file("x.bpt",
                    "# quarter cylinder\n1\n2 1\n1 0 0 1\n1 0 3 1\n"
                    "1 1 0 0.70710678118654752\n1 1 3 0.70710678118654752\n0 1 0 1\n0 1 3 1\n"));
    const Vec3 p = evaluate(model.patch(0), {0.3, 0.5}, 0).position();
    EXPECT_NEAR(std::hypot(p.x, p.y), 1, 1e-15);
    EXPECT_NEAR(p.z, 1.5, 1e-15);
}

TEST(BezierFile, SeveralPatchesOfAnyDegreeWithCommentsAndDosLines) {
    const test::TemporaryFolder folder;
    const SurfaceModel model = read_bezier_file(
        folder.file("x.bpt",
                    "2 # two\r\n\r\n1 1\r\n0 0 0\r\n0 1 0\r\n1 0 0\r\n1 1 2\r\n"
                    "1 2\r\n0,0,0\r\n0,1,0\r\n0,2,0\r\n1,0,0\r\n1,1,1\r\n1,2,0\r\n"));
    EXPECT_EQ(model.faces.size(), 2u);
    EXPECT_EQ(model.patches[1].degree_v, 2);
}

TEST(BezierFile, APatchWithoutAreaIsALostFaceAndAFileOfThemIsRefused) {
    const std::string on_a_line = "1 1\n1e5 0 0\n100000.1 0.1 0\n100000.2 0.2 0\n100000.3 0.3 0\n";
    const std::string in_one_place = "1 1\n7 0 0\n7 0 0\n7 0 0\n7 0 0\n";
    const std::string narrow = "1 1\n0 0 0\n1 0 0\n2 0 0\n3 1e-6 0\n";
    EXPECT_EQ(reason_for("1\n" + on_a_line),
              "line : the points of each patch lie on one line or in one place: it is no surface");
    const test::TemporaryFolder folder;
    const SurfaceModel model =
        read_bezier_file(folder.file("x.bpt", "4\n" + narrow + on_a_line + narrow + in_one_place));
    ASSERT_EQ(model.faces.size(), 2u);
    EXPECT_EQ(model.faces[0].id, 1u);
    EXPECT_EQ(model.faces[1].id, 3u);
    ASSERT_EQ(model.lost_faces.size(), 2u);
    EXPECT_EQ(model.lost_faces[0].id, 2u);
    EXPECT_EQ(model.lost_faces[1].id, 4u);
    EXPECT_EQ(model.lost_faces[0].reason,
              "its points lie on one line or in one place: it has no area");
}

TEST(BezierFile, NumbersWhoseProductsWouldOverflowAreRefused) {
    const std::string coordinate = "a coordinate must be from -1e15 to 1e15";
    EXPECT_EQ(reason_for("1\n1 1\n0 0 0\n0 1e300 0\n"), "line 4: " + coordinate);
    EXPECT_EQ(reason_for("1\n1 1\n0 0 0 10\n0 -1e308 0 10\n"), "line 4: " + coordinate);
    const std::string weight = "a weight must be from 1e-15 to 1e15";
    EXPECT_EQ(reason_for("1\n1 1\n0 0 0 1e-320\n"), "line 3: " + weight);
    EXPECT_EQ(reason_for("1\n1 1\n0 0 0 1e300\n"), "line 3: " + weight);
    EXPECT_EQ(reason_for("1\n1 1\n0 0 0 1e-3\n0 1e6 0 1e3\n1 0 0 1\n1 1 0 1\n"), "");
}

TEST(BezierFile, ErrorsNameTheLine) {
    EXPECT_EQ(reason_for("1\n1 1\n0 0 0\n0 1 0\n1 0 0\n"),
              "line 6: the file ends where a control point should follow");
    EXPECT_EQ(reason_for("1\n1 1\n0 0 0\n0 nan 0\n"), "line 4: not a finite number: \"nan\"");
    EXPECT_EQ(reason_for("1\n1 1\n0 0 0\n0 1e999 0\n"), "line 4: not a finite number: \"1e999\"");
    EXPECT_EQ(reason_for("1\n26 1\n"), "line 2: out of range: two degrees from 1 to 25");
    EXPECT_EQ(reason_for("1\n0 1\n"), "line 2: out of range: two degrees from 1 to 25");
    EXPECT_EQ(reason_for("1\n1.5 1\n"), "line 2: out of range: two degrees from 1 to 25");
    EXPECT_EQ(reason_for("99999999999\n1 1\n"), "line 1: out of range: the number of patches");
    EXPECT_EQ(reason_for("1\n1 1\n0 0 0 1\n0 1 0\n"),
              "line 4: expected a control point \"x y z\" or \"x y z w\", alike in a patch");
    EXPECT_EQ(reason_for("1\n1 1\n0 0 0 0\n"), "line 3: a weight must be above 0");
    EXPECT_EQ(reason_for(std::string(bilinear) + "5 5 5\n"),
              "line 7: more lines than the counts say");
}

TEST(TeapotFile, AVertexThatIsMissingIsAnError) {
    const test::TemporaryFolder folder;
    try {
        read_teapot_file(
            folder.file("x.txt", "1\n1,2,3,4,5,6,7,8,9,10,11,12,13,14,15,3\n1\n0,0,0\n"));
        FAIL();
    } catch (const Error& e) {
        EXPECT_EQ(e.reason(), "there is no vertex 2");
    }
}

TEST(TeapotFile, BothFormsOfTheNewellTeapotAreTheSamePatches) {
    KEIKO_NEEDS_SHARED_MODEL("newell-teapot.bpt");
    const SurfaceModel bpt = read_bezier_file(test::shared_model("newell-teapot.bpt"));
    const SurfaceModel text = read_teapot_file(test::shared_model("newell-teapot.txt"));
    EXPECT_EQ(bpt.faces.size(), 32u);
    EXPECT_EQ(bpt.control_points, text.control_points);
}

} // namespace
} // namespace keiko
