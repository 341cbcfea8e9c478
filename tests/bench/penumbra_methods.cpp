#include "tests/bench/penumbra_methods.h"

#include "keiko/light/tubes/tube_irradiance.h"
#include "keiko/light/tubes/tube_penumbra.h"
#include "keiko/render/shading/direct_lighting.h"
#include "keiko/render/shading/occluded_visibility.h"
#include "keiko/visibility/query/visibility_query.h"

#include "tests/bench/cpu_clock.h"
#include "tests/support/random.h"

#include <algorithm>
#include <cmath>

namespace keiko::bench {
namespace {

using namespace test;

std::vector<Vec3> region_of(const Receiver& at, const CPlane& row) {
    const PreparedSource source(row);
    return light_bounds(source, source.lamp_numbers(), at.position);
}

VisibilityQuery view_from(const PenumbraScene& scene, const Receiver& at, const CPlane& row) {
    return {scene.occluders, scene.tracer, Viewpoint::at(at.position, at.root), region_of(at, row),
            at.normal};
}

TubeModel model_of(Emitter emitter) {
    switch (emitter) {
        case Emitter::axis:
            return TubeModel::line;
        case Emitter::rectangle:
            return TubeModel::rectangle;
        case Emitter::tube:
            break;
    }
    return TubeModel::picture;
}

double unhidden(const TubeLamp& lamp, const Receiver& at, Emitter emitter) {
    return projected_solid_angle(lamp, at.position, at.normal, IntervalSet::whole(),
                                 model_of(emitter));
}

/// Runs `lit(receiver)`, the sum over the row of what is seen, for all receivers.
template <class Lit>
Shares shares(const PenumbraScene& scene, const CPlane& row, Emitter emitter, const Lit& lit) {
    Shares all;
    const std::vector<TubeLamp> lamps = lamps_of(row);
    all.seconds = thread_seconds([&] {
        for (const Receiver& at : scene.receivers) all.values.push_back(lit(at, lamps));
    });
    const double mean = mean_unhidden(scene, row, emitter);
    for (double& value : all.values) value /= mean;
    return all;
}

/// Light of a stratum that a receiver sees, if the ray to it is free.
struct Sample {
    Ray ray;
    double light;
};

/// A lamp's rectangle as a receiver sees it.
struct Rectangle {
    Vec3 begin, along, across; ///< across from one edge to the other
    Vec3 facing;               ///< unit, towards the receiver
    double area;               ///< mm2

