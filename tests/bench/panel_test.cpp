#include "tests/bench/panel_methods.h"
#include "tests/bench/penumbra_picture.h"
#include <gtest/gtest.h>

#include <algorithm>

namespace keiko::bench {
namespace {

const PenumbraScene& sheet() {
    static const PenumbraScene scene("sheet", wavy_sheet(4, 4), 0.02, 1, 200);
    return scene;
}

TEST(PanelMethods, LinesAgreeWithSamples) {
    const std::vector<PolygonLight> panels = panels_behind(sheet());
    const Shares exact = by_lines(sheet(), panels, 1e-6);
    EXPECT_LT(rms(by_lines(sheet(), panels, 1e-3), exact), 1e-3);
    EXPECT_GT(rms(by_samples(sheet(), panels, 2), exact), 3e-3);
    EXPECT_LT(rms(by_samples(sheet(), panels, 48), exact), 1.5e-3);
    EXPECT_GT(*std::max_element(exact.values.begin(), exact.values.end()), 1);
}

TEST(PanelMethods, PictureAgreesWithPointsOneByOne) {
    PenumbraScene scene = sheet();
    const std::vector<PolygonLight> panels = panels_behind(scene);
    const PenumbraPicture picture(scene, 120, 100);
    LightRig rig;
    rig.sources.assign(panels.begin(), panels.end());
    const Shares exact = by_lines(scene, panels, 1e-6);
    EXPECT_LT(rms(picture.render(rig, mean_unhidden(scene, panels), 1e-4), exact), 2e-3);
}

} // namespace
} // namespace keiko::bench
