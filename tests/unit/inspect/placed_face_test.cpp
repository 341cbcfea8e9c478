#include "keiko/inspect/basics/placed_face.h"

#include <gtest/gtest.h>

namespace keiko {
namespace {

SurfaceModel with_instances(const std::vector<std::string>& names) {
    SurfaceModel model;
    model.faces.resize(1);
    model.faces[0].id = 12;
    for (const std::string& name : names) model.instances.push_back({0, name, {}});
    return model;
}

TEST(FaceNames, TellTheInstanceOnlyWhereThereAreSeveral) {
    EXPECT_EQ(placed_face_name(with_instances({"hood"}), 0, 0), "face 12");
    EXPECT_EQ(placed_face_name(with_instances({"hood", "roof"}), 1, 0), "face 12 of roof");
}

TEST(FaceNames, TellInstancesOfOneNameApart) {
    const SurfaceModel model = with_instances({"nut", "bolt", "nut", ""});
    EXPECT_EQ(placed_face_name(model, 0, 0), "face 12 of nut, instance 1");
    EXPECT_EQ(placed_face_name(model, 1, 0), "face 12 of bolt");
    EXPECT_EQ(placed_face_name(model, 2, 0), "face 12 of nut, instance 3");
    EXPECT_EQ(placed_face_name(model, 3, 0), "face 12 of instance 4");
}

} // namespace
} // namespace keiko
