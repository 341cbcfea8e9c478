#include "keiko/files/scene/scene_file.h"

#include "keiko/base/error.h"
#include "keiko/files/scene/material_file.h"
#include "keiko/files/scene/rig_file.h"
#include "keiko/scene/animation.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

namespace keiko {
namespace {
namespace fs = std::filesystem;

const std::string whole_plane =
    "[[c_plane]]\norigin = [0, 0, 2000]\nu = [1000, 0, 0]\nv = [0, 1200, 0]\n";

/// A folder with a scene, a rig and a model file, gone after the test.
class SceneFile : public testing::Test {
protected:
    SceneFile() {
        fs::create_directories(folder_ / "scenes");
        write("part.step", "x");
        write("rig.toml", "format = \"keiko-rig/1\"\nname = \"kept\"\n" + whole_plane);
    }
    ~SceneFile() override { fs::remove_all(folder_); }

    void write(const std::string& name, const std::string& text) const {
        std::ofstream(folder_ / name) << text;
    }
    SceneSpec scene(const std::string& body) const {
        return parse_scene("format = \"keiko-scene/1\"\n" + body,
                           (folder_ / "scenes/s.toml").string());
    }
    /// The message of the Error of a scene, from the line on.
    std::string error(const std::string& body) const {
        try {
            scene(body);
        } catch (const Error& e) {
            return e.where() + ": " + e.reason();
        }
        return "";
    }

