#include "keiko/placement/view_samples.h"

#include "keiko/base/log.h"
#include "keiko/base/parallel.h"
#include "keiko/intersect/hit/hit.h"
#include "keiko/intersect/hit/reflect_ray.h"

#include <algorithm>
#include <cmath>

namespace keiko {

SurfaceDerivatives world_derivatives(const SurfaceModel& model, const Hit& hit) {
    SurfaceDerivatives s = evaluate(model.patch(hit.patch), hit.uv, 2);
    const Affine& placed = model.instances[hit.instance].transform;
    for (std::size_t k = 0; k <= 2; ++k)
        for (std::size_t l = 0; k + l <= 2; ++l) s.d[k][l] = placed.vector(s.d[k][l]);
    s.d[0][0] += placed.translation;
    return s;
}

Vec3 facing_normal(const Hit& hit, const Ray& ray) {
    return hit.normal.dot(ray.direction) > 0 ? -hit.normal : hit.normal;
}

Ray mirrored_ray(const SurfaceModel& model, const Hit& hit, const Ray& camera_ray) {
    if (hit.second) return reflect_ray(camera_ray, hit);
    const SurfaceDerivatives s = world_derivatives(model, hit);
    Hit whole = hit;
    whole.second = {s.duu(), s.duv(), s.dvv()};
    return reflect_ray(camera_ray, whole);
}

namespace {

/// The tangent of least absolute normal curvature, and the difference of the absolute curvatures.
struct LeastBend {
    Vec3 tangent{0};
    double difference = 0;
};

LeastBend least_bend(const SurfaceDerivatives& s, const Vec3& normal) {
    const PrincipalCurvatures k = principal_curvatures(s, normal);
    const bool second = std::abs(k.k2) < std::abs(k.k1);
    const double least = second ? k.k2 : k.k1, most = second ? k.k1 : k.k2;
    // (II - least I) (a, b) = 0 has two rows; the longer one determines (a, b) better.
    const Vec3 &du = s.du(), &dv = s.dv();
    const Vec2 first_row(normal.dot(s.duu()) - least * du.length2(),
                         normal.dot(s.duv()) - least * du.dot(dv));
    const Vec2 second_row(first_row.y, normal.dot(s.dvv()) - least * dv.length2());
    const Vec2 row = first_row.length2() > second_row.length2() ? first_row : second_row;
    const Vec3 tangent = du * -row.y + dv * row.x;
    if (!(tangent.length() > 0)) return {};
    return {tangent.normalized(), std::abs(most) - std::abs(least)};
}

} // namespace

FeatureDirection feature_direction(const SurfaceDerivatives& surface, const Ray& mirrored) {
    const Vec3 across = surface.du().cross(surface.dv());
    const double spread = surface.du().length() * surface.dv().length();
    if (!mirrored.differentials || !(across.length() > 1e-9 * spread)) return {};
    const LeastBend bend = least_bend(surface, across.normalized());
    const Vec3& x = mirrored.differentials->origin_dx;
    const Vec3& y = mirrored.differentials->origin_dy;
    // The step in the picture whose place on the surface moves along the tangent.
    const double xx = x.length2(), xy = x.dot(y), yy = y.length2();
    const double determinant = xx * yy - xy * xy;
    if (!(determinant > 0) || !(bend.difference > 0)) return {};
    const double tx = x.dot(bend.tangent), ty = y.dot(bend.tangent);
    const Vec2 step((yy * tx - xy * ty) / determinant, (xx * ty - xy * tx) / determinant);
    if (!(step.length() > 0) || !std::isfinite(step.length())) return {};
    return {step.normalized(), bend.difference};
}

namespace {

/// Edge, in pixels, of the square that one sample represents.
int stride(const Camera& camera, int samples) {
    const double pixels = static_cast<double>(camera.width) * camera.height;
    return std::max(1, static_cast<int>(std::sqrt(pixels / std::max(samples, 1))));
}

class Sampler {
public:
    Sampler(const Tracer& tracer, const SurfaceModel& model, const SamplingOptions& options)
        : tracer_(tracer), model_(model), options_(options), wanted_(model.faces.size(), true) {
        if (options.faces.empty()) return;
        wanted_.assign(model.faces.size(), false);
        for (const std::uint32_t face : options.faces) wanted_.at(face) = true;
    }

    /// The samples of one row of a picture; counts all of its hits.
    std::vector<ViewSample> row(const Camera& camera, std::uint32_t view, double y, int step,
                                HitStatistics& paths) const {
        std::vector<Ray> rays;
        std::vector<double> columns;
        for (double x = step / 2.0; x < camera.width; x += step) {
            columns.push_back(x);
            rays.push_back(camera.ray(x, y));
        }
        const std::vector<std::optional<Hit>> hits = tracer_.nearest(rays);
        std::vector<ViewSample> samples;
        for (std::size_t i = 0; i < rays.size(); ++i) {
            if (!hits[i]) continue;
            paths.count(*hits[i]);
            if (!wanted_[hits[i]->face]) continue;
            samples.push_back(sample(*hits[i], rays[i]));
            samples.back().view = view;
            samples.back().pixel = {columns[i], y};
            samples.back().edge = step;
            samples.back().weight = step * step * weight(camera, columns[i], y);
        }
        mark_blocked(samples);
        return samples;
    }

private:
    double weight(const Camera& camera, double x, double y) const {
        return options_.weight == SampleWeight::pixels ? 1 : camera.pixel_solid_angle(x, y);
    }

    ViewSample sample(const Hit& hit, const Ray& ray) const {
        ViewSample result;
        result.instance = hit.instance;
        result.face = hit.face;
        result.eye = ray.origin;
        result.normal = facing_normal(hit, ray);
        result.mirror = mirrored_ray(model_, hit, ray);
        result.feature = feature_direction(world_derivatives(model_, hit), result.mirror);
        return result;
    }

    void mark_blocked(std::vector<ViewSample>& samples) const {
        std::vector<Ray> mirrored;
        mirrored.reserve(samples.size());
        for (const ViewSample& s : samples) mirrored.push_back(s.mirror);
        const std::vector<bool> blocked = tracer_.any(mirrored);
        for (std::size_t i = 0; i < samples.size(); ++i) samples[i].blocked = blocked[i];
    }

    const Tracer& tracer_;
    const SurfaceModel& model_;
    const SamplingOptions& options_;
    std::vector<bool> wanted_;
};

} // namespace

std::vector<ViewSample> sample_views(const Tracer& tracer, const SurfaceModel& model,
                                     std::span<const Camera> cameras,
                                     const SamplingOptions& options, const Job& job) {
    struct Row {
        std::uint32_t view;
        double y;
        int step;
    };
    std::vector<Row> rows;
    for (std::uint32_t view = 0; view < cameras.size(); ++view) {
        const int step = stride(cameras[view], options.samples);
        for (double y = step / 2.0; y < cameras[view].height; y += step)
            rows.push_back({view, y, step});
    }
    const Sampler sampler(tracer, model, options);
    std::vector<std::vector<ViewSample>> found(rows.size());
    std::vector<HitStatistics> paths(rows.size());
    parallel_for(rows.size(), job, "look", [&](std::size_t i) {
        found[i] =
            sampler.row(cameras[rows[i].view], rows[i].view, rows[i].y, rows[i].step, paths[i]);
    });
    HitStatistics sum;
    for (const HitStatistics& row : paths) sum += row;
    log_detail("looks of " + path_text(sum));
    std::vector<ViewSample> all;
    for (const auto& row : found) all.insert(all.end(), row.begin(), row.end());
    return all;
}

} // namespace keiko
