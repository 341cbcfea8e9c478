#include "keiko/import/subdivision/cage.h"
#include "keiko/import/subdivision/subdivision_model.h"

#include "tests/support/paths.h"
#include "tests/support/temporary_folder.h"
#include "tests/unit/import/limit_oracle.h"
#include <gtest/gtest.h>

namespace keiko::subdivision {
namespace {

/// Tolerances of the acceptance: share of the cage's size, radians.
constexpr double position_tolerance = 1e-6, normal_tolerance = 1e-5;

void expect_close(const test::Deviation& deviation, const std::string& what) {
    EXPECT_GT(deviation.points, 0u) << what;
    EXPECT_EQ(deviation.missed, 0u) << what;
    EXPECT_LE(deviation.position, position_tolerance) << what << ": " << deviation.text();
    EXPECT_LE(deviation.normal, normal_tolerance) << what << ": " << deviation.text();
}

void expect_limit_surface(const std::filesystem::path& path) {
    const Cage cage = read_cage(path);
    const SurfaceModel model = read_subdivision_file(path);
    const std::string name = path.filename().string();
    if (cage.scheme == Scheme::loop) {
        expect_close(test::rays_from_limit_masks(cage, model, 3), name + ", limit masks by rays");
        expect_close(test::rays_from_bfr(cage, model, 12), name + ", Bfr by rays");
        return;
    }
    expect_close(test::from_limit_masks(cage, model, 4), name + ", limit masks");
    expect_close(test::from_bfr(cage, model, 12), name + ", Bfr");
    expect_close(test::rays_from_bfr(cage, model, 4), name + ", Bfr by rays");
}

const std::string cube =
    "v -1 -1 -1\nv 1 -1 -1\nv 1 1 -1\nv -1 1 -1\nv -1 -1 1\nv 1 -1 1\nv 1 1 1\nv -1 1 1\n"
    "f 4 3 2 1\nf 5 6 7 8\nf 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8\n";

/// A bent sheet of 3 x 3 quads, vertices row by row.
std::string sheet() {
    std::string text;
    for (int i = 0; i < 4; ++i)
        for (int j = 0; j < 4; ++j)
            text += "v " + std::to_string(j) + " " + std::to_string(i) + " " +
                    std::to_string(0.1 * i * i - 0.2 * i * j + 0.05 * j * j * j) + "\n";
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j) {
            const int v = 4 * i + j + 1;
            text += "f " + std::to_string(v) + " " + std::to_string(v + 1) + " " +
                    std::to_string(v + 5) + " " + std::to_string(v + 4) + "\n";
        }
    return text;
}

struct LimitSurface : testing::Test {
    test::TemporaryFolder folder;

    void expect(const std::string& name, const std::string& text) {
        expect_limit_surface(folder.file(name + ".obj", text));
    }
};

TEST_F(LimitSurface, TheFixtures) {
    for (const char* name : {"cage-cube.obj", "cage-panel.obj", "cage-icosahedron.obj"})
        expect_limit_surface(test::repository("surfaces") / name);
}

TEST_F(LimitSurface, CreasesOfEverySharpness) {
    for (const char* sharpness : {"0.3", "1", "2.7", "5.5", "10"})
        expect(std::string("crease-") + sharpness,
               cube + "t crease 5/1/0 4 5 6 7 4 " + sharpness + "\n");
    expect("dart", cube + "t crease 2/1/0 4 5 3\n");
    expect("corner", cube + "t corner 1/1/0 4 2.5\n");
    expect("all-sharp", cube +
                            "t crease 5/1/0 0 1 2 3 0 10\nt crease 5/1/0 4 5 6 7 4 10\n"
                            "t crease 2/1/0 0 4 10\nt crease 2/1/0 1 5 10\n"
                            "t crease 2/1/0 2 6 10\nt crease 2/1/0 3 7 10\n");
}

TEST_F(LimitSurface, ChaikinCreasesAndSmoothTriangles) {
    // Bfr sees one ring of edges only, too few for Chaikin's rule.
    const auto chaikin =
        folder.file("chaikin.obj", cube +
                                       "t creasemethod 0/0/1 chaikin\nt crease 2/1/0 4 5 3\n"
                                       "t crease 2/1/0 5 6 1.5\nt crease 2/1/0 6 7 2\n");
    expect_close(test::from_limit_masks(read_cage(chaikin), read_subdivision_file(chaikin), 5),
                 "chaikin");
    expect(
        "triangles",
        sheet() + "v 0.5 -1 0\nv -1 0.5 0.4\nf 2 1 17\nf 1 5 18\nt smoothtriangles 0/0/1 smooth\n");
}

TEST_F(LimitSurface, EveryBoundaryRule) {
    for (const char* rule : {"0", "1", "2"})
        expect(std::string("boundary-") + rule,
               sheet() + "t interpolateboundary 1/0/0 " + rule + "\n");
    expect("sharp-boundary", sheet() + "t corner 1/1/0 0 10\nt crease 4/1/0 4 5 6 7 2\n");
}

TEST_F(LimitSurface, HolesAndFansThatTouch) {
    expect("hole", sheet() + "t hole 1/0/0 4\n");
    expect("bow-tie", sheet() + "v 4 4 1\nv 4 3.5 2\nv 3.5 4 2\nf 16 18 17 19\n");
}

TEST_F(LimitSurface, LoopWithCreasesAndBorders) {
    const std::string open =
        "v 0 0 0\nv 2 0 0.2\nv 1 2 0\nv -1 2 0.5\nv -2 0 0\nv -1 -2 0.3\n"
        "v 1 -2 0\nf 1 2 3\nf 1 3 4\nf 1 4 5\nf 1 5 6\nf 1 6 7\n";
    expect("loop-fan", open);
    expect("loop-corner", open + "t interpolateboundary 1/0/0 1\nt crease 2/1/0 0 2 1.6\n");
    expect("loop-closed", open + "f 1 7 2\nt crease 3/1/0 1 0 4 10\n");
}

} // namespace
} // namespace keiko::subdivision
