#include "keiko/stream/traced_rays.h"

#include "keiko/base/parallel.h"
#include "keiko/render/shading/integrator.h"
#include "keiko/stream/ray_lines.h"

#include <algorithm>

namespace keiko {
namespace {

/// Calls `work(first, rays)` for runs of rays, on any thread.
template <class Work>
void for_runs(const Scene& scene, std::span<const Ray> rays, const Job& job, const Work& work) {
    constexpr std::size_t most = 4096;
    require_rays(rays, "rays", scene.seen().bounds());
    parallel_for((rays.size() + most - 1) / most, job, "trace", [&](std::size_t i) {
        const std::size_t first = i * most;
        work(first, rays.subspan(first, std::min(most, rays.size() - first)));
    });
}

Hit numbered(const Scene& scene, const Hit& hit) {
    Hit told = hit;
    told.face = scene.face_id(hit.face);
    return told;
}

} // namespace

void trace_hits(const Scene& scene, std::span<const Ray> rays,
                const std::function<void(std::size_t, const Hit*)>& write, const Job& job) {
    for_runs(scene, rays, job, [&](std::size_t first, std::span<const Ray> run) {
        const auto hits = scene.seen().first_hits(run);
        for (std::size_t k = 0; k < run.size(); ++k) {
            if (!hits[k]) {
                write(first + k, nullptr);
                continue;
            }
            const Hit hit = numbered(scene, *hits[k]);
            write(first + k, &hit);
        }
    });
}

void trace_all_hits(const Scene& scene, std::span<const Ray> rays,
                    const std::function<void(std::size_t, std::span<const Hit>)>& write,
                    const Job& job) {
    for_runs(scene, rays, job, [&](std::size_t first, std::span<const Ray> run) {
        std::vector<std::vector<Hit>> found = scene.seen().all(run);
        for (std::size_t k = 0; k < run.size(); ++k) {
            for (Hit& hit : found[k]) hit = numbered(scene, hit);
            write(first + k, found[k]);
        }
    });
}

std::vector<Rgb> luminances_along(const Scene& scene, const LightRig& rig,
                                  std::span<const Ray> rays, const Job& job) {
    const PictureScene picture = scene.picture(rig);
    const PictureOptions options = picture_options(scene);
    const Integrator integrator(picture, options, std::nullopt, job);
    std::vector<Rgb> found(rays.size());
    for_runs(scene, rays, job, [&](std::size_t first, std::span<const Ray> run) {
        const SampleBatch view = integrator.follow(run);
        for (std::size_t k = 0; k < run.size(); ++k) found[first + k] = view.samples[k].luminance;
    });
    return found;
}

} // namespace keiko
