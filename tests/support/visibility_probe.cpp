#include "tests/support/visibility_probe.h"

#include "keiko/visibility/query/visibility_query.h"

#include "tests/support/leaf_bounds.h"

#include <sstream>

namespace keiko::test {
namespace {

/// Parameter of a segment: this close to an end either answer is right, as rays take an edge's
/// tolerance for material.
constexpr double next_to_end = 1e-6;

bool next_to_an_end(const IntervalSet& set, double t) {
    for (const ParameterInterval& i : set)
        if (std::abs(t - i.begin) < next_to_end || std::abs(t - i.end) < next_to_end) return true;
    return false;
}

/// Parallel segments on a plane somewhere beside the body.
struct Row {
    Vec3 begin, along, across;

    Row(const Box3& body, Random& random) {
        const double size = body.size();
        const Vec3 out = random_direction(random);
        const Vec3 middle = body.center() + out * (size * uniform(random, 0.3, 1.5));
        along = random_direction(random) * (size * uniform(random, 0.2, 1.5));
        across = out.cross(along).normalized() * (size * uniform(random, 0.2, 1.0));
        begin = middle - along / 2 - across / 2;
    }
    std::array<Vec3, 4> corners() const {
        return {begin, begin + along, begin + across, begin + along + across};
    }
};

std::string describe(const Viewpoint& viewpoint, const Vec3& a, const Vec3& b, double t,
                     const IntervalSet& seen) {
    std::ostringstream text;
    text.precision(17);
    text << (viewpoint.infinite() ? "direction " : "viewpoint ") << viewpoint.place() << " segment "
         << a << " to " << b << " at t = " << t << ", seen";
    for (const ParameterInterval& i : seen) text << " [" << i.begin << ", " << i.end << "]";
    return text.str();
}

} // namespace

std::string ProbeCounts::text() const {
    std::ostringstream text;
    text << segments << " segments, " << partly_hidden << " partly hidden, " << wrong_segments
         << " wrong, " << uncertain << " uncertain, " << probes << " probes";
    if (!first_wrong.empty()) text << "\n  first wrong: " << first_wrong;
    return text.str();
}

VisibilityProbe::VisibilityProbe(const SurfaceModel& model)
    : tracer_(model), occluders_(model, tracer_) {}

std::optional<Viewpoint> VisibilityProbe::random_apex(From from, Random& random) const {
    const Box3 body = leaf_bounds(tracer_);
    if (from == From::infinity) return Viewpoint::towards(random_direction(random));
    const Vec3 outside = body.center() + random_direction(random) * body.size();
    if (from == From::space) return Viewpoint::at(outside);
    Ray ray;
    ray.origin = outside;
    for (unsigned k = 0; k < 3; ++k)
        ray.direction[k] = uniform(random, body.lower[k], body.upper[k]) - ray.origin[k];
    const auto hit = tracer_.nearest(ray);
    if (!hit) return std::nullopt;
    return Viewpoint::at(hit->position, hit->root);
}

void VisibilityProbe::look(From from, int lamps, int probes, Random& random,
                           ProbeCounts& counts) const {
    const auto viewpoint = random_apex(from, random);
    if (!viewpoint) return;
    const Row row(leaf_bounds(tracer_), random);
    const VisibilityQuery view(occluders_, tracer_, *viewpoint, row.corners());
    for (int i = 0; i < lamps; ++i) {
        const Vec3 a = row.begin + row.across * ((i + 0.5) / lamps), b = a + row.along;
        const VisibleIntervals parts = view.intervals({a, b});
        ++counts.segments;
        counts.uncertain += !parts.certain;
        const double seen = parts.intervals.measure();
        counts.partly_hidden += seen > 0 && seen < 1;
        bool wrong = false;
        for (int k = 0; k < probes; ++k) {
            const double t = uniform(random, 0, 1);
            if (next_to_an_end(parts.intervals, t)) continue;
            ++counts.probes;
            const bool hidden = tracer_.any(viewpoint->ray_to(a + (b - a) * t));
            if (hidden != parts.intervals.contains(t)) continue;
            if (counts.first_wrong.empty())
                counts.first_wrong = describe(*viewpoint, a, b, t, parts.intervals);
            wrong = true;
        }
        counts.wrong_segments += wrong;
    }
}

} // namespace keiko::test
