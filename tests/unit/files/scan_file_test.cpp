#include "keiko/files/scan/scan_file.h"

#include "keiko/base/error.h"

#include "tests/support/temporary_folder.h"
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>
#include <utility>

namespace keiko {
namespace {

const std::vector<Vec3> corners{{0, 0, 0}, {1.5, 0, -2}, {0, 3, 0.25}, {1.5, 3, 8}};

template <class Number>
void append(std::string& bytes, Number number, bool reversed = false) {
    std::string one(sizeof number, '\0');
    std::memcpy(one.data(), &number, sizeof number);
    if (reversed) std::reverse(one.begin(), one.end());
    bytes += one;
}

/// Binary STL of the two triangles of `corners`.
std::string binary_stl() {
    std::string bytes = "solid as some binary files begin, too";
    bytes.resize(80, ' ');
    append(bytes, std::uint32_t{2});
    for (const auto& triangle : {std::array{0, 1, 2}, {1, 3, 2}}) {
        for (int k = 0; k < 3; ++k) append(bytes, 0.0f);
        for (const int corner : triangle)
            for (unsigned k = 0; k < 3; ++k)
                append(bytes, static_cast<float>(corners[static_cast<std::size_t>(corner)][k]));
        append(bytes, std::uint16_t{0});
    }
    return bytes;
}

const std::string ascii_stl = R"(solid part
 facet normal 0 0 1
  outer loop
   vertex 0 0 -0
   vertex 1.5 0 -2
   vertex 0 3 2.5e-1
  endloop
 endfacet
 facet normal 0 0 1
  outer loop
   vertex 1.5 0 -2
   vertex +1.5 3 8
   vertex 0 3 0.25
  endloop
 endfacet
endsolid part
)";

/// PLY with a list before the vertices, and properties between their coordinates.
std::string ply(const std::string& format) {
    return "ply\nformat " + format +
           " 1.0\ncomment by a test\nelement frame 1\nproperty list uchar int row\n"
           "element vertex 4\nproperty float x\nproperty uchar red\nproperty double y\n"
           "property short z\nelement face 0\nproperty list uchar int vertex_indices\nend_header\n";
}

std::string binary_ply(const std::string& format, bool reversed) {
    std::string bytes = ply(format);
    append(bytes, std::uint8_t{2});
    for (const int number : {7, 8}) append(bytes, number, reversed);
    for (const Vec3& corner : corners) {
        append(bytes, static_cast<float>(corner.x), reversed);
        append(bytes, std::uint8_t{200});
        append(bytes, corner.y, reversed);
        append(bytes, static_cast<std::int16_t>(corner.z), reversed);
    }
    return bytes;
}

std::vector<Vec3> points_of(const std::string& name, const std::string& content) {
    const test::TemporaryFolder folder;
    return read_scan(folder.file(name, content));
}

/// The message of the error for a file, without the folder.
std::string message_of(const std::string& name, const std::string& content) {
    const test::TemporaryFolder folder;
    try {
        read_scan(folder.file(name, content));
    } catch (const Error& error) {
        EXPECT_EQ(error.file(), (folder.path() / name).string());
        return error.where() + ": " + error.reason();
    }
    return "none";
}

TEST(ScanFile, ReadsStlWithEachCornerOnce) {
    EXPECT_EQ(points_of("a.stl", binary_stl()), corners);
    EXPECT_EQ(points_of("a.STL", ascii_stl), corners);
}

TEST(ScanFile, ReadsPlyInItsThreeEncodings) {
    std::vector<Vec3> whole = corners;
    whole[2].z = 0; // of a short
    EXPECT_EQ(points_of("a.ply", binary_ply("binary_little_endian", false)), whole);
    EXPECT_EQ(points_of("a.ply", binary_ply("binary_big_endian", true)), whole);
    EXPECT_EQ(points_of("a.ply", ply("ascii") + "2 7 8\n0 200 0 0\n1.5 200 0 -2\n0 200 3 0\n"
                                                "1.5 200 3 8\n"),
              whole);
}

TEST(ScanFile, ReadsColumnsBetweenAnySeparators) {
    EXPECT_EQ(points_of("a.xyz",
                        "4\n0 0 0\n1.5\t0 -2 255 0 0\n\n# a comment\n0,3,0.25\n"
                        "1.5;3;8 // the last\r\n"),
              corners);
    EXPECT_EQ(points_of("a.asc", "X Y Z\n0 0 0\n"), std::vector<Vec3>{Vec3(0)});
}

TEST(ScanFile, ScalesToMillimetres) {
    const test::TemporaryFolder folder;
    EXPECT_EQ(read_scan(folder.file("a.xyz", "1 2 3"), 25.4).front(), Vec3(25.4, 50.8, 3 * 25.4));
}

TEST(ScanFile, StatesWhatIsWrongWithAFile) {
    const std::string stl = binary_stl(), cut = stl.substr(0, stl.size() - 1);
    EXPECT_EQ(message_of("a.stl", cut),
              ": is no STL file, or cut short: 2 triangles need 184 bytes, and it has 183");
    EXPECT_EQ(message_of("a.stl", "nothing"),
              ": is no STL file: it neither begins with \"solid\" nor has 84 bytes");
    EXPECT_EQ(message_of("a.stl", ascii_stl.substr(0, 60)),
              ": is cut short: its end, \"endsolid\", is missing");
    EXPECT_EQ(message_of("a.stl", "solid\nvertex 1 2\nendsolid\n"),
              "2: a vertex has three numbers");
    EXPECT_EQ(message_of("a.ply", "obj\n"), "1: is no PLY file: \"ply\" is missing");
    EXPECT_EQ(message_of("a.ply", "ply\nformat binary 1.0\n"), "2: unknown format \"binary\"");
    EXPECT_EQ(message_of("a.ply", "ply\nelement vertex many\n"), "2: not a count: \"many\"");
    EXPECT_EQ(message_of("a.ply", "ply\nformat ascii 1.0\nelement face 0\nend_header\n"),
              ": has no element \"vertex\"");
    EXPECT_EQ(message_of("a.ply",
                         "ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\n"
                         "end_header\n1\n"),
              "element vertex: one property each of x, y and z is needed");
    for (const std::string format : {"binary_little_endian", "ascii"})
        EXPECT_EQ(message_of("a.ply", ply(format) + "1 "),
                  ": is cut short: it ends before its last vertex");
    EXPECT_EQ(message_of("a.xyz", "1 2 3\n4 5\n"), "2: a point has three numbers");
    EXPECT_EQ(message_of("a.xyz", "1 2 3\n4 5 six\n"), "2: not a number: \"six\"");
    EXPECT_EQ(message_of("a.xyz", "# empty\n"), ": holds no points");
    EXPECT_EQ(message_of("a.xyz", "1 2 3\n1 nan 3\n"),
              "point 2: a coordinate must be from -1e9 to 1e9");
    EXPECT_EQ(message_of("a.obj", "v 1 2 3\n"), ": is no scan: .stl, .ply, .asc or .xyz is needed");
}

TEST(ScanFile, BelievesNoCountThatTheFileCannotHold) {
    EXPECT_EQ(message_of("a.ply",
                         "ply\nformat ascii 1.0\nelement vertex 99999999999\n"
                         "property float x\nproperty float y\nproperty float z\n"
                         "end_header\n1 2 3\n"),
              ": is cut short: it ends before its last vertex");
    EXPECT_EQ(points_of("a.ply",
                        "ply\nformat ascii 1.0\nelement nothing 99999999999999\n"
                        "element vertex 1\nproperty float x\nproperty float y\n"
                        "property float z\nend_header\n1 2 3\n"),
              std::vector<Vec3>{Vec3(1, 2, 3)});
}

} // namespace
} // namespace keiko
