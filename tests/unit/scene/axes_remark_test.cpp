#include "keiko/scene/view.h"

#include <gtest/gtest.h>

namespace keiko {
namespace {

/// The teapot of 1975, x from handle to spout, standing on z = 0.
const Box3 teapot{{-3, -2, 0}, {3.525, 2, 3.15}};
/// A teapot with y up, as most OBJ files have it.
const Box3 upright{{-3, 0, -2}, {3.525, 3.15, 2}};

} // namespace

TEST(AxesRemark, SpeaksOfBodiesWhoseMiddlePlaneIsNotThatOfAVehicle) {
    const auto remark = axes_remark(upright);
    ASSERT_TRUE(remark);
    EXPECT_EQ(remark->entity, "axes");
    EXPECT_NE(remark->message.find("evenly about z = 0"), std::string::npos);
    EXPECT_NE(remark->message.find("axes x,-z,y"), std::string::npos);
    const auto cow = axes_remark({{-0.586, -0.759, -0.696}, {0.586, 0.984, 1.078}});
    ASSERT_TRUE(cow);
    EXPECT_NE(cow->message.find("evenly about x = 0"), std::string::npos);
    EXPECT_NE(cow->message.find("axes z,x,y"), std::string::npos);
}

TEST(AxesRemark, IsSilentOnBodiesInTheVehicleFrame) {
    EXPECT_FALSE(axes_remark(teapot));
    const Box3 hood{{-853.7, -797.17, 473.9}, {387.49, 797.17, 756.72}};
    const Box3 fender{{-709.06, -855.92, 147.23}, {458.37, -660.44, 866.75}};
    const Box3 half_deck{{2628.3, -1.5e-7, 814.64}, {2985.4, 616.5, 879.44}};
    const Box3 left_half{{-77.5, -77.5, 59}, {77.5, 1e-7, 202.29}};
    const Box3 front_wheel{{-300, 600, -300}, {300, 800, 300}}; // even about two planes
    for (const Box3& box : {hood, fender, half_deck, left_half, front_wheel})
        EXPECT_FALSE(axes_remark(box));
}

TEST(AxesRemark, IsSilentOnWhatHasNoExtent) {
    EXPECT_FALSE(axes_remark({}));
    EXPECT_FALSE(axes_remark({{1, 2, 0}, {3, 4, 0}}));
    EXPECT_FALSE(axes_remark({{0, 1, 0}, {0, 1, 0}}));
}

} // namespace keiko