    fs::path folder_ = fs::path(testing::TempDir()) /
                       testing::UnitTest::GetInstance()->current_test_info()->name();
};

const std::string model = "[[model]]\nfile = \"../part.step\"\n";

TEST_F(SceneFile, ReadsModelsCameraAndRig) {
    const SceneSpec read = scene(model + R"(material = "silver"
transform = { translate = [10, 0, 0], rotate = [0, 0, 1, 90], scale = 2 }
[[model]]
file = "../part.step"
material = { diffuse = [0.1, 0.2, 0.3], refractive_index = 1.4 }
[camera]
projection = "orthographic"
eye = [3000, -2500, 1400]
target = [0, 0, 600]
orthographic_height = 1500
size = [320, 200]
[rig]
file = "../rig.toml"
)");
    ASSERT_EQ(read.models.size(), 2u);
    EXPECT_EQ(read.models[0].file, folder_ / "part.step");
    EXPECT_EQ(read.models[0].material.name, "silver");
    // Scaled, then turned, then moved.
    EXPECT_LT((read.models[0].transform.affine().point({1, 0, 0}) - Vec3(10, 2, 0)).length(),
              1e-12);
    EXPECT_EQ(read.models[1].material.diffuse, Rgb(0.1, 0.2, 0.3));
    EXPECT_TRUE(read.models[1].transform.affine().is_identity());
    EXPECT_EQ(read.camera.value().projection, Projection::orthographic);
    EXPECT_EQ(read.camera->orthographic_height, 1500);
    EXPECT_EQ(read.camera->width, 320);
    EXPECT_EQ(read.height, 200);
    EXPECT_EQ(read.rig.value().name, "kept");
    EXPECT_FALSE(read.view);
}

TEST_F(SceneFile, DefaultsLeaveTheRigToPlacement) {
    const SceneSpec read =
        scene("view = \"high-front\"\nsize = [64, 36]\nbackground = 3\n" + model);
    EXPECT_EQ(read.view.value(), "high-front");
    EXPECT_EQ(read.width, 64);
    EXPECT_EQ(read.models[0].material.name, "black-show-car");
    EXPECT_FALSE(read.rig);
    EXPECT_FALSE(read.camera);
    EXPECT_EQ(read.background, Rgb(3));
}

TEST_F(SceneFile, LightsMayStandInTheScene) {
    const SceneSpec read = scene(model + whole_plane + "[fog]\nextinction = 0.1\n");
    EXPECT_EQ(read.rig.value().sources.size(), 1u);
    EXPECT_TRUE(read.rig->medium);
    EXPECT_EQ(error(model + whole_plane + "[rig]\nfile = \"../rig.toml\"\n"),
              "8:1: rig: give either [rig] or lights in the scene, not both");
}

TEST_F(SceneFile, OwnMaterialsTakeThePlaceOfTheStandardOnes) {
    write("paints.toml",
          "format = \"keiko-materials/1\"\n[[material]]\nname = \"gold\"\ndiffuse = 0.5\n");
    const std::string own = "materials = \"../paints.toml\"\n";
    EXPECT_EQ(scene(own + model).models[0].material.name, "gold");
    EXPECT_EQ(error(own + model + "material = \"silver\"\n"),
              "5:12: model[0].material: unknown material 'silver'; known are gold");
}

TEST_F(SceneFile, StandsOnAGroundOfConcreteOrOtherwise) {
    EXPECT_FALSE(scene(model).ground);
    const SceneSpec plain = scene(model + "[ground]\n");
    EXPECT_EQ(plain.ground.value().z, 0);
    EXPECT_EQ(plain.ground->material.name, "concrete");
    const SceneSpec white = scene(model + "[ground]\nz = -120\nmaterial = \"white\"\n");
    EXPECT_EQ(white.ground.value().z, -120);
    EXPECT_EQ(white.ground->material.name, "white");
}

TEST_F(SceneFile, MayLimitReflections) {
    EXPECT_FALSE(scene(model).max_depth);
    const SceneSpec read = scene("max_depth = 5\nmin_weight = 0.25\n" + model);
    EXPECT_EQ(read.max_depth, 5);
    EXPECT_FALSE(read.caustics);
    EXPECT_FALSE(read.radiosity);
    const RadiositySpec fine{.element = 300,
                             .smallest = 30,
                             .contrast = 0.1,
                             .deviation = 5,
                             .rays = 128,
                             .error = 0.001};
    EXPECT_EQ(scene(model + "[radiosity]\nelement = 300\nsmallest = 30\nrays = 128\n").radiosity,
              fine);
    const CausticSpec wanted{.detail = 99, .interfaces = 4, .min_weight = 0.05};
    EXPECT_EQ(scene(model + "[caustics]\ndetail = 99\n").caustics, wanted);
    EXPECT_EQ(read.min_weight, 0.25);
}

TEST_F(SceneFile, ErrorsNameTheirPlace) {
    EXPECT_EQ(error("[[model]]\nfile = \"gone.step\"\n"),
              "3:8: model[0].file: " + (folder_ / "scenes/gone.step").string() + ": no such file");
    EXPECT_EQ(error("[[model]]\nfile = \"m.bpt\\u0000.evil\"\n"),
              "3:8: model[0].file: \"m.bpt?.evil\" has a NUL character, written \\u0000");
    EXPECT_EQ(error(model + "[rig]\nfile = \"r.toml\\u0000\"\n"),
              "5:8: rig.file: \"r.toml?\" has a NUL character, written \\u0000");
    EXPECT_EQ(error("view = \"fornt\"\n" + model).substr(0, 60),
              "2:8: view: unknown view 'fornt' (did you mean 'front'?); vie");
    EXPECT_EQ(error(model + "[camera]\neye = [0, 0, 1]\ntarget = [0, 0, 1]\n"),
              "6:10: camera.target: must differ from eye");
    EXPECT_EQ(error(model + "[camera]\neye = [0, 0, 1]\ntarget = [0, 0, 0]\n"),
              "4:1: camera.up: must not be along the view direction");
    EXPECT_EQ(error(model + "[camera]\neye = [0, 1, 1]\ntarget = [0, 0, 0]\nsize = [9.5, 4]\n"),
              "7:8: camera.size: must be whole numbers");
    EXPECT_EQ(error(model + "[camera]\neye = [0, 1, 1]\ntarget = [0, 0, 0]\nfov = 20\n"),
              "7:1: unknown key 'camera.fov'");
    EXPECT_EQ(error(model + "axes = []\n"), "4:8: model[0].axes: is not supported yet");
    EXPECT_EQ(error(model + "override = [ { faces = [\"a*\", 3], material = \"chrome\" } ]\n"),
              "4:24: model[0].override[0].faces: must be an array of texts");
    EXPECT_EQ(error(model + "override = [ { faces = [] , material = \"chrome\" } ]\n"),
              "4:24: model[0].override[0].faces: must name at least one face");
    EXPECT_EQ(error(model + "override = [ { faces = [\"a\"], materal = \"chrome\" } ]\n"),
              "4:31: unknown key 'model[0].override[0].materal' (did you mean 'material'?)");
    EXPECT_EQ(error("[[model]]\nfiel = \"a.step\"\n"),
              "3:1: unknown key 'model[0].fiel' (did you mean 'file'?)");
    EXPECT_EQ(error(model + "override = [ { faces = [\"a\"], layer = \"x\" } ]\n"),
              "4:39: model[0].override[0].layer: is not supported yet");
    EXPECT_EQ(error(model + "[ground]\nheight = 0\n").substr(0, 34),
              "5:1: unknown key 'ground.height'");
    EXPECT_EQ(error(model + "[radiosity]\nrays = 33\n"),
              "5:8: radiosity.rays: must be at least 64 and at most 65536, is 33");
    EXPECT_EQ(error(model + "[radiosity]\nerror = 0\n"),
              "5:9: radiosity.error: must be at least 1e-06 and at most 0.5, is 0");
    EXPECT_EQ(error(model + "[caustics]\ndetail = 4\n"),
              "5:10: caustics.detail: must be at least 8 and at most 2048, is 4");
    EXPECT_EQ(error(model + "[caustics]\ninterfaces = 13\n"),
              "5:14: caustics.interfaces: must be at least 1 and at most 12, is 13");
    EXPECT_EQ(error(model + "[caustics]\nmin_weight = 0\n"),
              "5:14: caustics.min_weight: must be at least 0.001 and at most 1, is 0");
    EXPECT_EQ(error("max_depth = 65\n" + model),
              "2:13: max_depth: must be at least 0 and at most 64, is 65");
    EXPECT_EQ(error("view = \"top\"\n"),
              "1:1: the scene has no body: neither a [[model]] nor a [[primitive]] that is "
              "one nor a [[polygon]] with a map");
}

TEST_F(SceneFile, NumbersBeyondAllSenseAreRefused) {
    const std::string allowed = ": must be at least -1e+09 and at most 1e+09, is 1e+300";
    EXPECT_EQ(error(model + "transform = { translate = [0, 1e300, 0] }\n"),
              "4:27: model[0].transform.translate" + allowed);
    EXPECT_EQ(error(model + "transform = { rotate = [0, 0, 1, 1e300] }\n"),
              "4:24: model[0].transform.rotate" + allowed);
    EXPECT_EQ(
        error(model + "transform = { scale = 1e-300 }\n"),
        "4:23: model[0].transform.scale: must be at least 1e-06 and at most 1e+06, is 1e-300");
    EXPECT_EQ(error(model + "[camera]\neye = [0, 0, 1e300]\ntarget = [0, 0, 0]\n"),
              "5:7: camera.eye" + allowed);
    EXPECT_EQ(error(model + "[ground]\nz = 1e300\n"), "5:5: ground.z" + allowed);
    EXPECT_EQ(error("background = 1e300\n" + model),
              "2:14: background: must be at least 0 and at most 1e+15, is 1e+300");
}

TEST_F(SceneFile, ReadsWhatMovesAndNamesWhatCannot) {
    const std::string lamp = "[[spotlight]]\nposition = [0, 0, 9]\naim = [0, 0, 0]\n";
    const std::string moves = "[[animation]]\ntarget = \"spotlight.0.aim\"\n";
    const SceneSpec read =
        scene(model + lamp + moves + "keys = [[0, [0, 0, 0]], [8, [4, 0, 0]]]\n");
    EXPECT_EQ(std::get<Spotlight>(at_frame(read, 2).rig->sources[0]).aim, Vec3(1, 0, 0));
    EXPECT_EQ(error(model + moves + "keys = [[0, [0, 0, 0]]]\n"),
              "5:10: animation[0].target: the scene has no 'spotlight.0.aim' that moves");
    EXPECT_EQ(error(model + lamp + moves + "keys = [[3, [0, 0, 0]], [3, [1, 0, 0]]]\n"),
              "9:8: animation[0].keys: frames must ascend");
    EXPECT_EQ(error(model + "[[animation]]\ntarget = \"model.0.transform.rotate\"\n" +
                    "keys = [[0, [0, 0, 0, 5]]]\n"),
              "6:8: animation[0].keys: a value of 'model.0.transform.rotate' has no direction");
    EXPECT_EQ(error(model + lamp + moves + "keys = [1, 2]\n"),
              "9:8: animation[0].keys: must be an array of arrays [number, number or numbers]");
}

} // namespace
} // namespace keiko
