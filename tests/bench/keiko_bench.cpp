#include "keiko/io/load_model.h"

#include "tests/bench/ray_classes.h"
#include "tests/integration/opencascade_tracer.h"
#include "tests/support/paths.h"

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <exception>
#include <functional>

// Rays through Keiko and through OpenCASCADE, one thread each, in interleaved rounds of the same
// run: the ratio of the two holds where seconds do not.

namespace {

using namespace keiko;

constexpr int rounds = 5;
constexpr std::size_t peer_rays = 2000; // OpenCASCADE is about a thousand times slower

double seconds(const std::function<void()>& work) {
    const auto begin = std::chrono::steady_clock::now();
    work();
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}

double median(std::vector<double> values) {
    std::nth_element(values.begin(), values.begin() + rounds / 2, values.end());
    return values[rounds / 2];
}

/// Every n-th ray, so that the peer's share is as varied as the whole.
std::vector<Ray> thinned(const std::vector<Ray>& rays) {
    std::vector<Ray> some;
    const std::size_t step = std::max<std::size_t>(1, rays.size() / peer_rays);
    for (std::size_t i = 0; i < rays.size(); i += step) some.push_back(rays[i]);
    return some;
}

void compare(const bench::RayClass& rays, const Tracer& tracer, test::OpenCascadeTracer& peer) {
    const std::vector<Ray> some = thinned(rays.rays);
    std::vector<double> rates, ratios;
    for (int round = 0; round < rounds; ++round) {
        const double ours = seconds([&] { tracer.nearest(rays.rays); });
        const double theirs = seconds([&] {
            for (const Ray& ray : some) peer.all(ray);
        });
        rates.push_back(static_cast<double>(rays.rays.size()) / ours);
        ratios.push_back(rates.back() * theirs / static_cast<double>(some.size()));
    }
    std::printf("  %-9s %8zu rays  %9.0f rays/s  %6.0f x OpenCASCADE\n", rays.name.c_str(),
                rays.rays.size(), median(rates), median(ratios));
}

void measure(const std::filesystem::path& file) {
    const SurfaceModel model = load_model(file);
    const Tracer tracer(model, {.second_derivatives = true});
    const TracerStatistics& built = tracer.statistics();
    std::printf("%s: %zu patches, %zu leaves (%zu mixed), %.1f MB, built in %.0f ms\n",
                file.filename().c_str(), model.patches.size(), built.leaves, built.leaves_mixed,
                static_cast<double>(built.bytes) / 1e6, 1e3 * built.build_seconds);
    test::OpenCascadeTracer peer(file);
    for (const bench::RayClass& rays : bench::ray_classes(model, tracer))
        compare(rays, tracer, peer);
}

} // namespace

int main(int argc, char** argv) {
    std::vector<std::filesystem::path> files(argv + 1, argv + argc);
    if (files.empty())
        for (const char* name : {"concept-car.step", "hood.step", "trimmed-island.step"})
            files.push_back(test::repository("surfaces") / name);
    try {
        for (const auto& file : files) measure(file);
    } catch (const std::exception& error) {
        std::fprintf(stderr, "keiko_bench: %s\n", error.what());
        return 2;
    }
    return 0;
}
