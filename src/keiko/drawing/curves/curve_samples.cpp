#include "keiko/drawing/curves/curve_samples.h"

#include "keiko/base/job.h"

#include <algorithm>
#include <array>

namespace keiko {
namespace {

class Sampler {
public:
    Sampler(const SurfaceCurve& curve, double chord_error)
        : curve_(curve), chord_error_(chord_error) {}

    void begin(double t) { add(t, curve_.at(t).position); }
    void run_to(double t) { follow(t, curve_.at(t).position, most_halvings); }
    CurveSamples take() { return std::move(samples_); }

private:
    static constexpr int most_halvings = 12;

    void add(double t, const Vec3& point) {
        samples_.t.push_back(t);
        samples_.points.push_back(point);
    }

    void follow(double t, const Vec3& end, int halvings) {
        check_stop();
        const double from = samples_.t.back(), middle = (from + t) / 2;
        if (halvings == 0 || is_straight(samples_.points.back(), end, from, t)) return add(t, end);
        follow(middle, curve_.at(middle).position, halvings - 1);
        follow(t, end, halvings - 1);
    }

    bool is_straight(const Vec3& a, const Vec3& b, double from, double to) const {
        const Vec3 chord = b - a;
        const double length = chord.length();
        for (const double share : {0.25, 0.5, 0.75}) {
            const Vec3 off = curve_.at(from + share * (to - from)).position - a;
            const double bulge = length > 0 ? chord.cross(off).length() / length : off.length();
            if (!(bulge <= chord_error_)) return false;
        }
        return true;
    }

    const SurfaceCurve& curve_;
    double chord_error_;
    CurveSamples samples_;
};

} // namespace

CurveSamples sampled(const SurfaceCurve& curve, double begin, double end, double chord_error) {
    std::vector<double> stops = curve.patch_changes(std::min(begin, end), std::max(begin, end));
    if (begin > end) std::reverse(stops.begin(), stops.end());
    stops.push_back(end);
    Sampler sampler(curve, chord_error);
    sampler.begin(begin);
    for (const double stop : stops) sampler.run_to(stop);
    return sampler.take();
}

} // namespace keiko
