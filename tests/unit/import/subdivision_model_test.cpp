#include "keiko/import/subdivision/subdivision_model.h"

#include "keiko/base/error.h"
#include "keiko/geometry/seam/seam.h"

#include "tests/support/paths.h"
#include "tests/support/temporary_folder.h"
#include <gtest/gtest.h>

namespace keiko {
namespace {

struct SubdivisionModel : testing::Test {
    test::TemporaryFolder folder;

    SurfaceModel load(const std::string& text) {
        return read_subdivision_file(folder.file("cage.obj", text));
    }
};

const std::string house =
    "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0.5 2 0\n"
    "g wall\nusemtl brick\nf 1 2 3 4\no roof\nf 4 3 5\n";

TEST_F(SubdivisionModel, AQuadIsAFaceAndAnNgonIsNFaces) {
    const SurfaceModel model = load(house);
    ASSERT_EQ(model.faces.size(), 4u);
    EXPECT_EQ(model.faces[0].name, "wall-f1");
    EXPECT_EQ(model.faces[0].layer, "brick");
    EXPECT_EQ(model.faces[0].surface_kind, "catmull-clark");
    EXPECT_EQ(model.faces[3].name, "roof-f2.3");
    EXPECT_EQ(model.faces[3].id, 4u);
    EXPECT_EQ(model.format, "OBJ");
    EXPECT_EQ(model.unit, "");
    EXPECT_EQ(model.parts.size(), 1u);
    for (const Face& face : model.faces) EXPECT_EQ(face.loop_count, 0u);
}

TEST_F(SubdivisionModel, HolesLeaveNoFaceAndKeepTheOthersIds) {
    const SurfaceModel model = load(house + "t hole 1/0/0 0\n");
    ASSERT_EQ(model.faces.size(), 3u);
    EXPECT_EQ(model.faces[0].id, 2u);
    EXPECT_EQ(model.faces[0].name, "roof-f2.1");
}

TEST_F(SubdivisionModel, VerticesOfNoFaceCostNoPrecision) {
    const SurfaceModel alone = load(house), astray = load(house + "v 1e14 0 0\n");
    ASSERT_EQ(alone.control_points.size(), astray.control_points.size());
    for (std::size_t i = 0; i < alone.control_points.size(); ++i)
        EXPECT_EQ(alone.control_points[i], astray.control_points[i]);
}

TEST_F(SubdivisionModel, ACageWithoutSurfaceIsAnError) {
    try {
        load(house + "t interpolateboundary 1/0/0 0\n");
        FAIL();
    } catch (const Error& e) {
        EXPECT_EQ(e.reason(), "no face of the cage carries a surface");
        EXPECT_EQ(e.file(), (folder.path() / "cage.obj").string());
    }
}

/// A square grid of `size` quads a side whose inner edges have creases by Chaikin's rule.
std::string creased_grid(int size, double sharpness) {
    std::string text = "t creasemethod 0/0/1 chaikin\n";
    const int width = size + 1;
    for (int i = 0; i < width * width; ++i)
        text += "v " + std::to_string(i % width) + " " + std::to_string(i / width) + " 0\n";
    for (int i = 0; i < size * size; ++i) {
        const int first = i / size * width + i % size + 1;
        for (const int corner : {first, first + 1, first + width + 1, first + width})
            text += (corner == first ? "f " : " ") + std::to_string(corner);
        text += "\n";
    }
    for (int k = 1; k < size; ++k)
        for (const int step : {1, width}) {
            text += "t crease " + std::to_string(width) + "/1/0";
            for (int i = 0; i < width; ++i)
                text += " " + std::to_string(k * (width + 1 - step) + i * step);
            text += " " + std::to_string(sharpness) + "\n";
        }
    return text;
}

TEST_F(SubdivisionModel, CreasesThatWouldFillTheMemoryAreRefused) {
    try {
        load(creased_grid(24, 9.9));
        FAIL();
    } catch (const Error& e) {
        EXPECT_EQ(e.reason(),
                  "its semi-sharp creases need more than 4000000 points; make them fewer or less "
                  "sharp");
    }
    EXPECT_NO_THROW(load(creased_grid(24, 2)));
    EXPECT_NO_THROW(load(creased_grid(2, 9.9)));
}

TEST_F(SubdivisionModel, PatchesFillTheFaceParameters) {
    const SurfaceModel model = load(house + "t crease 2/1/0 2 3 2.5\n");
    for (const Face& face : model.faces) {
        double area = 0;
        for (const Patch& p : model.patches_of(face))
            area += (p.map_u.end - p.map_u.begin) * (p.map_v.end - p.map_v.begin);
        EXPECT_DOUBLE_EQ(area, 1) << model.describe(face);
    }
}

/// Every edge of the cage with two faces is one seam, and nothing is left over.
void expect_seams(const std::string& file, std::size_t seams) {
    const SurfaceModel model = read_subdivision_file(test::repository("surfaces") / file);
    const std::vector<Seam> found = pair_seams(model, 0.5);
    EXPECT_EQ(found.size(), seams) << file;
    for (const Seam& seam : found) {
        EXPECT_NEAR(std::abs(seam.a.end - seam.a.begin), 1, 1e-9);
        EXPECT_NEAR(std::abs(seam.b.end - seam.b.begin), 1, 1e-9);
    }
}

TEST_F(SubdivisionModel, EachEdgeOfTheCageIsASeam) {
    expect_seams("cage-cube.obj", 12);
    expect_seams("cage-icosahedron.obj", 30);
}

TEST_F(SubdivisionModel, PatchesAroundIrregularPointsAreMarkedByFace) {
    // The middle of the triangle is a point of three faces.
    const SurfaceModel model = load(house);
    ASSERT_GE(model.irregular_patches.size(), 3u);
    for (std::size_t i = 0; i < model.irregular_patches.size(); ++i) {
        const IrregularPatch& patch = model.irregular_patches[i];
        EXPECT_GT(model.faces.at(patch.face).patch_count, 0u);
        EXPECT_LT(patch.radius, 0.1);
        EXPECT_GE(patch.face, model.irregular_patches[i > 0 ? i - 1 : 0].face);
    }
}

TEST_F(SubdivisionModel, TheSameFileGivesTheSameModel) {
    const auto path = test::repository("surfaces/cage-panel.obj");
    const SurfaceModel a = read_subdivision_file(path), b = read_subdivision_file(path);
    EXPECT_EQ(a.control_points, b.control_points);
    EXPECT_EQ(a.faces.size(), b.faces.size());
}

} // namespace
} // namespace keiko
