#include "keiko/compare/alignment/coarse_alignment.h"

#include "keiko/base/error.h"
#include "keiko/base/parallel.h"
#include "keiko/compare/alignment/rigid_step.h"
#include "keiko/geometry/bvh/box_tree.h"
#include "keiko/math/axes.h"

#include <algorithm>
#include <cmath>

namespace keiko {

double sample_spacing(const ClosestPointQuery& body, std::size_t count) {
    double area = 0;
    for (std::size_t i = 0; i < body.piece_count(); ++i)
        area += body.piece_size(i).x * body.piece_size(i).y;
    return std::sqrt(area / static_cast<double>(count));
}

std::vector<SurfaceSample> piece_samples(const ClosestPointQuery& body, std::size_t piece,
                                         double spacing, int least) {
    constexpr int most = 256;
    const auto cells = [&](double length) {
        return static_cast<int>(
            std::clamp(std::ceil(length / spacing), double(least), double{most}));
    };
    const Vec2 size = body.piece_size(piece);
    const int nu = cells(size.x), nv = cells(size.y);
    std::vector<SurfaceSample> samples;
    for (int i = 0; i < nu; ++i)
        for (int j = 0; j < nv; ++j) {
            const auto point = body.point(piece, {(i + 0.5) / nu, (j + 0.5) / nv});
            if (!point) continue;
            const Vec2 cell(1.0 / nu, 1.0 / nv);
            samples.push_back({*point, point->stretch * cell.x * cell.y, cell});
        }
    return samples;
}

SampleCloud surface_cloud(const ClosestPointQuery& body, std::size_t count) {
    constexpr int most_halvings = 5;
    double spacing = sample_spacing(body, count);
    SampleCloud cloud;
    for (int halvings = 0; cloud.empty() && halvings <= most_halvings; ++halvings, spacing /= 2)
        for (std::size_t i = 0; i < body.piece_count(); ++i)
            for (const SurfaceSample& sample : piece_samples(body, i, spacing, 1))
                cloud.push_back(sample);
    if (cloud.empty())
        throw FieldError("align", "one of the bodies has too little material to align by");
    return cloud;
}

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

std::array<Vec3, 3> axes_of(const SampleCloud& cloud) {
    const Vec3 centre = centre_of(cloud);
    SecondMoments moments;
    for (const SurfaceSample& sample : cloud)
        moments.add(sample.point.position - centre, sample.area);
    return principal_axes(moments);
}

/// The turn about the origin that lays the first axes onto the second.
Affine turn_between(const std::array<Vec3, 3>& from, const std::array<Vec3, 3>& to) {
    Affine turn;
    turn.rows = {Vec3(0), Vec3(0), Vec3(0)};
    for (std::size_t k = 0; k < 3; ++k)
        for (unsigned i = 0; i < 3; ++i) turn.rows[i] += from[k] * to[k][i];
    return turn;
}

/// The motions to start from.
std::vector<Affine> starts(const SampleCloud& body, const SampleCloud& other) {
    const Vec3 from = centre_of(body), to = centre_of(other);
    std::vector<Affine> all{Affine{}, Affine::translate(to - from)};
    const std::array<Vec3, 3> axes = axes_of(body), target = axes_of(other);
    for (const auto& [first, second] : {std::array{1, 1}, {1, -1}, {-1, 1}, {-1, -1}}) {
        const std::array<Vec3, 3> turned{axes[0] * first, axes[1] * second,
                                         axes[2] * (first * second)};
        all.push_back(Affine::translate(to) * turn_between(turned, target) *
                      Affine::translate(-from));
    }
    return all;
}

/// The other body's places, found by nearness.
class Cloud {
public:
    explicit Cloud(const SampleCloud& samples) : samples_(samples), tree_(boxes_of(samples)) {}

    const SurfacePoint& nearest(const Vec3& p) const {
        std::uint32_t best = 0;
        double radius = infinity;
        tree_.visit_near(p, infinity, [&](std::uint32_t i) {
            const double distance = (samples_[i].point.position - p).length();
            if (distance < radius) radius = distance, best = i;
            return radius;
        });
        return samples_[best].point;
    }

private:
    static std::vector<Box3> boxes_of(const SampleCloud& samples) {
        std::vector<Box3> boxes;
        for (const SurfaceSample& sample : samples)
            boxes.push_back({sample.point.position, sample.point.position});
        return boxes;
    }
    const SampleCloud& samples_;
    BoxTree tree_;
};

struct Tried {
    Affine motion;
    double square = infinity; ///< mean square distance, mm2
};

/// A sample of the body, moved, and the other's place next to it.
struct Pair {
    Vec3 place, foot, normal;
    double square = 0, area = 0; ///< mm2, of their distance; of the sample
};

/// The pairs of the samples at a motion, without the farthest ones.
std::vector<Pair> nearest_pairs(const SampleCloud& body, const Cloud& other, const Affine& motion,
                                double share) {
    std::vector<Pair> pairs;
    for (const SurfaceSample& sample : body) {
        const Vec3 p = motion.point(sample.point.position);
        const SurfacePoint& foot = other.nearest(p);
        pairs.push_back(
            {p, foot.position, foot.normal, (p - foot.position).length2(), sample.area});
    }
    std::stable_sort(pairs.begin(), pairs.end(),
                     [](const Pair& a, const Pair& b) { return a.square < b.square; });
    pairs.resize(static_cast<std::size_t>(std::ceil(share * static_cast<double>(pairs.size()))));
    return pairs;
}

/// Steps by tangent planes for as long as they bring the clouds nearer.
Tried improved(const SampleCloud& body, const Cloud& other, Affine motion, double size,
               double share) {
    constexpr int most_steps = 60;
    Tried best;
    for (int i = 0; i < most_steps; ++i) {
        double square = 0, area = 0;
        RigidStep step(motion.point(centre_of(body)), size);
        for (const Pair& pair : nearest_pairs(body, other, motion, share)) {
            const Vec3 off = pair.place - pair.foot;
            square += pair.area * pair.square, area += pair.area;
            step.add(pair.place, pair.normal, off.dot(pair.normal), pair.area);
            // Points are held as well, a little: planes let them slide without end.
            constexpr double hold = 0.05;
            for (const Vec3& way : {Vec3(1, 0, 0), Vec3(0, 1, 0), Vec3(0, 0, 1)})
                step.add(pair.place, way, off.dot(way), hold * pair.area);
        }
        if (!(square / area < best.square * (1 - 1e-6))) break;
        best = {motion, square / area};
        motion = step.motion(step.solution(rounding_share)) * motion;
    }
    return best;
}

} // namespace

Vec3 centre_of(const SampleCloud& cloud) {
    Vec3 sum(0);
    double area = 0;
    for (const SurfaceSample& sample : cloud)
        sum += sample.point.position * sample.area, area += sample.area;
    return area > 0 ? sum / area : sum;
}

Affine coarse_alignment(const SampleCloud& body, const SampleCloud& other, double size,
                        double share, const Job& job) {
    const std::vector<Affine> motions = starts(body, other);
    const Cloud cloud(other);
    std::vector<Tried> tried(motions.size());
    parallel_for(motions.size(), job, "align",
                 [&](std::size_t i) { tried[i] = improved(body, cloud, motions[i], size, share); });
    double least = infinity;
    for (const Tried& one : tried) least = std::min(least, one.square);
    // Parts with a symmetry have several best ones: the smallest motion comes first.
    constexpr double as_good = 1.5;
    return std::find_if(tried.begin(), tried.end(),
                        [&](const Tried& one) { return one.square <= as_good * least; })
        ->motion;
}

} // namespace keiko
