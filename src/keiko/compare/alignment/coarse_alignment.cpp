#include "keiko/compare/alignment/coarse_alignment.h"

#include "keiko/base/parallel.h"
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

void RigidStep::add(const Vec3& place, const Vec3& direction, double distance, double weight) {
    const Vec3 turn = ((place - pivot_) / size_).cross(direction);
    const std::array<double, 6> row{turn.x, turn.y, turn.z, direction.x, direction.y, direction.z};
    for (std::size_t i = 0; i < 6; ++i) {
        for (std::size_t j = 0; j < 6; ++j) matrix_[i][j] += weight * row[i] * row[j];
        right_[i] -= weight * row[i] * distance;
    }
}

/// Cholesky's decomposition of the matrix with a little of its trace on the diagonal, so that what
/// is free does not move.
std::array<double, 6> RigidStep::solution() const {
    double trace = 0;
    for (std::size_t i = 0; i < 6; ++i) trace += matrix_[i][i];
    std::array<double, 6> x{};
    if (!(trace > 0)) return x;
    constexpr double damping = 1e-13;
    auto l = matrix_;
    for (std::size_t i = 0; i < 6; ++i) {
        l[i][i] += damping * trace;
        for (std::size_t j = 0; j <= i; ++j) {
            double sum = l[i][j];
            for (std::size_t k = 0; k < j; ++k) sum -= l[i][k] * l[j][k];
            l[i][j] = i == j ? std::sqrt(std::max(sum, damping * trace)) : sum / l[j][j];
        }
    }
    for (std::size_t i = 0; i < 6; ++i) {
        x[i] = right_[i];
        for (std::size_t k = 0; k < i; ++k) x[i] -= l[i][k] * x[k];
        x[i] /= l[i][i];
    }
    for (std::size_t i = 6; i-- > 0;) {
        for (std::size_t k = i + 1; k < 6; ++k) x[i] -= l[k][i] * x[k];
        x[i] /= l[i][i];
    }
    return x;
}

Affine RigidStep::motion() const {
    const std::array<double, 6> x = solution();
    const Vec3 turn = Vec3(x[0], x[1], x[2]) / size_, shift(x[3], x[4], x[5]);
    const Affine turned = turn == Vec3(0) ? Affine{} : Affine::rotate(turn, turn.length());
    return Affine::translate(pivot_ + shift) * turned * Affine::translate(-pivot_);
}

double RigidStep::length() const {
    double square = 0;
    for (const double x : solution()) square += x * x;
    return std::sqrt(square);
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

/// Steps by tangent planes for as long as they bring the clouds nearer.
Tried improved(const SampleCloud& body, const Cloud& other, Affine motion, double size) {
    constexpr int most_steps = 60;
    Tried best;
    for (int i = 0; i < most_steps; ++i) {
        double square = 0, area = 0;
        RigidStep step(motion.point(centre_of(body)), size);
        for (const SurfaceSample& sample : body) {
            const Vec3 p = motion.point(sample.point.position);
            const SurfacePoint& foot = other.nearest(p);
            square += sample.area * (p - foot.position).length2(), area += sample.area;
            step.add(p, foot.normal, (p - foot.position).dot(foot.normal), sample.area);
            // Points are held as well, a little: planes let them slide without end.
            constexpr double hold = 0.05;
            for (const Vec3& way : {Vec3(1, 0, 0), Vec3(0, 1, 0), Vec3(0, 0, 1)})
                step.add(p, way, (p - foot.position).dot(way), hold * sample.area);
        }
        if (!(square / area < best.square * (1 - 1e-6))) break;
        best = {motion, square / area};
        motion = step.motion() * motion;
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
                        const Job& job) {
    const std::vector<Affine> motions = starts(body, other);
    const Cloud cloud(other);
    std::vector<Tried> tried(motions.size());
    parallel_for(motions.size(), job, "align",
                 [&](std::size_t i) { tried[i] = improved(body, cloud, motions[i], size); });
    double least = infinity;
    for (const Tried& one : tried) least = std::min(least, one.square);
    // Parts with a symmetry have several best ones: the smallest motion comes first.
    constexpr double as_good = 1.5;
    return std::find_if(tried.begin(), tried.end(),
                        [&](const Tried& one) { return one.square <= as_good * least; })
        ->motion;
}

} // namespace keiko