    Rectangle(const TubeLamp& lamp, const Vec3& point) : begin(lamp.a), along(lamp.b - lamp.a) {
        const Vec3 axis = along.normalized(), way = point - lamp.a;
        facing = (way - axis * axis.dot(way)).normalized();
        across = axis.cross(facing) * lamp.diameter;
        begin -= across / 2;
        area = along.length() * lamp.diameter;
    }
};

void add_samples(const TubeLamp& lamp, const Receiver& at, Emitter emitter, const Strata& strata,
                 Random& random, std::vector<Sample>& samples) {
    const Rectangle lit(lamp, at.position);
    const double share = lit.area / (strata.along * strata.across);
    for (int i = 0; i < strata.along; ++i)
        for (int j = 0; j < strata.across; ++j) {
            const double u = (i + uniform(random, 0, 1)) / strata.along;
            const double v =
                emitter == Emitter::axis ? 0.5 : (j + uniform(random, 0, 1)) / strata.across;
            const Vec3 x = lit.begin + lit.along * u + lit.across * v, way = x - at.position;
            const double cosine = at.normal.dot(way), squared = way.length2();
            if (!(cosine > 0)) continue;
            const double light = -cosine * lit.facing.dot(way) / (squared * squared) * share;
            samples.push_back({Viewpoint::at(at.position, at.root).ray_to(x), light});
        }
}

bool next_to_an_end(const IntervalSet& set, double t) {
    constexpr double next = 1e-6;
    for (const ParameterInterval& i : set)
        if (std::abs(t - i.begin) < next || std::abs(t - i.end) < next) return true;
    return false;
}

} // namespace

Shares by_intervals(const PenumbraScene& scene, const CPlane& row) {
    return shares(scene, row, Emitter::axis,
                  [&](const Receiver& at, const std::vector<TubeLamp>& lamps) {
                      const VisibilityQuery view = view_from(scene, at, row);
                      std::vector<Segment> axes;
                      for (const TubeLamp& lamp : lamps) axes.push_back({lamp.a, lamp.b});
                      const std::vector<VisibleIntervals> seen = view.intervals(axes);
                      double sum = 0;
                      for (std::size_t i = 0; i < lamps.size(); ++i)
                          sum += projected_solid_angle(lamps[i], at.position, at.normal,
                                                       seen[i].intervals, TubeModel::line);
                      return sum;
                  });
}

Shares by_width(const PenumbraScene& scene, const CPlane& row, double tolerance, Emitter emitter) {
    const TubeShape shape = emitter == Emitter::tube ? TubeShape::cylinder : TubeShape::rectangle;
    return shares(scene, row, emitter, [&](const Receiver& at, const std::vector<TubeLamp>& lamps) {
        const OccludedVisibility visible(&scene.occluders, scene.tracer,
                                         Viewpoint::at(at.position, at.root), region_of(at, row),
                                         {}, at.normal);
        std::vector<TubeLamp> above = lamps;
        std::erase_if(above, [&](const TubeLamp& lamp) {
            return below_horizon(lamp, at.position, at.normal);
        });
        const std::vector<LightVisibility> seen =
            seen_tubes(above, at.position, at.normal, visible, {tolerance, shape});
        double sum = 0;
        for (std::size_t i = 0; i < above.size(); ++i)
            sum += unhidden(above[i], at, emitter) * seen[i].share;
        return sum;
    });
}

Shares by_samples(const PenumbraScene& scene, const CPlane& row, Emitter emitter,
                  const Strata& strata) {
    Random random(3);
    std::vector<Sample> samples;
    std::vector<Ray> rays;
    return shares(scene, row, emitter, [&](const Receiver& at, const std::vector<TubeLamp>& lamps) {
        samples.clear(), rays.clear();
        for (const TubeLamp& lamp : lamps) add_samples(lamp, at, emitter, strata, random, samples);
        for (const Sample& sample : samples) rays.push_back(sample.ray);
        const std::vector<bool> hidden = scene.tracer.any(std::span<const Ray>(rays));
        double sum = 0;
        for (std::size_t i = 0; i < samples.size(); ++i)
            if (!hidden[i]) sum += samples[i].light;
        return sum;
    });
}

double mean_unhidden(const PenumbraScene& scene, const CPlane& row, Emitter emitter) {
    double whole = 0;
    for (const Receiver& at : scene.receivers)
        for (const TubeLamp& lamp : lamps_of(row)) whole += unhidden(lamp, at, emitter);
    return whole / static_cast<double>(scene.receivers.size());
}

double rms(const Shares& a, const Shares& b) {
    double sum = 0;
    for (std::size_t i = 0; i < a.values.size(); ++i) {
        const double off = a.values[i] - b.values[i];
        sum += off * off;
    }
    return std::sqrt(sum / static_cast<double>(a.values.size()));
}

WrongLamps wrong_lamps(const PenumbraScene& scene, const CPlane& row, int probes) {
    WrongLamps count;
    Random random(4);
    for (const Receiver& at : scene.receivers) {
        const VisibilityQuery view = view_from(scene, at, row);
        const Viewpoint viewpoint = Viewpoint::at(at.position, at.root);
        std::vector<Segment> axes;
        for (const TubeLamp& lamp : lamps_of(row)) axes.push_back({lamp.a, lamp.b});
        const std::vector<VisibleIntervals> seen = view.intervals(axes);
        for (std::size_t i = 0; i < axes.size(); ++i) {
            std::vector<Ray> rays;
            std::vector<double> places;
            for (int k = 0; k < probes; ++k) {
                const double t = (k + uniform(random, 0, 1)) / probes;
                const Vec3 x = axes[i].at(t);
                if (next_to_an_end(seen[i].intervals, t)) continue;
                if (!(at.normal.dot(x - at.position) > 0)) continue;
                rays.push_back(viewpoint.ray_to(x));
                places.push_back(t);
            }
            const std::vector<bool> hidden = scene.tracer.any(std::span<const Ray>(rays));
            bool wrong = false;
            for (std::size_t k = 0; k < places.size(); ++k)
                wrong = wrong || hidden[k] == seen[i].intervals.contains(places[k]);
            ++count.lamps;
            count.wrong += wrong;
            count.uncertain += !seen[i].certain;
            count.probes += places.size();
        }
    }
    return count;
}

} // namespace keiko::bench
