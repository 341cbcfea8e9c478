#include "tests/bench/stripe_benchmark.h"

#include "keiko/film/image_file.h"
#include "keiko/film/tone_mapping.h"
#include "keiko/placement/best_view.h"

#include "tests/bench/cpu_clock.h"
#include "tests/bench/progress.h"
#include "tests/bench/scenes.h"
#include "tests/bench/stripe_methods.h"
#include <fmt/format.h>

#include <cmath>

namespace keiko::bench {
namespace {

constexpr int truth_cells = 32; ///< a side of a pixel: 1024 rays

/// A picture, what it cost and how far it is off.
struct Drawn {
    Film film{};
    double seconds = 0, all = 0, one_ray = 0; ///< errors: of all pixels, of those with one ray
};

template <class Draw>
Drawn drawn(const Draw& draw) {
    Drawn result;
    result.seconds = process_seconds([&] { result.film = draw(); });
    return result;
}

/// Seconds of supersampling at an error: by a straight line over logarithms between the two numbers
/// of rays around it, or beyond the last two.
double seconds_at(const std::vector<Drawn>& ladder, double error) {
    std::size_t k = 1;
    while (k + 1 < ladder.size() && ladder[k].all > error) ++k;
    const Drawn &a = ladder[k - 1], &b = ladder[k];
    const double t = std::log(error / a.all) / std::log(b.all / a.all);
    return a.seconds * std::pow(b.seconds / a.seconds, t);
}

Camera camera_of(const SurfaceModel& body, int width) {
    const Framing framing{.width = width, .height = width * 9 / 16};
    return best_view(Tracer(body), body, framing).camera;
}

std::string levels(double rms) {
    return fmt::format("{:.2f}", 255 * rms);
}

void write(const std::filesystem::path& folder, const std::string& name, const Film& film,
           double white) {
    if (folder.empty()) return;
    write_png(folder / (name + ".png"),
              tone_mapped(film, {.ev = std::log2(white / saturation_luminance(0))}));
}

void add(const StripeScene& scene, const std::filesystem::path& pictures, Table& table) {
    const Film truth = supersampled(scene, truth_cells, true);
    Drawn one = drawn([&] { return with_footprints(scene, 1); });
    Drawn adaptive = drawn([&] { return with_footprints(scene, 8); });
    const std::vector<bool> single = same_pixels(one.film, adaptive.film);
    const std::vector<bool> every(single.size(), true);
    const auto measure = [&](Drawn& picture) {
        picture.all = display_rms(picture.film, truth, every);
        picture.one_ray = display_rms(picture.film, truth, single);
    };
    measure(one), measure(adaptive);
    std::vector<Drawn> ladder;
    for (const int n : {1, 2, 3, 4, 6, 8, 12, 16}) {
        ladder.push_back(drawn([&] { return supersampled(scene, n, false); }));
        measure(ladder.back());
    }
    const double same_error = seconds_at(ladder, adaptive.all);
    const auto row = [&](const std::string& picture, const Drawn& d, const std::string& ratio) {
        table.rows.push_back(
            {scene.name, picture, levels(d.all), levels(d.one_ray), digits(d.seconds), ratio});
    };
    row("one ray", one, "");
    row("one ray, outlines split", adaptive, digits(same_error / adaptive.seconds));
    row("1 ray, no footprint", ladder[0], "");
    row("16 rays, no footprint", ladder[3], "");
    row("256 rays, no footprint", ladder.back(), "");
    const double white = white_luminance(truth);
    write(pictures, scene.name + "-truth", truth, white);
    write(pictures, scene.name + "-adaptive", adaptive.film, white);
    write(pictures, scene.name + "-one-sample", ladder[0].film, white);
}

} // namespace

Table run_stripe_benchmark(const StripeOptions& options) {
    Table table{
        .head = {"scene", "picture", "RMS levels", "at one-ray pixels", "s", "supersampling ×"},
        .left = 2};
    const auto names = options.scenes.empty() ? std::vector<std::string>{"hood", "car-front-fender"}
                                              : options.scenes;
    for (const SceneFile& file : chosen_scenes(names)) {
        if (!file.present()) {
            tell(file.name, "skipped, its file is not there");
            continue;
        }
        tell(file.name, "stripes");
        const SurfaceModel body = file.load();
        add(StripeScene(file.name, body, camera_of(body, options.width)), options.pictures, table);
    }
    return table;
}

} // namespace keiko::bench
