#include "keiko/import/worker/load_model.h"
#include "keiko/intersect/traversal/tracer.h"

#include "tests/integration/opencascade_tracer.h"
#include "tests/support/file_test_name.h"
#include "tests/support/paths.h"
#include <gtest/gtest.h>

#include <random>

using namespace keiko;
using test::OpenCascadeTracer;
using test::PeerHit;

namespace {

constexpr int ray_count = 20000; // a model

/// Random chords through the model's box, starting well outside.
std::vector<Ray> random_rays(const Box3& box, int count) {
    std::mt19937_64 random(20260101);
    std::uniform_real_distribution<double> unit(0, 1);
    const auto inside = [&] {
        return box.lower + box.extent() * Vec3(unit(random), unit(random), unit(random));
    };
    std::vector<Ray> rays;
    while (rays.size() < static_cast<std::size_t>(count)) {
        const Vec3 a = inside(), b = inside();
        if ((b - a).length() < 1e-3 * box.size()) continue;
        Ray ray;
        ray.direction = (b - a).normalized();
        ray.origin = a - ray.direction * (2 * box.size());
        rays.push_back(ray);
    }
    return rays;
}

template <class Hits>
bool has_hit_at(const Hits& hits, double t, double tolerance) {
    return std::any_of(hits.begin(), hits.end(),
                       [&](const auto& hit) { return std::abs(hit.t - t) <= tolerance; });
}

/// Agreement of two implementations on the same rays.
struct Agreement {
    int common = 0;
    int lost_by_peer = 0; ///< Keiko's hit lies on OpenCASCADE's own face
    int at_border = 0;    ///< either's hit within the tolerance of a trimmed border
    int peer_inexact = 0; ///< OpenCASCADE's hit is off its ray or its face
    int lost = 0, false_hits = 0;
};

class Comparison {
public:
    Comparison(const std::filesystem::path& file, const SurfaceModel& model)
        : peer_(file), tracer_(model), size_(hull_bounds(model).size()) {}

    void compare(const Ray& ray) {
        const std::vector<Hit> ours = tracer_.all(ray);
        const std::vector<PeerHit> theirs = peer_.all(ray);
        for (const Hit& hit : ours) judge(ray, hit, theirs);
        for (const PeerHit& hit : theirs)
            if (!has_hit_at(ours, hit.t, tolerance())) judge_missing(ray, hit, ours);
    }

    const Agreement& agreement() const { return agreement_; }

private:
    double tolerance() const { return 1e-7 * size_; }

    void judge(const Ray& ray, const Hit& hit, const std::vector<PeerHit>& theirs) {
        const double off_ray = (ray.at(hit.t) - hit.position).length();
        if (has_hit_at(theirs, hit.t, tolerance())) {
            ++agreement_.common;
        } else if (off_ray > std::max(tolerance(), hit.position_bound)) {
            report(ray, hit.t, "hit off its ray");
            ++agreement_.false_hits;
        } else if (has(hit.flags, HitFlags::seam)) {
            ++agreement_.at_border;
        } else if (const double off = peer_.distance(hit.position); off <= tolerance()) {
            ++agreement_.lost_by_peer;
        } else {
            report(ray, hit.t, "hit off the faces by " + std::to_string(off));
            ++agreement_.false_hits;
        }
    }

    void judge_missing(const Ray& ray, const PeerHit& hit, const std::vector<Hit>& ours) {
        // OpenCASCADE takes points within the edges' tolerances for material; Keiko's seam band
        // is not wider. What lies there may go either way.
        const double band = std::max(hit.tolerance, tolerance());
        if (hit.on_border || near_border(hit, band))
            ++agreement_.at_border;
        else if ((ray.at(hit.t) - hit.position).length() > tolerance() ||
                 peer_.distance(hit.position) > tolerance() ||
                 has_hit_at(ours, hit.t, 1e-4 * size_))
            ++agreement_.peer_inexact;
        else {
            report(ray, hit.t, "lost");
            ++agreement_.lost;
        }
    }

    /// Whether a step sideways in the surface leaves the material: probed with parallel rays.
    bool near_border(const PeerHit& hit, double band) {
        const Ray probe = probe_towards(hit.position);
        const auto around = peer_.all(probe);
        return std::none_of(around.begin(), around.end(), [&](const PeerHit& p) {
            return (p.position - hit.position).length() <= band && !p.on_border;
        });
    }

    Ray probe_towards(const Vec3& point) const {
        Ray probe;
        probe.direction = Vec3(0.36, 0.48, 0.8).normalized();
        probe.origin = point - probe.direction * (2 * size_);
        return probe;
    }

    static void report(const Ray& ray, double t, const std::string& what) {
        std::cout.precision(17);
        std::cout << what << " at t " << t << ", ray " << ray.origin << " " << ray.direction
                  << "\n";
    }

    OpenCascadeTracer peer_;
    Tracer tracer_;
    double size_;
    Agreement agreement_;
};

void expect_agreement(const std::filesystem::path& file) {
    const SurfaceModel model = load_model(file, {}, {});
    Comparison comparison(file, model);
    for (const Ray& ray : random_rays(hull_bounds(model), ray_count)) comparison.compare(ray);
    const Agreement& a = comparison.agreement();
    std::cout << file.filename().string() << ": " << a.common << " common hits, OpenCASCADE lost "
              << a.lost_by_peer << ", at borders " << a.at_border << ", OpenCASCADE inexact "
              << a.peer_inexact << ", lost " << a.lost << ", false " << a.false_hits << "\n";
    EXPECT_GT(a.common, ray_count / 20);
    EXPECT_EQ(a.lost, 0);
    EXPECT_EQ(a.false_hits, 0);
}

class OpenCascadeHits : public testing::TestWithParam<const char*> {};

} // namespace

TEST_P(OpenCascadeHits, NoneIsLostAndNoneIsFalse) {
    KEIKO_NEEDS_SHARED_MODEL(GetParam());
    expect_agreement(test::shared_model(GetParam()));
}

INSTANTIATE_TEST_SUITE_P(RealModels, OpenCascadeHits,
                         testing::Values("car-front-fender.brep", "car-hood.brep",
                                         "car-rear-deck-half-panel.brep", "linkrods.step",
                                         "hammer.igs"),
                         test::file_test_name);

class OpenCascadeFixtureHits : public testing::TestWithParam<const char*> {};

TEST_P(OpenCascadeFixtureHits, NoneIsLostAndNoneIsFalse) {
    expect_agreement(test::repository("surfaces") / GetParam());
}

INSTANTIATE_TEST_SUITE_P(Surfaces, OpenCascadeFixtureHits,
                         testing::Values("bored-block.step", "hood.step"), test::file_test_name);
