#include "tests/bench/accuracy.h"

#include "keiko/base/units.h"
#include "keiko/intersect/hit/reflect_ray.h"
#include "keiko/math/nearest_rank.h"
#include "keiko/raster/reflection_error.h"

#include <cmath>

namespace keiko::bench {
namespace {

constexpr double lamp_distance = 3000; // mm
constexpr double arcsec = 3600;        // in a degree

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
        result_.normal_p50 = nearest_rank(normals_, 0.5);
        result_.normal_p99 = nearest_rank(normals_, 0.99);
        result_.lateral_p99 = nearest_rank(laterals_, 0.99);
        if (!zebras_.empty())
            result_.zebra = {nearest_rank(zebras_, 0.5), nearest_rank(zebras_, 0.99),
                             nearest_rank(zebras_, 0.999)};
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
        normals_.push_back(radians_to_degrees(normal_error(truth.normal, answer.normal)) * arcsec);
        laterals_.push_back(mirror_displacement(ray, {truth.t, truth.normal},
                                                {answer.t, answer.normal}, lamp_distance));
        if (!ray.differentials || ray.excluded) return;
        if (const auto pixel = mirrored_pixel(reflect_ray(ray, truth), lamp_distance))
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
