#include "keiko/visibility/epipolar/epipolar_shadows.h"

#include "keiko/import/worker/load_model.h"
#include "keiko/visibility/query/visibility_query.h"

#include "tests/support/paths.h"
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>

namespace keiko {
namespace {

/// A model and a picture of it, before a light.
struct View {
    SurfaceModel model;
    Tracer tracer{model};
    Occluders occluders{model, tracer};
    Vec3 eye{0};
    std::vector<Segment> rays{};

    explicit View(const char* file, int side = 24) : model(load_model(test::repository(file))) {
        const Box3& box = tracer.bounds();
        eye = box.center() + Vec3(-1.1, -1.6, 0.7) * box.size();
        const Vec3 ahead = (box.center() - eye).normalized();
        const Vec3 right = ahead.cross(Vec3(0, 0, 1)).normalized(), up = right.cross(ahead);
        for (int i = 0; i < side; ++i)
            for (int j = 0; j < side; ++j) {
                const double x = (i + 0.41) / side - 0.5, y = (j + 0.63) / side - 0.5;
                Ray ray;
                ray.origin = eye;
                ray.direction = (ahead + right * (0.7 * x) + up * (0.7 * y)).normalized();
                const auto hit = tracer.nearest(ray);
                rays.push_back({eye, eye + ray.direction * (hit ? hit->t : 5 * box.size())});
            }
    }

    /// Lights around the body and close to its middle, some of them in the picture.
    std::vector<Vec3> lights() const {
        const Box3& box = tracer.bounds();
        std::vector<Vec3> at{box.center() + (eye - box.center()) * 0.4,
                             box.center() + (box.center() - eye) * 0.6};
        for (int i = 0; i < 6; ++i) {
            const double angle = 2 * std::numbers::pi * (i + 0.2) / 6;
            at.push_back(box.center() + Vec3(std::cos(angle), std::sin(angle), 0.3 * (i - 2)) *
                                            (box.size() * (0.45 + 0.1 * i)));
        }
        return at;
    }
};

/// Length of what is in one set only.
double difference(const IntervalSet& a, const IntervalSet& b) {
    return a.intersect(b.complement()).measure() + b.intersect(a.complement()).measure();
}

class ShadowPencils : public testing::TestWithParam<const char*> {};

/// Everything that VisibilityQuery finds ray by ray at full precision.
TEST_P(ShadowPencils, SeeWhatApexViewsSee) {
    const View view(GetParam());
    int cut = 0;
    for (const Vec3& light : view.lights()) {
        const EpipolarShadows pencil(view.occluders, view.tracer, light, view.eye);
        const std::vector<IntervalSet> seen = pencil.intervals(view.rays);
        for (std::size_t i = 0; i < view.rays.size(); ++i) {
            const Segment& ray = view.rays[i];
            const VisibilityQuery apart(view.occluders, view.tracer, Viewpoint::at(light),
                                        std::array{ray.a, ray.b});
            const VisibleIntervals exact = apart.intervals(ray);
            if (!exact.certain) continue;
            cut += exact.intervals.size() > 1;
            EXPECT_LT(difference(seen[i], exact.intervals), 1e-6) << i << " light " << light.x;
        }
    }
    EXPECT_GT(cut, 100);
}

/// Neither what else is asked with it nor the order changes an answer.
TEST_P(ShadowPencils, AnswerEachRayForItself) {
    const View view(GetParam());
    const EpipolarShadows pencil(view.occluders, view.tracer, view.lights()[3], view.eye);
    const std::vector<IntervalSet> seen = pencil.intervals(view.rays);
    for (std::size_t i = 0; i < view.rays.size(); i += 7)
        EXPECT_EQ(pencil.intervals(std::span(&view.rays[i], 1)).front(), seen[i]) << i;
}

INSTANTIATE_TEST_SUITE_P(Models, ShadowPencils,
                         testing::Values("surfaces/saddle.bpt", "surfaces/mast.bpt",
                                         "surfaces/rational-sphere.step",
                                         "surfaces/trimmed-two-holes.step",
                                         "surfaces/bored-block.step", "surfaces/concept-car.step"));

} // namespace
} // namespace keiko
