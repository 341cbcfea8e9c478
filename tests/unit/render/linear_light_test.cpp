#include "keiko/render/linear_light.h"

#include "tests/support/random.h"
#include <gtest/gtest.h>

using namespace keiko;

namespace {

SpotLight random_light(test::Random& random) {
    const auto any = [&] { return test::uniform(random, 0, 1000); };
    return {Rgb(any(), any(), any()), Rgb(any(), any(), any()), any()};
}

void expect_alike(const SpotLight& a, const SpotLight& b) {
    constexpr double rounding = 1e-9;
    for (const double off : {a.illuminance.r - b.illuminance.r, a.illuminance.g - b.illuminance.g,
                             a.illuminance.b - b.illuminance.b, a.lobes.r - b.lobes.r,
                             a.lobes.g - b.lobes.g, a.lobes.b - b.lobes.b, a.incident - b.incident})
        EXPECT_NEAR(off, 0, rounding);
}

} // namespace

// Linear in x and in y: what is linear between the corners of a part is that of the whole.
TEST(LinearLight, PartsHaveTheLightOfTheWhole) {
    test::Random random(21);
    const auto share = [&] { return test::uniform(random, 0, 1); };
    for (int i = 0; i < 300; ++i) {
        LinearLight whole, part;
        for (SpotLight& corner : whole.corners) corner = random_light(random);
        const Vec2 from(share(), share()), size(share(), share());
        for (std::size_t corner = 0; corner < 4; ++corner)
            part.corners[corner] =
                whole.at(from + size * Vec2(corner % 2 ? 1 : 0, corner / 2 ? 1 : 0));
        const Vec2 at(share(), share());
        expect_alike(part.at(at), whole.at(from + size * at));
    }
}

TEST(LinearLight, CornersKeepTheirOwn) {
    test::Random random(22);
    LinearLight light;
    for (SpotLight& corner : light.corners) corner = random_light(random);
    double sum = 0;
    for (std::size_t i = 0; i < 4; ++i) {
        expect_alike(light.at(Vec2(i % 2 ? 1 : 0, i / 2 ? 1 : 0)), light.corners[i]);
        sum += light.corners[i].incident;
    }
    EXPECT_NEAR(light.at(Vec2(0.5)).incident, sum / 4, 1e-9);
}
