#include "keiko/base/error.h"
#include "keiko/files/scene/scene_file.h"
#include "keiko/files/scene/voxel_header.h"

#include "tests/support/temporary_folder.h"
#include <gtest/gtest.h>

#include <string>

namespace keiko {
namespace {

/// Parses scenes beside voxels and a model, which are not read.
class Scenes {
public:
    Scenes() {
        folder_.file("body.step", "body");
        folder_.file("a.raw", "12345678");
        folder_.file("a.png", "picture"), folder_.file("b.png", "picture");
        folder_.file("voxels.toml",
                     header("raw = \"a.raw\"\nnodes = [2, 2, 2]\ntype = \"uint8\"\n"));
    }
    static std::string header(const std::string& body) {
        return "format = \"keiko-voxels/1\"\nspacing = [1, 2, 4]\n" + body;
    }
    SceneSpec read(const std::string& keys, const std::string& after = "") const {
        return parse_scene("format = \"keiko-scene/1\"\n[[volume]]\nfile = \"voxels.toml\"\n" +
                               keys + "\n[[model]]\nfile = \"body.step\"\n" + after,
                           (folder_.path() / "scene.toml").string());
    }
    std::string refused(const std::string& keys, const std::string& after = "") const {
        return told([&] { read(keys, after); });
    }
    VoxelFiles voxels(const std::string& body) const {
        return parse_voxel_header(header(body), (folder_.path() / "voxels.toml").string());
    }
    std::string refused_voxels(const std::string& body) const {
        return told([&] { voxels(body); });
    }

private:
    /// The message of a refusal, from the name of the file on.
    template <class Read>
    std::string told(const Read& read) const {
        try {
            read();
        } catch (const Error& error) {
            const std::string text = error.what();
            return text.substr(folder_.path().string().size() + 1);
        }
        return "";
    }

