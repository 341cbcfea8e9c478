#include "keiko/import/worker/load_model.h"
#include "keiko/visibility/query/visibility_query.h"

#include "tests/support/file_test_name.h"
#include "tests/support/leaf_bounds.h"
#include "tests/support/paths.h"
#include "tests/support/random.h"
#include <gtest/gtest.h>

namespace keiko {
namespace {

using namespace test;

/// A body that random viewpoints on it and beside it look out from, at rows of parallel segments.
class ScanLines : public testing::TestWithParam<const char*> {
protected:
    explicit ScanLines(const TracerOptions& options = {}) : tracer_(model_, options) {}

    static constexpr int segments = 12;

    std::vector<Segment> random_row() {
        const double size = leaf_bounds(tracer_).size();
        const Vec3 out = random_direction(random_), along = random_direction(random_) * size;
        const Vec3 across = out.cross(along).normalized() * size;
        const Vec3 begin = leaf_bounds(tracer_).center() + out * size * 0.9 - (along + across) / 2;
        std::vector<Segment> row;
        for (int i = 0; i < segments; ++i) {
            const Vec3 a = begin + across * ((i + 0.5) / segments);
            row.push_back({a, a + along});
        }
        return row;
    }
    VisibilityQuery view_of(const std::vector<Segment>& row, const Viewpoint& viewpoint,
                            const std::optional<Vec3>& facing) const {
        const Vec3 corners[4] = {row[0].a, row[0].b, row.back().a, row.back().b};
        return {occluders_, tracer_, viewpoint, corners, facing};
    }

    void expect_same_intervals(const Viewpoint& viewpoint, const std::optional<Vec3>& facing) {
        const std::vector<Segment> row = random_row();
        const VisibilityQuery view = view_of(row, viewpoint, facing);
        const std::vector<VisibleIntervals> together = view.intervals(row);
        for (std::size_t i = 0; i < row.size(); ++i) {
            const VisibleIntervals alone = view.intervals(row[i]);
            const double seen = alone.intervals.measure();
            partly_hidden_ += seen > 0 && seen < 1;
            EXPECT_EQ(together[i].intervals, alone.intervals) << "line " << i;
            EXPECT_EQ(together[i].certain, alone.certain);
        }
    }

    /// Between neighbours of the row, some way beyond it too.
    std::vector<Prism> prisms_of(const std::vector<Segment>& row) {
        const Vec3 beyond =
            (row[0].a - leaf_bounds(tracer_).center()) * uniform(random_, 0.001, 0.05);
        const auto moved = [&](const Segment& ends) {
            return Segment{ends.a + beyond, ends.b + beyond};
        };
        std::vector<Prism> prisms;
        for (std::size_t i = 0; i + 1 < row.size(); ++i)
            prisms.push_back({row[i], row[i + 1], moved(row[i]), moved(row[i + 1])});
        return prisms;
    }

    /// Expects lines all through each classified prism to be as the prism is classified, on the
    /// side that is faced.
    void expect_seen_as_told(const Viewpoint& viewpoint, const std::optional<Vec3>& facing) {
        const std::vector<Segment> row = random_row();
        const std::vector<Prism> prisms = prisms_of(row);
        std::vector<Vec3> corners;
        for (const Prism& prism : {prisms.front(), prisms.back()})
            for (const Segment& edge : prism) corners.insert(corners.end(), {edge.a, edge.b});
        const VisibilityQuery view(occluders_, tracer_, viewpoint, corners, facing);
        const std::vector<std::optional<bool>> told = view.classify_prisms(prisms);
        for (std::size_t i = 0; i < prisms.size(); ++i) {
            if (!told[i]) continue;
            ++(*told[i] ? seen_ : hidden_);
            for (int k = 0; k < 8; ++k) {
                const double s = uniform(random_, 0, 1), t = uniform(random_, 0, 1);
                const auto inside = [&](Vec3 Segment::*end) {
                    const Prism& p = prisms[i];
                    return (p[0].*end * (1 - s) + p[1].*end * s) * (1 - t) +
                           (p[2].*end * (1 - s) + p[3].*end * s) * t;
                };
                const Vec3 a = inside(&Segment::a), b = inside(&Segment::b);
                const double faced = faced_length(viewpoint, facing, a, b);
                const double seen = view.intervals({a, b}).intervals.measure();
                cut_ += faced > 0 && faced < 1;
                constexpr double shortest = 2e-9;
                if (!(faced > shortest)) continue;
                EXPECT_NEAR(seen, *told[i] ? faced : 0, shortest) << "prism " << i;
            }
        }
    }
    /// Share of a segment on the side that is faced.
    static double faced_length(const Viewpoint& viewpoint, const std::optional<Vec3>& facing,
                               const Vec3& a, const Vec3& b) {
        if (!facing) return 1;
        const double at_a = facing->dot(viewpoint.way_to(a)),
                     at_b = facing->dot(viewpoint.way_to(b));
        if (at_a >= 0 && at_b >= 0) return 1;
        return std::max({0.0, at_a, at_b}) / std::abs(at_a - at_b);
    }

