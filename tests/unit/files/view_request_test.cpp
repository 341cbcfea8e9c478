#include "keiko/files/scene/view_request.h"

#include "keiko/base/error.h"
#include "keiko/files/scene/rig_file.h"

#include "tests/support/temporary_folder.h"
#include <gtest/gtest.h>

#include <functional>

namespace keiko {
namespace {

const std::string row =
    "[[c_plane]]\norigin = [0, 0, 2000]\nu = [1000, 0, 0]\nv = [0, 1200, 0]\nlamps = 7\n";

std::string reason_of(const std::function<void()>& parse) {
    try {
        parse();
    } catch (const Error& error) {
        return error.what();
    }
    return "none";
}

void expect_refused(const std::string& text, const std::string& word) {
    const std::string reason = reason_of([&] { parse_view_request(text); });
    EXPECT_NE(reason.find(word), std::string::npos) << reason;
    EXPECT_EQ(reason.find("request"), 0u) << reason;
}

CPlane lamps(int count) {
    CPlane plane;
    plane.lamps = count;
    return plane;
}

int lamps_of(const LightSource& source) {
    return std::get<CPlane>(source).lamps;
}

} // namespace

TEST(ViewRequest, OfAnEmptyTextIsTheViewThatWasOpened) {
    const ViewRequest request = parse_view_request("");
    EXPECT_FALSE(request.camera);
    EXPECT_FALSE(request.planes);
    EXPECT_TRUE(request.interlaced);
    EXPECT_EQ(request.reflections, 3);
}

TEST(ViewRequest, HoldsACameraWithItsSizeAndRowsOfLamps) {
    const ViewRequest request = parse_view_request(
        "format = \"keiko-view-request/1\"\ninterlaced = false\nreflections = 2\n"
        "[camera]\neye = [1, 2, 3]\ntarget = [0, 0, 0]\nsize = [30, 20]\n" +
        row + row);
    ASSERT_TRUE(request.camera);
    EXPECT_EQ(request.camera->eye, Vec3(1, 2, 3));
    EXPECT_EQ(request.camera->width, 30);
    EXPECT_EQ(request.camera->height, 20);
    ASSERT_TRUE(request.planes);
    EXPECT_EQ(request.planes->size(), 2u);
    EXPECT_EQ(request.planes->front().lamps, 7);
    EXPECT_FALSE(request.interlaced);
    EXPECT_EQ(request.reflections, 2);
}

TEST(ViewRequest, OfNoPlanesIsDark) {
    const ViewRequest request = parse_view_request("c_plane = []\n");
    ASSERT_TRUE(request.planes);
    EXPECT_TRUE(request.planes->empty());
}

TEST(ViewRequest, IsRefusedWithAReason) {
    expect_refused("eye = [0, 0, 1]\n", "eye");
    expect_refused("reflections = 9\n", "reflections");
    expect_refused("format = \"keiko-scene/1\"\n", "keiko-scene/1");
    expect_refused("[camera]\neye = [0, 0, 0]\ntarget = [0, 0, 0]\n", "target");
    expect_refused("[camera]\neye = [0, 0, 1]\ntarget = [0, 0, 0]\nup = [0, 1, 0]\nsize = [0, 1]\n",
                   "size");
    expect_refused("[camera]\neye = [nan, 0, 1]\ntarget = [0, 0, 0]\n", "eye");
}

TEST(RigFromElsewhere, MayNameNoFileThatIsThereOrNot) {
    const test::TemporaryFolder folder;
    const std::string file = folder.file("secret.ies", "IESNA").string();
    for (const std::string& name : {file, std::string("/none.ies")}) {
        const std::string rig =
            "format = \"keiko-rig/1\"\n[[luminaire]]\nposition = [0, 0, 1]\n"
            "file = \"" +
            name + "\"\n";
        const std::string reason = reason_of([&] { parse_rig_alone(rig, "rig"); });
        EXPECT_EQ(reason, "rig:4:8: luminaire[0].file: may not name a file here");
    }
    EXPECT_EQ(parse_rig_alone("format = \"keiko-rig/1\"\n" + row, "rig").sources.size(), 1u);
}

TEST(WithPlanes, ReplacesRowsAndLeavesOtherLights) {
    LightRig rig;
    rig.sources = {lamps(1), Spotlight{}, lamps(2)};
    rig.ambient = Rgb(5);
    const LightRig more = with_planes(rig, {lamps(10), lamps(20), lamps(30)});
    ASSERT_EQ(more.sources.size(), 4u);
    EXPECT_EQ(lamps_of(more.sources[0]), 10);
    EXPECT_TRUE(std::holds_alternative<Spotlight>(more.sources[1]));
    EXPECT_EQ(lamps_of(more.sources[2]), 20);
    EXPECT_EQ(lamps_of(more.sources[3]), 30);
    EXPECT_EQ(more.ambient, Rgb(5));
    const LightRig fewer = with_planes(rig, {lamps(10)});
    ASSERT_EQ(fewer.sources.size(), 2u);
    EXPECT_EQ(lamps_of(fewer.sources[0]), 10);
}

TEST(ViewRequest, MayNameAPixelAndAnExposure) {
    EXPECT_FALSE(parse_view_request("").pixel);
    EXPECT_FALSE(parse_view_request("").ev);
    const ViewRequest wanted = parse_view_request("pixel = [3.5, 7]\nev = -2.5");
    ASSERT_TRUE(wanted.pixel && wanted.ev);
    EXPECT_EQ(wanted.pixel->x, 3.5);
    EXPECT_EQ(wanted.pixel->y, 7);
    EXPECT_EQ(*wanted.ev, -2.5);
    for (const char* wrong : {"pixel = [1]", "pixel = [1, -1]", "pixel = [1, nan]", "pixel = 3"})
        expect_refused(wrong, "pixel");
    for (const char* wrong : {"ev = 101", "ev = -inf", "ev = \"auto\""})
        expect_refused(wrong, "ev");
}

TEST(ViewRequest, HidesFacesByWholeNumbersInAnyOrder) {
    EXPECT_TRUE(parse_view_request("").hidden.empty());
    EXPECT_EQ(parse_view_request("hidden = [7, 3]").hidden, (std::vector<std::uint32_t>{3, 7}));
    for (const char* wrong : {"hidden = [0]", "hidden = [1.5]", "hidden = [-1]", "hidden = [5e9]",
                              "hidden = 3", "hidden = [\"hood\"]", "hidden = []"})
        expect_refused(wrong, "hidden");
}

} // namespace keiko