    test::TemporaryFolder folder_;
};

TEST(VolumeTable, ReadsEveryKey) {
    const SceneSpec scene = Scenes().read(R"(
transform = { scale = 2, translate = [1, 2, 3] }
filter = [{ kind = "median", radius = 2 }, { kind = "gauss", width = 0.5 }]
extinction = [[0.25, 0], [0.5, 300]]
contour = [{ value = 0.5, thickness = 3, opacity = 0.25 }]
region = [{ low = 0.1, high = 0.2, opacity_low = 1, opacity_high = 2 }]
color = [[0, 0.5], [1, [0.1, 0.2, 0.3]]]
emits = [[0, 7]]
shading = { light = [0, 0, 2], luminance = 5, ambient = 1, diffuse = 2, specular = 3, exponent = 4, depth_cue = [5, 6] }
scattering = { albedo = 0.5, phase = { kind = "fog", k = 8 }, light_leg = "uniform" }
step = 0.75
)");
    ASSERT_EQ(scene.volumes.size(), 1U);
    const VolumeSpec& volume = scene.volumes.front();
    EXPECT_EQ(volume.voxels.raw.filename(), "a.raw");
    EXPECT_EQ(volume.voxels.spacing, Vec3(1, 2, 4));
    EXPECT_EQ(volume.placement.point(Vec3(1, 1, 1)), Vec3(3, 4, 5));
    EXPECT_EQ(volume.filters, (std::vector<VoxelFilter>{MedianFilter{2}, GaussFilter{0.5}}));
    EXPECT_EQ(volume.extinction(0.5), 300);
    EXPECT_EQ(volume.contours,
              (std::vector<ContourOpacity>{{.value = 0.5, .thickness = 3, .opacity = 0.25}}));
    EXPECT_EQ(volume.regions, (std::vector<RegionOpacity>{
                                  {.low = 0.1, .high = 0.2, .opacity_low = 1, .opacity_high = 2}}));
    EXPECT_EQ(volume.color(0), Rgb(0.5));
    EXPECT_EQ(volume.color(2), Rgb(0.1, 0.2, 0.3));
    EXPECT_EQ(volume.emits(0.3), Rgb(7));
    EXPECT_EQ(volume.shading, (VolumeShading{.light = Vec3(0, 0, 2),
                                             .luminance = 5,
                                             .ambient = 1,
                                             .diffuse = 2,
                                             .specular = 3,
                                             .exponent = 4,
                                             .cue = 5,
                                             .cue_per_length = 6}));
    EXPECT_EQ(volume.scattering,
              (VolumeScattering{.albedo = Rgb(0.5), .phase = HazePhase{8}, .uniform_leg = true}));
    EXPECT_EQ(volume.step, 0.75);
}

TEST(VolumeTable, ShadesUnlessItEmitsOrScatters) {
    const Scenes scenes;
    const std::string opaque = "extinction = [[0, 1]]\n";
    EXPECT_TRUE(scenes.read(opaque).volumes.front().shading);
    EXPECT_FALSE(scenes.read(opaque + "emits = [[0, 1]]\n").volumes.front().shading);
    EXPECT_FALSE(scenes.read(opaque + "scattering = {}\n").volumes.front().shading);
}

TEST(VolumeTable, RefusesWhatCannotBe) {
    const Scenes scenes;
    EXPECT_EQ(scenes.refused(""),
              "scene.toml:2:1: volume[0]: nothing makes it opaque: give "
              "extinction, contour or region");
    EXPECT_EQ(scenes.refused("contor = [{ value = 1 }]"),
              "scene.toml:4:1: unknown key 'volume[0].contor' (did you mean 'contour'?)");
    EXPECT_EQ(scenes.refused("extinction = [[1, 0], [0, 1]]"),
              "scene.toml:4:14: volume[0].extinction: values must ascend");
    EXPECT_EQ(scenes.refused("extinction = [[1, -3]]"),
              "scene.toml:4:14: volume[0].extinction: must be at least 0 and at most 1e+09, is -3");
    EXPECT_EQ(scenes.refused("extinction = [[1, [3, 3, 3]]]"),
              "scene.toml:4:14: volume[0].extinction: each value needs one number");
    const std::string contour = "contour = [{ value = 0.5 }]\n";
    EXPECT_EQ(scenes.refused(contour + "color = [[0, [1, 1]]]"),
              "scene.toml:5:9: volume[0].color: each value needs one number or three");
    EXPECT_EQ(scenes.refused(contour + "region = [{ low = 1, high = 1 }]"),
              "scene.toml:5:29: volume[0].region[0].high: must be above low");
    EXPECT_EQ(scenes.refused(contour + "filter = [{ kind = \"gauss\", radius = 1 }]"),
              "scene.toml:5:38: volume[0].filter[0].radius: belongs to kind = \"median\"");
    EXPECT_EQ(scenes.refused(contour + "shading = { light = [0, 0, 0] }"),
              "scene.toml:5:21: volume[0].shading.light: must not be a zero vector");
    EXPECT_EQ(scenes.refused(contour + "shading = { depth_cue = [0, 1] }"),
              "scene.toml:5:25: volume[0].shading.depth_cue: the first number must be above 0");
    EXPECT_EQ(scenes.refused(contour + "step = 0.009"),
              "scene.toml:5:8: volume[0].step: must be at least a hundredth of the spacing of the "
              "voxels");
    EXPECT_EQ(scenes.refused(contour, "[fog]\nextinction = 0.1\n"),
              "scene.toml:2:1: volume: stands in no fog: give either [[volume]] or [fog]");
}

TEST(VoxelHeader, ReadsEveryKey) {
    const Scenes scenes;
    const VoxelFiles raw = scenes.voxels(
        "raw = \"a.raw\"\nnodes = [2, 3, 4]\ntype = \"uint16\"\nchannels = \"rgb\"\n"
        "byte_order = \"big\"\norigin = [7, 8, 9]\n");
    EXPECT_EQ(raw.raw.filename(), "a.raw");
    EXPECT_EQ(raw.nodes, (std::array{2, 3, 4}));
    EXPECT_EQ(raw.type, VoxelFiles::Type::uint16);
    EXPECT_EQ(raw.channels, 3);
    EXPECT_TRUE(raw.big_endian);
    EXPECT_EQ(raw.origin, Vec3(7, 8, 9));
    const VoxelFiles slices = scenes.voxels("slices = [\"a.png\", \"b.png\"]\n");
    ASSERT_EQ(slices.slices.size(), 2U);
    EXPECT_EQ(slices.slices[1].filename(), "b.png");
    EXPECT_TRUE(slices.raw.empty());
}

TEST(VoxelHeader, RefusesWhatCannotBe) {
    const Scenes scenes;
    const std::string raw = "raw = \"a.raw\"\ntype = \"uint8\"\n";
    EXPECT_EQ(scenes.refused_voxels(""), "voxels.toml:1:1: 'slices' is missing");
    EXPECT_EQ(scenes.refused_voxels(raw + "nodes = [1, 2, 2]\n"),
              "voxels.toml:5:9: nodes: must be at least 2 and at most 2048, is 1");
    EXPECT_EQ(scenes.refused_voxels(raw + "nodes = [2.5, 2, 2]\n"),
              "voxels.toml:5:9: nodes: must be whole numbers");
    EXPECT_EQ(scenes.refused_voxels(raw + "nodes = [2048, 2048, 2048]\n"),
              "voxels.toml:5:9: nodes: are more than 1024^3 in all");
    EXPECT_EQ(scenes.refused_voxels("slices = [\"a.png\"]\n"),
              "voxels.toml:3:10: slices: must be 2 to 2048 pictures");
    EXPECT_EQ(scenes.refused_voxels("slices = [\"a.png\", \"b.png\"]\nnodes = [2, 2, 2]\n"),
              "voxels.toml:4:9: nodes: belongs to raw files: slices state their own");
    EXPECT_EQ(scenes.refused_voxels(raw + "slices = [\"a.png\"]\n"),
              "voxels.toml:5:10: slices: give either raw or slices, not both");
    EXPECT_EQ(scenes.refused_voxels("raw = \"no.raw\"\n").find("voxels.toml:3:7: raw: "), 0U);
}

} // namespace
} // namespace keiko
