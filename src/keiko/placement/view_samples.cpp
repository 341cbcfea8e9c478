#include "keiko/placement/view_samples.h"

#include "keiko/base/log.h"
#include "keiko/base/parallel.h"
#include "keiko/intersect/hit/hit_statistics.h"
#include "keiko/placement/mirrored_ray.h"

#include <algorithm>
#include <cmath>

namespace keiko {
namespace {

/// Edge, in pixels, of the square that one sample stands for.
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

    /// The samples of one row of a picture; counts all that it meets.
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