    template <class Expect>
    void for_apexes_of_all_kinds(const Expect& expect) {
        for (int i = 0; i < 60; ++i) {
            expect(Viewpoint::towards(random_direction(random_)), std::optional<Vec3>());
            const Vec3 outside = leaf_bounds(tracer_).center() +
                                 random_direction(random_) * leaf_bounds(tracer_).size();
            expect(Viewpoint::at(outside), std::optional<Vec3>());
            Ray ray;
            ray.origin = outside;
            ray.direction = leaf_bounds(tracer_).center() - outside;
            const auto hit = tracer_.nearest(ray);
            if (!hit) continue;
            const Viewpoint on_surface = Viewpoint::at(hit->position, hit->root);
            expect(on_surface, std::optional<Vec3>());
            expect(on_surface, std::optional(hit->normal));
        }
    }

    Random random_{11};
    SurfaceModel model_ = load_model(repository("surfaces") / GetParam());
    Tracer tracer_;
    Occluders occluders_{model_, tracer_};
    int partly_hidden_ = 0;
    int seen_ = 0, hidden_ = 0; ///< prisms
    int cut_ = 0;               ///< lines in those that the horizon cuts
};

TEST_P(ScanLines, GiveTheIntervalsOfSingleSegments) {
    for_apexes_of_all_kinds([&](const Viewpoint& viewpoint, const auto& facing) {
        expect_same_intervals(viewpoint, facing);
    });
    EXPECT_GT(partly_hidden_, 50);
}

TEST_P(ScanLines, AreSeenOrHiddenInPrismsAsIsTold) {
    for_apexes_of_all_kinds([&](const Viewpoint& viewpoint, const auto& facing) {
        expect_seen_as_told(viewpoint, facing);
    });
    EXPECT_GT(seen_, 100);
    EXPECT_GT(hidden_, 100);
    // On leaves as small as they are by default nothing of the saddle is proved where the horizon
    // cuts it.
    if (GetParam() != std::string("saddle.bpt")) {
        EXPECT_GT(cut_, 20);
    }
}

class ScanLinesOnLargeLeaves : public ScanLines {
protected:
    ScanLinesOnLargeLeaves() : ScanLines({.sub_patch_contraction = 0.65}) {}
};

TEST_P(ScanLinesOnLargeLeaves, AreSeenOrHiddenInPrismsAsIsTold) {
    for_apexes_of_all_kinds([&](const Viewpoint& viewpoint, const auto& facing) {
        expect_seen_as_told(viewpoint, facing);
    });
    EXPECT_GT(seen_, 100);
    EXPECT_GT(hidden_, 100);
    EXPECT_GT(cut_, 20);
}

INSTANTIATE_TEST_SUITE_P(, ScanLinesOnLargeLeaves, testing::Values("saddle.bpt"),
                         test::file_test_name);
INSTANTIATE_TEST_SUITE_P(, ScanLines,
                         testing::Values("concept-car.step", "saddle.bpt", "rational-sphere.step",
                                         "trimmed-two-holes.step", "cage-cube.obj"),
                         test::file_test_name);

} // namespace
} // namespace keiko
