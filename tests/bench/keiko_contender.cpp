#include "tests/bench/keiko_contender.h"

#include "tests/bench/cpu_clock.h"

#include <algorithm>
#include <span>
#include <utility>

namespace keiko::bench {
namespace {

constexpr std::size_t tile = 1024; ///< rays a call, as the renderer has them

template <class Visit>
void for_each_tile(std::span<const Ray> rays, const Visit& visit) {
    for (; !rays.empty(); rays = rays.subspan(std::min(tile, rays.size())))
        visit(rays.first(std::min(tile, rays.size())));
}

std::optional<Answer> answer_of(const std::optional<Hit>& hit) {
    if (!hit) return std::nullopt;
    return Answer{hit->t, hit->normal};
}

Answers answers_of(const Tracer& tracer, std::span<const Ray> rays, Mode mode) {
    Answers answers;
    answers.reserve(rays.size());
    if (mode == Mode::single)
        for (const Ray& ray : rays) answers.push_back(answer_of(tracer.nearest(ray)));
    else
        for_each_tile(rays, [&](std::span<const Ray> some) {
            for (const std::optional<Hit>& hit : tracer.nearest(some))
                answers.push_back(answer_of(hit));
        });
    return answers;
}

/// Timed pass that keeps one number of each hit; a request for the answers traces them again.
class KeikoPass final : public Pass {
public:
    KeikoPass(const Tracer& tracer, const RaySet& rays, Mode mode)
        : tracer_(tracer), rays_(rays.rays), mode_(mode) {}
    void run() override {
        if (mode_ == Mode::single)
            for (const Ray& ray : rays_) keep(tracer_.nearest(ray));
        else
            for_each_tile(rays_, [&](std::span<const Ray> rays) {
                for (const std::optional<Hit>& hit : tracer_.nearest(rays)) keep(hit);
            });
    }
    Answers answers() const override { return answers_of(tracer_, rays_, mode_); }

private:
    void keep(const std::optional<Hit>& hit) {
        if (hit) sum_ += hit->t;
    }

    const Tracer& tracer_;
    std::span<const Ray> rays_;
    Mode mode_;
    double sum_ = 0; ///< so that no compiler drops the work
};

class CrossingPass final : public Pass {
public:
    CrossingPass(const Tracer& tracer, const RaySet& rays, Mode mode)
        : tracer_(tracer), rays_(rays.rays), mode_(mode) {}
    void run() override {
        if (mode_ == Mode::single)
            for (const Ray& ray : rays_) found_ += tracer_.nearest_crossings({&ray, 1}).size();
        else
            for_each_tile(rays_, [&](std::span<const Ray> rays) {
                found_ += tracer_.nearest_crossings(rays).size();
            });
    }

private:
    const Tracer& tracer_;
    std::span<const Ray> rays_;
    Mode mode_;
    std::size_t found_ = 0; ///< as KeikoPass::sum_
};

} // namespace

KeikoContender::KeikoContender(const SurfaceModel& model)
    : tracer_([&] {
          std::optional<Tracer> tracer;
          facts_.build_seconds =
              process_seconds([&] { tracer.emplace(model, TracerOptions{}, Job{.threads = 1}); });
          return std::move(*tracer);
      }()) {
    facts_.kind = Kind::keiko;
    facts_.name = "Keiko";
    facts_.elements = tracer_.statistics().sub_patches;
    facts_.bytes = tracer_.statistics().bytes;
}

std::unique_ptr<Pass> KeikoContender::pass(const RaySet& rays, Mode mode) const {
    return std::make_unique<KeikoPass>(tracer_, rays, mode);
}

CrossingContender::CrossingContender(const Tracer& tracer) : tracer_(tracer) {
    facts_.kind = Kind::crossings;
    facts_.name = "Keiko, t and uv only";
}

std::unique_ptr<Pass> CrossingContender::pass(const RaySet& rays, Mode mode) const {
    return std::make_unique<CrossingPass>(tracer_, rays, mode);
}

} // namespace keiko::bench
