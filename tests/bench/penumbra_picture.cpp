#include "tests/bench/penumbra_picture.h"

#include "keiko/render/shading/picture.h"

#include "tests/bench/cpu_clock.h"
#include "tests/support/random.h"

#include <algorithm>

namespace keiko::bench {
namespace {

using namespace test;

const Job one_thread{.progress = {}, .stop = {}, .threads = 1};

Material matte() {
    Material material;
    material.diffuse = Rgb(0.8);
    material.refractive_index = 1;
    return material;
}

int random_below(Random& random, int count) {
    return std::min(static_cast<int>(uniform(random, 0, count)), count - 1);
}

std::size_t pixels_with_surface(const Film& film) {
    const auto& alpha = film.alpha.values;
    return static_cast<std::size_t>(
        std::count_if(alpha.begin(), alpha.end(), [](float share) { return share > 0; }));
}

} // namespace

PenumbraPicture::PenumbraPicture(PenumbraScene& scene, int width, std::size_t count)
    : scene_(scene), camera_(scene.camera) {
    camera_.width = width;
    camera_.height = width * 9 / 16;
    Random random(9);
    scene.receivers.clear();
    while (pixels_.size() < count) {
        const int x = random_below(random, camera_.width), y = random_below(random, camera_.height);
        const Ray ray = camera_.ray(x + 0.5, y + 0.5);
        const auto hit = scene.tracer.nearest(ray);
        if (!hit) continue;
        pixels_.push_back({x, y});
        scene.receivers.push_back(receiver_at(*hit, ray));
    }
}

Shares PenumbraPicture::render(Emitter emitter, double light_error) const {
    LightRig rig;
    CPlane row = scene_.row;
    row.luminance = Rgb(1);
    if (emitter == Emitter::axis) row.diffuse = TubeModel::line;
    rig.sources = {row};
    return render(rig, mean_unhidden(scene_, row, emitter), light_error);
}

Shares PenumbraPicture::render(const LightRig& rig, double mean, double light_error) const {
    const std::vector<Material> materials(scene_.faces, matte());
    const PictureScene scene{scene_.tracer, materials, rig, Rgb(0), &scene_.occluders};
    const PictureOptions options{
        .aovs = {Aov::illuminance}, .edge_samples = 1, .light_error = light_error};
    Film film;
    const double seconds =
        process_seconds([&] { film = keiko::render(scene, camera_, options, one_thread); });
    Shares shares;
    for (const auto& [x, y] : pixels_)
        shares.values.push_back(double(*film.aovs.at(Aov::illuminance).pixel(x, y)) / mean);
    shares.seconds = seconds * static_cast<double>(pixels_.size()) /
                     static_cast<double>(pixels_with_surface(film));
    return shares;
}

} // namespace keiko::bench
