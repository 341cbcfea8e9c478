#include "keiko/visibility/query/occluders.h"

#include "tests/unit/render/caustic_stages.h"
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace keiko {

using namespace test;

/// A picture from above has the light of the beams, and shadow instead of what went straight on.
TEST(CausticPicture, HasTheLightOfTheBeamsAndNoOtherBehindGlass) {
    const CausticStage stage = ball_lens(sun_above());
    const Occluders occluders(stage.model, stage.tracer.without({true, false}));
    Camera camera;
    camera.projection = Projection::orthographic, camera.orthographic_height = 200;
    camera.eye = {0, -500, 400}, camera.target = {0, 0, 0}, camera.up = {0, 0, 1};
    camera.width = 80, camera.height = 80;
    const auto picture = [&](const std::optional<CausticSpec>& spec) {
        return render({stage.tracer, stage.materials, stage.rig, Rgb(0), &occluders, nullptr, spec},
                      camera, {.aovs = {Aov::illuminance}, .edge_samples = 1});
    };
    const Film without = picture({}), with = picture(spec_of(2));
    double brightest = 0, straight = 0;
    int compared = 0;
    for (int y = 0; y < 80; y += 2)
        for (int x = 0; x < 80; x += 2) {
            const Ray ray = camera.ray(x + 0.5, y + 0.5);
            const auto hit = stage.tracer.nearest(ray);
            if (!hit || hit->face != stage.floor()) continue;
            const double lit = with.aovs.at(Aov::illuminance).pixel(x, y)[0];
            const double rho = std::hypot(hit->position.x, hit->position.y);
            brightest = std::max(brightest, lit);
            if (rho < 0.9 * ball_radius)
                straight =
                    std::max<double>(straight, without.aovs.at(Aov::illuminance).pixel(x, y)[0]);
            // At a distance from the focus, and from the border of the shadow.
            if (rho < 30 || std::abs(rho / ball_radius - 1) < 0.1) continue;
            const double expected = under_ball(rho) + (rho > ball_radius ? lux : 0);
            EXPECT_NEAR(lit, expected, 0.01 * expected + 1) << rho;
            ++compared;
        }
    EXPECT_GT(compared, 500);
    EXPECT_LT(straight, 0.95 * lux);
    EXPECT_GT(straight, 0.3 * lux) << "glass dims, where no caustics are asked for";
    EXPECT_GT(brightest, 2 * lux);
}

} // namespace keiko
