#include "tests/bench/zebra_view.h"

#include "keiko/film/tone_mapping.h"
#include "keiko/light/tubes/c_plane_lookup.h"

#include <algorithm>

namespace keiko::bench {
namespace {

constexpr int cells = 4; ///< a side of a pixel, samples
constexpr double dark = 0.02, beside = 0.35;

/// Linear value of one sample.
double seen(const Ray& ray, const std::optional<Answer>& answer, const CPlaneFrame& lamps) {
    if (!answer) return beside;
    const Vec3 mirrored = reflect(ray.direction, answer->normal);
    return std::max(dark,
                    look_up(lamps, ray.at(answer->t), mirrored, {}, MirrorModel::flat).coverage);
}

RaySet rays_of_row(const Camera& camera, int y) {
    RaySet set{.name = "picture"};
    for (int x = 0; x < camera.width; ++x)
        for (int i = 0; i < cells * cells; ++i)
            set.rays.push_back(
                camera.ray(x + (i % cells + 0.5) / cells, y + (i / cells + 0.5) / cells));
    return set;
}

} // namespace

Image zebra_view(const Contender& contender, const Camera& camera, const CPlane& lamps) {
    const CPlaneFrame frame(lamps);
    Image image(camera.width, camera.height, 3);
    for (int y = 0; y < camera.height; ++y) {
        const RaySet set = rays_of_row(camera, y);
        const auto pass = contender.pass(set, Mode::single);
        pass->run();
        const Answers answers = pass->answers();
        for (std::size_t i = 0; i < answers.size(); i += cells * cells) {
            double sum = 0;
            for (std::size_t k = i; k < i + cells * cells; ++k)
                sum += seen(set.rays[k], answers[k], frame);
            const auto value = static_cast<float>(srgb_oetf(sum / (cells * cells)));
            std::fill_n(image.pixel(static_cast<int>(i / (cells * cells)), y), 3, value);
        }
    }
    return image;
}

} // namespace keiko::bench
