#include "keiko/render/linear_light.h"

#include "tests/support/random.h"
#include <gtest/gtest.h>

using namespace keiko;

namespace {

SpotLight random_light(test::Random& random) {
    const auto any = [&] { return test::uniform(random, 0, 1000); };
    return {Rgb(any(), any(), any()), Rgb(any(), any(), any()), any()};
}

int between(test::Random& random, int low, int high) {
    return low + static_cast<int>(test::pick(random, static_cast<std::size_t>(high - low + 1)));
}

void expect_alike(const SpotLight& a, const SpotLight& b) {
    constexpr double rounding = 1e-9;
    for (const double off : {a.illuminance.r - b.illuminance.r, a.illuminance.g - b.illuminance.g,
                             a.illuminance.b - b.illuminance.b, a.lobes.r - b.lobes.r,
                             a.lobes.g - b.lobes.g, a.lobes.b - b.lobes.b, a.incident - b.incident})
        EXPECT_NEAR(off, 0, rounding);
}

} // namespace

// Linear in x and in y: a part has the light of the whole everywhere, also where it is a pixel
// wide.
TEST(LinearLight, PartsHaveTheLightOfTheWhole) {
    test::Random random(21);
    for (int i = 0; i < 300; ++i) {
        LinearLight whole{{between(random, -20, 20), between(random, -20, 20), 0, 0}};
        whole.of.x1 = whole.of.x0 + between(random, 0, 16);
        whole.of.y1 = whole.of.y0 + between(random, 0, 16);
        for (SpotLight& corner : whole.corners) corner = random_light(random);
        Rectangle r{between(random, whole.of.x0, whole.of.x1),
                    between(random, whole.of.y0, whole.of.y1), 0, 0};
        r.x1 = between(random, r.x0, whole.of.x1);
        r.y1 = between(random, r.y0, whole.of.y1);
        const LinearLight part = whole.part(r);
        for (int y = r.y0; y <= r.y1; ++y)
            for (int x = r.x0; x <= r.x1; ++x) expect_alike(part.at({x, y}), whole.at({x, y}));
    }
}

TEST(LinearLight, CornersKeepTheirOwn) {
    test::Random random(22);
    LinearLight light{{3, 4, 11, 20}};
    for (SpotLight& corner : light.corners) corner = random_light(random);
    for (std::size_t i = 0; i < 4; ++i)
        expect_alike(light.at(light.of.corners()[i]), light.corners[i]);
    const SpotLight middle = light.at({7, 12});
    EXPECT_NEAR(middle.incident,
                (light.corners[0].incident + light.corners[1].incident + light.corners[2].incident +
                 light.corners[3].incident) /
                    4,
                1e-9);
}
