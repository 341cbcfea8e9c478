#include "tests/bench/accuracy.h"

#include "keiko/base/units.h"
#include "keiko/intersect/hit/reflect_ray.h"

#include "tests/bench/summary.h"

#include <cmath>

namespace keiko::bench {
namespace {

constexpr double lamp_distance = 3000; // mm
constexpr double arcsec = 3600;        // in a degree

/// Part of `v` across the unit vector `axis`.
Vec3 across(const Vec3& v, const Vec3& axis) {
    return v - axis * v.dot(axis);
}

Vec3 at_lamps(const Ray& ray, double t, const Vec3& normal) {
    return ray.at(t) + reflect(ray.direction, normal) * lamp_distance;
}

/// mm at the lamps between the ray mirrored in truth and the one mirrored by the answer.
double lateral_error(const Ray& ray, const Hit& truth, const Answer& answer) {
    const Vec3 off = at_lamps(ray, answer.t, answer.normal) - at_lamps(ray, truth.t, truth.normal);
    return across(off, reflect(ray.direction, truth.normal)).length();
}

/// Edge of a pixel's image at the lamps, mm.
std::optional<double> pixel_footprint(const Ray& ray, const Hit& truth) {
    const Ray mirrored = reflect_ray(ray, truth);
    if (!mirrored.differentials) return std::nullopt;
    const RayDifferentials& d = *mirrored.differentials;
    const Vec3 dx = across(d.origin_dx + d.direction_dx * lamp_distance, mirrored.direction);
    const Vec3 dy = across(d.origin_dy + d.direction_dy * lamp_distance, mirrored.direction);
    return (dx.length() + dy.length()) / 2;
}

double normal_error(const Vec3& a, const Vec3& b) {
    return radians_to_degrees(angle_between(a, a.dot(b) < 0 ? -b : b)) * arcsec;
}

class Judge {
public:
    Judge(const RaySet& rays, const PlaceTolerance& tolerance)
        : rays_(rays), tolerance_(tolerance) {}

    void judge(std::size_t i, const std::optional<Answer>& answer) {
        const std::optional<Hit>& truth = rays_.truth[i];
        ++result_.rays;
        const bool same = truth && answer && meets(i, *answer, truth->t, truth->normal);
        const bool before = answer && (!truth || answer->t < truth->t);
        if (answer && !same && before) ++result_.false_hits;
        if (rays_.known.empty())
            judge_missed(truth.has_value(), same || before);
        else
            judge_missed(true, answer && reaches(i, *answer, rays_.known[i]));
        if (same) compare(rays_.rays[i], *truth, *answer);
    }

    Accuracy result() {
        result_.normal_p50 = quantile(normals_, 0.5);
        result_.normal_p99 = quantile(normals_, 0.99);
        result_.lateral_p99 = quantile(laterals_, 0.99);
        if (!zebras_.empty())
            result_.zebra = {quantile(zebras_, 0.5), quantile(zebras_, 0.99),
                             quantile(zebras_, 0.999)};
        return result_;
    }

private:
    /// Whether the answer is the point at `t`, where the surface has that normal.
    bool meets(std::size_t i, const Answer& answer, double t, const Vec3& normal) const {
        const double apart = std::abs(answer.t - t);
        return apart <= tolerance_.along_ray &&
               apart * std::abs(rays_.rays[i].direction.dot(normal)) <= tolerance_.off_plane;
    }
    bool reaches(std::size_t i, const Answer& answer, const KnownPoint& known) const {
        return answer.t <= known.t || meets(i, answer, known.t, known.normal);
    }
    void judge_missed(bool there, bool found) {
        result_.hits += there;
        result_.missed += there && !found;
    }
    void compare(const Ray& ray, const Hit& truth, const Answer& answer) {
        normals_.push_back(normal_error(truth.normal, answer.normal));
        laterals_.push_back(lateral_error(ray, truth, answer));
        if (!ray.differentials || ray.excluded) return;
        if (const auto pixel = pixel_footprint(ray, truth))
            zebras_.push_back(laterals_.back() / *pixel);
    }

    const RaySet& rays_;
    PlaceTolerance tolerance_;
    Accuracy result_;
    std::vector<double> normals_, laterals_, zebras_;
};

} // namespace

Accuracy judged(const RaySet& rays, const Answers& answers, std::size_t stride,
                const PlaceTolerance& tolerance) {
    Judge judge(rays, tolerance);
    for (std::size_t i = 0; i < answers.size(); ++i) judge.judge(i * stride, answers[i]);
    return judge.result();
}

} // namespace keiko::bench
