// Verdicts do not depend on the order of the faces in the file.
#include "keiko/inspect/seams/seam_measure.h"

#include "tests/support/model_builder.h"
#include "tests/support/random.h"
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <vector>

namespace keiko {
namespace {

/// Corner and two sides of a rectangle.
using Rectangle = std::array<Vec3, 3>;

/// Two rows of strips that face each other across a gap, staggered by a share of their width, the
/// strips of both in turn.
std::vector<Rectangle> rows(int count, double width, double gap, double shift) {
    std::vector<Rectangle> strips;
    for (int i = 0; i < count; ++i) {
        strips.push_back({Vec3(-100, i * width, 0), Vec3(100, 0, 0), Vec3(0, width, 0)});
        strips.push_back({Vec3(gap, (i + shift) * width, 0), Vec3(100, 0, 0), Vec3(0, width, 0)});
    }
    return strips;
}

/// mm of all seams that fail.
double failing_length(const std::vector<Rectangle>& faces) {
    test::ModelBuilder builder;
    for (const auto& [corner, u, v] : faces) builder.plane(corner, u, v);
    const SurfaceModel model = builder.build();
    constexpr double join = 0.5; // mm
    double length = 0;
    for (const MeasuredSeam& seam : measure_seams(model, pair_seams(model, join), {}, join).seams)
        if (seam.verdict == Verdict::fail) length += seam.length;
    return length;
}

TEST(SeamOrder, OfFacesChangesNothingAtAGapOfManyPieces) {
    test::Random random(1);
    struct Rows {
        int count;
        double width, gap, shift;
    };
    for (const Rows& of : {Rows{24, 1, 0.2, 0.5}, Rows{13, 1.5, 0.3, 0.5}, Rows{12, 2, 0.3, 0.5},
                           Rows{8, 3, 0.45, 0.5}, Rows{20, 3.5, 0.45, 0.5},
                           Rows{16, 0.7, 0.12, 0.3}, Rows{30, 0.09, 0.2, 0.5}}) {
        std::vector<Rectangle> faces = rows(of.count, of.width, of.gap, of.shift);
        const double all = (of.count - of.shift) * of.width; // along which the rows face each other
        EXPECT_NEAR(failing_length(faces), all, 1e-6) << of.width;
        for (int i = 0; i < 5; ++i) {
            std::shuffle(faces.begin(), faces.end(), random);
            EXPECT_NEAR(failing_length(faces), all, 1e-6) << of.width << ' ' << i;
        }
    }
}

} // namespace
} // namespace keiko
