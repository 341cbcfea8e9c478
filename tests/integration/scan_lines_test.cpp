#include "keiko/io/load_model.h"
#include "keiko/trace/occluders.h"

#include "tests/support/file_test_name.h"
#include "tests/support/paths.h"
#include "tests/support/random.h"
#include <gtest/gtest.h>

namespace keiko {
namespace {

using namespace test;

/// A body that random apexes on it and beside it look out from, at rows of parallel segments.
class ScanLines : public testing::TestWithParam<const char*> {
protected:
    static constexpr int segments = 12;

    void expect_same_intervals(const Apex& apex, const std::optional<Vec3>& facing) {
        const double size = tracer_.bounds().size();
        const Vec3 out = random_direction(random_), along = random_direction(random_) * size;
        const Vec3 across = out.cross(along).normalized() * size;
        const Vec3 begin = tracer_.bounds().center() + out * size * 0.9 - (along + across) / 2;
        std::vector<SegmentEnds> row;
        for (int i = 0; i < segments; ++i) {
            const Vec3 a = begin + across * ((i + 0.5) / segments);
            row.push_back({a, a + along});
        }
        const Vec3 corners[4] = {row[0][0], row[0][1], row.back()[0], row.back()[1]};
        const ApexView view(occluders_, tracer_, apex, corners, facing);
        const std::vector<SeenParts> together = view.intervals(row);
        for (std::size_t i = 0; i < row.size(); ++i) {
            const SeenParts alone = view.intervals(row[i][0], row[i][1]);
            const double seen = alone.intervals.measure();
            partly_hidden_ += seen > 0 && seen < 1;
            EXPECT_EQ(together[i].intervals, alone.intervals) << "line " << i;
            EXPECT_EQ(together[i].certain, alone.certain);
        }
    }

    Random random_{11};
    SurfaceModel model_ = load_model(repository("surfaces") / GetParam());
    Tracer tracer_{model_};
    Occluders occluders_{model_, tracer_};
    int partly_hidden_ = 0;
};

TEST_P(ScanLines, GiveTheIntervalsOfSingleSegments) {
    for (int i = 0; i < 60; ++i) {
        expect_same_intervals(Apex::towards(random_direction(random_)), {});
        const Vec3 outside =
            tracer_.bounds().center() + random_direction(random_) * tracer_.bounds().size();
        expect_same_intervals(Apex::at(outside), {});
        Ray ray;
        ray.origin = outside;
        ray.direction = tracer_.bounds().center() - outside;
        const auto hit = tracer_.nearest(ray);
        if (!hit) continue;
        const Apex on_surface = Apex::at(hit->position, hit->root);
        expect_same_intervals(on_surface, {});
        expect_same_intervals(on_surface, hit->normal);
    }
    EXPECT_GT(partly_hidden_, 50);
}

INSTANTIATE_TEST_SUITE_P(, ScanLines,
                         testing::Values("concept-car.step", "saddle.bpt", "rational-sphere.step",
                                         "trimmed-two-holes.step", "cage-cube.obj"),
                         test::file_test_name);

} // namespace
} // namespace keiko
