#include "keiko/volumes/read_voxels.h"

#include "keiko/base/error.h"
#include "keiko/film/image_file.h"

#include "tests/support/temporary_folder.h"
#include <gtest/gtest.h>

namespace keiko {
namespace {

using std::string_literals::operator""s;

VoxelFiles raw(const std::filesystem::path& path, VoxelFiles::Type type) {
    VoxelFiles files;
    files.header = "head.toml", files.raw = path, files.nodes = {2, 2, 2}, files.type = type;
    return files;
}

std::string refused(const VoxelFiles& files) {
    try {
        read_voxels(files, {}, {});
    } catch (const Error& error) {
        return error.what();
    }
    return "";
}

TEST(ReadVoxels, TakesWholeNumbersAsSharesOfTheLargest) {
    const test::TemporaryFolder folder;
    const auto bytes = folder.file("a.raw", "\x00\x33\x66\x99\xcc\xff\x00\xff"s);
    const VoxelGrid grid = read_voxels(raw(bytes, VoxelFiles::Type::uint8), {}, {});
    EXPECT_FALSE(grid.colored());
    for (int i = 0; i < 6; ++i)
        EXPECT_FLOAT_EQ(grid.values()[std::size_t(i)], 0.2F * static_cast<float>(i));
    EXPECT_EQ(grid.value(Vec3(1, 0, 1)), 1);
}

TEST(ReadVoxels, ReadsBytesInTheOrderThatTheHeaderStates) {
    const test::TemporaryFolder folder;
    std::string little, big;
    for (int i = 0; i < 8; ++i) little += "\xff\x00"s, big += "\x00\xff"s;
    VoxelFiles files = raw(folder.file("a.raw", little), VoxelFiles::Type::uint16);
    EXPECT_FLOAT_EQ(read_voxels(files, {}, {}).values()[3], 255.0F / 65535);
    files.raw = folder.file("b.raw", big), files.big_endian = true;
    EXPECT_FLOAT_EQ(read_voxels(files, {}, {}).values()[3], 255.0F / 65535);
    std::string floats;
    for (int i = 0; i < 8; ++i) floats += "\x00\x00\x20\xc0"s; // -2.5
    const auto path = folder.file("c.raw", floats);
    EXPECT_EQ(read_voxels(raw(path, VoxelFiles::Type::float32), {}, {}).values()[5], -2.5F);
}

TEST(ReadVoxels, TakesColoursByTheirLuminance) {
    const test::TemporaryFolder folder;
    std::string bytes;
    for (int i = 0; i < 8; ++i) bytes += "\xff\x00\x33"s;
    VoxelFiles files = raw(folder.file("a.raw", bytes), VoxelFiles::Type::uint8);
    files.channels = 3;
    const VoxelGrid grid = read_voxels(files, {}, {});
    ASSERT_TRUE(grid.colored());
    EXPECT_NEAR(grid.value(Vec3(0.5)), 0.2126 + 0.2 * 0.0722, 1e-7);
    EXPECT_NEAR(grid.color(Vec3(0.5)).b, 0.2, 1e-7);
}

/// Writes a slice of 3 x 2 pixels whose values rise along x, in steps of 51 levels from `first`.
std::filesystem::path slice(const test::TemporaryFolder& folder, const std::string& name,
                            float first, int channels = 1) {
    Image picture(3, 2, channels, 0);
    for (int y = 0; y < 2; ++y)
        for (int x = 0; x < 3; ++x) picture.pixel(x, y)[0] = first + 0.2F * static_cast<float>(x);
    write_png(folder.path() / name, picture);
    return folder.path() / name;
}

TEST(ReadVoxels, StacksSlices) {
    const test::TemporaryFolder folder;
    VoxelFiles files;
    files.slices = {slice(folder, "a.png", 0), slice(folder, "b.png", 0.4F)};
    const VoxelGrid grid = read_voxels(files, {}, {});
    EXPECT_EQ(grid.nodes(), (std::array{3, 2, 2}));
    EXPECT_NEAR(grid.value(Vec3(1, 0, 0)), 0.2, 1e-6);
    EXPECT_NEAR(grid.value(Vec3(2, 1, 1)), 0.8, 1e-6);
    EXPECT_NEAR(grid.value(Vec3(0, 0, 0.5)), 0.2, 1e-6);
}

TEST(ReadVoxels, AppliesFiltersInTheirOrder) {
    const test::TemporaryFolder folder;
    const auto bytes = folder.file("a.raw", "\x00\x00\x00\x00\x00\x00\x00\xff"s);
    const std::vector<VoxelFilter> filters{MedianFilter{1}};
    const VoxelGrid grid = read_voxels(raw(bytes, VoxelFiles::Type::uint8), filters, {});
    // The cube about the last node holds that node and its copies beyond the border: 8 of 27.
    EXPECT_EQ(grid.value(Vec3(1)), 0);
}

TEST(ReadVoxels, RefusesFilesThatAreNotAsTheirHeaderStates) {
    const test::TemporaryFolder folder;
    const auto seven = folder.file("seven.raw", "1234567");
    EXPECT_EQ(refused(raw(seven, VoxelFiles::Type::uint8)),
              seven.string() + ": has 7 bytes, but head.toml states 8");
    std::string floats;
    for (int i = 0; i < 8; ++i) floats += i == 5 ? "\x00\x00\xc0\x7f"s : "\x00\x00\x80\x3f"s;
    const auto nan = folder.file("nan.raw", floats);
    EXPECT_EQ(refused(raw(nan, VoxelFiles::Type::float32)),
              nan.string() + ": value 6 is not a finite number");
}

TEST(ReadVoxels, RefusesSlicesThatDiffer) {
    const test::TemporaryFolder folder;
    VoxelFiles files;
    const auto first = slice(folder, "a.png", 0), colored = slice(folder, "c.png", 0, 3);
    files.slices = {first, colored};
    EXPECT_EQ(refused(files), colored.string() + ": one slice is in colour, another is not");
    write_png(folder.path() / "d.png", Image(4, 2, 1, 0.5F));
    files.slices = {first, folder.path() / "d.png"};
    EXPECT_EQ(refused(files),
              files.slices[1].string() + ": has 4 x 2 pixels, the first slice 3 x 2");
    files.slices = {first, folder.file("e.png", "no picture")};
    EXPECT_NE(refused(files).find("e.png: is no picture of a kind that can be read"),
              std::string::npos);
}

} // namespace
} // namespace keiko
