#include "keiko/visibility/epipolar/epipolar_shadows.h"
#include "keiko/visibility/query/visibility_query.h"

#include "tests/support/long_run.h"
#include "tests/support/round_scenes.h"
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <vector>

/// Scenes on a grid of round numbers: viewpoint, segment and edge in one plane, viewpoints in the
/// planes of faces, edges end to end. The result for what is exactly on a boundary may be either,
/// but only as that for a segment moved by next to nothing would be.
using namespace keiko;
using namespace keiko::test;

namespace {

/// A segment, and four so near to it that only what is exactly aligned can tell them apart.
std::vector<Segment> with_neighbours(const Segment& ends) {
    constexpr double little = 1e-5;
    std::vector<Segment> row;
    for (const Vec3& step : {Vec3(0), Vec3(little, 0, 0), Vec3(-little, 0, 0), Vec3(0, 0, little),
                             Vec3(0, 0, -little)})
        row.push_back({ends.a + step, ends.b + step});
    return row;
}

/// Corners of a box around a segment along y.
std::vector<Vec3> corners(const Segment& ends) {
    std::vector<Vec3> all;
    for (const Vec3& end : {ends.a, ends.b})
        for (const double x : {-2.0, 2.0})
            for (const double z : {-2.0, 2.0}) all.push_back(end + Vec3(x, 0, z));
    return all;
}

bool is_in(const IntervalSet& seen, double t) {
    for (const ParameterInterval& i : seen)
        if (t > i.begin && t < i.end) return true;
    return false;
}

/// Whether an end lies so near to t that moving the segment may carry it past.
bool ends_near(const IntervalSet& seen, double t) {
    constexpr double near = 2e-3;
    for (const ParameterInterval& i : seen)
        if (std::abs(i.begin - t) < near || std::abs(i.end - t) < near) return true;
    return false;
}

/// Number of places where the results for all segments beside one agree, and that for itself
/// differs.
int told_alone(const std::vector<IntervalSet>& seen) {
    int alone = 0;
    constexpr int places = 101;
    for (int p = 1; p < places; ++p) {
        const double t = double(p) / places;
        int lit = 0;
        bool near_end = false;
        for (std::size_t k = 1; k < seen.size(); ++k)
            lit += is_in(seen[k], t), near_end = near_end || ends_near(seen[k], t);
        if (near_end || (lit != 0 && lit != 4)) continue;
        if (is_in(seen[0], t) != (lit == 4)) ++alone;
    }
    return alone;
}

} // namespace

TEST(AlignedOccluders, AreSeenAsFromNextToNothingBeside) {
    Random random(first_seed() + 6);
    const std::size_t scenes = ray_count(200, 20000);
    int alone = 0, alone_in_rows = 0;
    std::size_t certain = 0, partly = 0;
    for (std::size_t scene = 0; scene < scenes; ++scene) {
        const SurfaceModel model = round_scene(random);
        const Tracer tracer(model);
        const Occluders occluders(model, tracer);
        for (int trial = 0; trial < 50; ++trial) {
            const Vec3 viewpoint = round_place(random, -3, 12);
            // Above all bodies, which reach up to 120.
            const Vec3 a(round_number(random, -3, 12), -40, round_number(random, 13, 16));
            if (viewpoint.x == a.x && viewpoint.z == a.z) continue; // in the midst of the segment
            const std::vector<Segment> row = with_neighbours({a, a + Vec3(0, 170, 0)});
            const VisibilityQuery view(occluders, tracer, Viewpoint::at(viewpoint),
                                       corners(row[0]));
            const VisibleIntervals single = view.intervals(row[0]);
            if (!single.certain) continue; // the viewpoint on a surface
            std::vector<IntervalSet> seen{single.intervals}, in_row;
            for (std::size_t k = 1; k < row.size(); ++k)
                seen.push_back(view.intervals(row[k]).intervals);
            for (const VisibleIntervals& parts : view.intervals(row))
                in_row.push_back(parts.intervals);
            ++certain;
            partly += !seen[0].empty() && seen[0].measure() < 1;
            alone += told_alone(seen);
            alone_in_rows += told_alone(in_row);
        }
    }
    EXPECT_EQ(alone, 0);
    EXPECT_EQ(alone_in_rows, 0);
    EXPECT_GT(certain, 45 * scenes);
    EXPECT_GT(partly, 10 * scenes);
}

TEST(AlignedOccluders, ArePastRaysOfAPencilAsFromNextToNothingBeside) {
    Random random(first_seed() + 11);
    const std::size_t scenes = ray_count(100, 10000);
    int alone = 0;
    std::size_t partly = 0;
    for (std::size_t scene = 0; scene < scenes; ++scene) {
        const SurfaceModel model = round_scene(random);
        const Tracer tracer(model);
        const Occluders occluders(model, tracer);
        const Vec3 light = round_place(random, -3, 12), eye = round_place(random, -3, 12);
        if (light == eye) continue;
        const EpipolarShadows pencil(occluders, tracer, light, eye);
        for (int trial = 0; trial < 50; ++trial) {
            const Vec3 target = round_place(random, -3, 12);
            if (target == eye || (target - eye).cross(light - eye).length() == 0) continue;
            std::vector<Segment> rays = with_neighbours({eye, target});
            for (Segment& ray : rays) ray.a = eye;
            double end = 1;
            for (const Segment& ray : rays)
                if (const auto hit = tracer.nearest({.origin = eye, .direction = ray.b - eye}))
                    end = std::min(end, hit->t - 1e-6);
            if (!(end > 1e-3)) continue; // the eye on a surface
            for (Segment& ray : rays) ray.b = eye + (ray.b - eye) * end;
            const std::vector<IntervalSet> seen = pencil.intervals(rays);
            partly += !seen[0].empty() && seen[0].measure() < 1;
            alone += told_alone(seen);
        }
    }
    EXPECT_EQ(alone, 0);
    EXPECT_GT(partly, 5 * scenes);
}
