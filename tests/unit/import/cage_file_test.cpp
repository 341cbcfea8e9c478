#include "keiko/base/error.h"
#include "keiko/import/subdivision/cage.h"

#include "tests/support/temporary_folder.h"
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace keiko::subdivision {
namespace {

const std::string square = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4\n";

struct CageFile : testing::Test {
    test::TemporaryFolder folder;

    Cage read(const std::string& text) { return read_cage(folder.file("cage.obj", text)); }

    /// "LINE: REASON" of the error that reading gives.
    std::string reason(const std::string& text) {
        try {
            read(text);
        } catch (const Error& e) {
            EXPECT_EQ(e.file(), (folder.path() / "cage.obj").string());
            EXPECT_EQ(std::string(e.what()).find('\n'), std::string::npos);
            return e.where() + ": " + e.reason();
        }
        return "read";
    }
};

TEST_F(CageFile, AllWaysToNameACorner) {
    const Cage cage = read(
        "v 0 0 0\r\nv 1 0 0 # right\n v\t1 1 \\\n 0\nv 0 1 0 0.5 0.5 0.5\n"
        "vt 0 0\nvn 0 0 1\ns off\nf 1 2/1 3//1 -1/1/1\n");
    ASSERT_EQ(cage.faces.size(), 1u);
    EXPECT_EQ(cage.corners, (std::vector<std::uint32_t>{0, 1, 2, 3}));
    EXPECT_EQ(cage.vertices[2], Vec3(1, 1, 0));
    EXPECT_EQ(cage.faces[0].line, 9u);
}

TEST_F(CageFile, GroupsAndMaterialsNameTheirFaces) {
    const Cage cage = read(
        "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 2 0 0\nv 2 1 0\n"
        "g hood left\nusemtl paint\nf 1 2 3 4\no glass\nf 2 5 6 3\n");
    EXPECT_EQ(cage.names[cage.faces[0].group], "hood left");
    EXPECT_EQ(cage.names[cage.faces[1].group], "glass");
    EXPECT_EQ(cage.names[cage.faces[1].material], "paint");
}

TEST_F(CageFile, VerticesOfNoFaceAreNotPartOfItsSize) {
    EXPECT_DOUBLE_EQ(read(square + "v 1e9 1e9 1e9\n").size(), std::sqrt(2));
}

TEST_F(CageFile, Tags) {
    const Cage cage =
        read(square +
             "t crease 3/1/0 0 1 2 2.5\nt crease 2/1/0 2 3 99\nt corner 2/2/0 0 1 1 10\n"
             "t interpolateboundary 1/0/0 1\nt creasemethod 0/0/1 chaikin\n"
             "t smoothtriangles 0/0/1 smooth\nt facevaryinginterpolateboundary 1/0/0 1\n");
    ASSERT_EQ(cage.creases.size(), 3u);
    EXPECT_EQ(cage.creases[1].sharpness, 2.5);
    EXPECT_EQ(cage.creases[2].sharpness, infinite_sharpness);
    EXPECT_EQ(cage.sharp_corners.size(), 2u);
    EXPECT_EQ(cage.boundary, BoundaryRule::edge_and_corner);
    EXPECT_EQ(cage.crease_method, CreaseMethod::chaikin);
    EXPECT_EQ(cage.triangles, TriangleRule::smooth);
    EXPECT_TRUE(read(square + "t hole 1/0/0 0\n").faces[0].hole);
    EXPECT_EQ(read(square).boundary, BoundaryRule::edge_only);
}

TEST_F(CageFile, TrianglesAloneMakeALoopCageUnlessTheFileSaysOtherwise) {
    const std::string triangle = "v 0 0 0\nv 1 0 0\nv 1 1 0\nf 1 2 3\n";
    EXPECT_EQ(read(triangle).scheme, Scheme::loop);
    EXPECT_EQ(read(triangle).diagnostics.size(), 1u);
    EXPECT_EQ(read(triangle + "t scheme 0/0/1 loop\n").diagnostics.size(), 0u);
    EXPECT_EQ(read(triangle + "t scheme 0/0/1 catmark\n").scheme, Scheme::catmull_clark);
    EXPECT_EQ(read(square).scheme, Scheme::catmull_clark);
    EXPECT_EQ(reason(square + "t scheme 0/0/1 loop\n"), "5: a Loop cage may have triangles only");
}

TEST_F(CageFile, WrongStatementsAreToldWithTheirLine) {
    EXPECT_EQ(reason("v 0 0\n"), "1: a vertex needs x, y and z");
    EXPECT_EQ(reason("v 0 0 zero\n"), "1: not a finite number: \"zero\"");
    EXPECT_EQ(reason("v 0 0 nan\n"), "1: not a finite number: \"nan\"");
    EXPECT_EQ(reason("v 0 0 1e300\n"), "1: a coordinate must be from -1e15 to 1e15");
    EXPECT_EQ(reason(square + "f 1 2\n"), "6: a face needs at least three corners");
    EXPECT_EQ(reason(square + "f 1 2 5\n"), "6: there is no vertex 5 before this line");
    EXPECT_EQ(reason(square + "f 1 2 0\n"), "6: there is no vertex 0 before this line");
    EXPECT_EQ(reason(square + "f 1 2 -5\n"), "6: there is no vertex -5 before this line");
    EXPECT_EQ(reason(square + "f 1 2 1\n"), "6: the face names vertex 1 twice");
    EXPECT_EQ(reason(square + "f 1 2 3/x\n"), "6: not a corner v/vt/vn: \"3/x\"");
    EXPECT_EQ(reason(square + "f 1 2 99999999999999999999\n"),
              "6: not a whole number: \"99999999999999999999\"");
    EXPECT_EQ(reason(square + "cstype bezier\n"),
              "6: free-form geometry is not supported: only the faces of a cage");
    EXPECT_EQ(reason(square + "vertex 1\n"), "6: not an OBJ statement: \"vertex\"");
    EXPECT_EQ(reason("v 0 0 0\n"), ": no faces in the file (an OBJ file needs v and f)");
}

TEST_F(CageFile, AFileThatIsCutIsToldWhereItShows) {
    const std::string more = square + "v 2 0 0\nv 2 1 0\nf 2 5 6 3\n";
    const std::string remark = "its last line has no end: the file may be cut short";
    int read_without_remark = 0;
    for (std::size_t size = square.size() - 1; size <= more.size(); ++size) {
        const std::string cut = more.substr(0, size);
        std::vector<std::string> remarks;
        try {
            for (const Diagnostic& d : read(cut).diagnostics) remarks.push_back(d.message);
        } catch (const Error&) {
            continue;
        }
        const bool told = std::find(remarks.begin(), remarks.end(), remark) != remarks.end();
        EXPECT_EQ(told, !cut.ends_with('\n')) << cut;
        read_without_remark += told ? 0 : 1;
    }
    EXPECT_EQ(read_without_remark, 4) << "the ends of lines";
    EXPECT_EQ(reason("v 0 0 0\nv 1 0 0\nv 1 1 0\nf 1 2 3\nf 2 3 4\n"),
              "5: there is no vertex 4 before this line");
    EXPECT_EQ(reason(square + "f 1 2"), "6: a face needs at least three corners");
    EXPECT_EQ(reason(square + "v 1 2"), "6: a vertex needs x, y and z");
}

TEST_F(CageFile, TheByteOrderMarkOfUtf8IsNoStatement) {
    EXPECT_EQ(read("\xef\xbb\xbf" + square).faces.size(), 1u);
}

TEST_F(CageFile, FacesWithoutAreaAreRemarkedUponAndNeverAlone) {
    const std::string line = "v 0 0 0\nv 1 0 0\nv 2 0 0\nv 4 0 0\nf 1 2 3 4\n";
    EXPECT_EQ(reason(line), ": no face of the cage has an area: it is no surface");
    EXPECT_EQ(reason("v 5 5 5\nv 5 5 5\nv 5 5 5\nf 1 2 3\n"),
              ": no face of the cage has an area: it is no surface");
    const Cage cage = read(line + "v 0 1 0\nv 1 1 0\nf 2 1 5 6\n");
    ASSERT_EQ(cage.diagnostics.size(), 1u);
    EXPECT_EQ(cage.diagnostics[0].message, "1 face of the cage without area (lines 5)");
}

TEST_F(CageFile, WrongTagsAreToldWithTheirLine) {
    EXPECT_EQ(reason(square + "t crease\n"), "6: a tag needs a name and INTEGERS/FLOATS/STRINGS");
    EXPECT_EQ(reason(square + "t crease 2/1 0 1 2\n"),
              "6: a tag needs its counts as INTEGERS/FLOATS/STRINGS");
    EXPECT_EQ(reason(square + "t crease 2/1/0 0 1\n"), "6: the tag has other values than it says");
    EXPECT_EQ(reason(square + "t crease 99999999/1/0 0 1 1\n"),
              "6: the tag has fewer values than it says");
    EXPECT_EQ(reason(square + "t crease 2/1/0 0 4 1\n"),
              "6: there is no vertex 4 (tags count from 0)");
    EXPECT_EQ(reason(square + "t crease 2/1/0 0 1 -1\n"), "6: a sharpness must not be below 0");
    EXPECT_EQ(reason(square + "t corner 1/0/0 0\n"), "6: the tag needs one sharpness or 1");
    EXPECT_EQ(reason(square + "t hole 1/0/0 1\n"), "6: there is no face 1 (tags count from 0)");
    EXPECT_EQ(reason(square + "t interpolateboundary 1/0/0 3\n"),
              "6: interpolateboundary is 0, 1 or 2");
    EXPECT_EQ(reason(square + "t creasemethod 0/0/1 loop\n"),
              "6: creasemethod is normal or chaikin");
    EXPECT_EQ(reason(square + "t crese 2/1/0 0 1 2\n"), "6: unknown tag \"crese\"");
}

TEST_F(CageFile, ACreaseThatIsNoEdgeIsRemarkedUpon) {
    const Cage cage = read(square + "t crease 2/1/0 0 2 3\n");
    EXPECT_TRUE(cage.creases.empty());
    ASSERT_EQ(cage.diagnostics.size(), 1u);
    EXPECT_EQ(cage.diagnostics[0].entity, "line 6");
}

TEST_F(CageFile, NonManifoldEdgesAreRefused) {
    EXPECT_EQ(reason(square + "v 0 0 1\nv 1 0 1\nf 2 1 5 6\nf 1 2 6 5\n"),
              "9: the edge between vertices 1 and 2 has 3 faces (lines 5, 8, 9): a surface has two "
              "there at most");
    EXPECT_EQ(
        reason(square + "f 1 2 3 4\n"),
        "6: the faces of lines 5, 6 run the same way along the edge between vertices 1 and 2: "
        "one of them is turned over");
}

TEST_F(CageFile, FansThatTouchInOneVertexGetSharpCorners) {
    const Cage cage = read(square + "v 2 1 0\nv 2 2 0\nv 1 2 0\nf 3 5 6 7\nt crease 2/1/0 2 4 1\n");
    EXPECT_EQ(cage.vertices.size(), 8u);
    EXPECT_EQ(cage.vertices[7], cage.vertices[2]);
    EXPECT_EQ(cage.corners[4], 7u);
    ASSERT_EQ(cage.sharp_corners.size(), 2u);
    ASSERT_EQ(cage.creases.size(), 1u);
    EXPECT_EQ(cage.creases[0].a, 7u);
}

} // namespace
} // namespace keiko::subdivision
