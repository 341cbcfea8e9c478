#include "keiko/viewer/endpoints.h"

#include "tests/unit/viewer/hood.h"
#include <gtest/gtest.h>

namespace keiko::viewer {
namespace {

/// A client that keeps what it is sent, and goes after some of it.
class Reader : public Outlet {
public:
    explicit Reader(std::size_t most = static_cast<std::size_t>(-1)) : most_(most) {}
    bool write(std::string_view bytes) override {
        text += bytes;
        return is_open();
    }
    bool is_open() const override { return text.size() < most_; }

    std::string text;

private:
    std::size_t most_;
};

/// One server without a socket for all tests: the hood under a row of lamps.
class EndpointsTest : public testing::Test {
protected:
    HttpReply ask(const std::string& method, const std::string& path, std::string body = "",
                  const std::string& client = "a") const {
        return endpoints_.answer({method, path, {{"x-keiko-client", client}}, std::move(body)});
    }

    const std::unique_ptr<ViewedScene> scene_ = test::viewed_hood();
    LatestWork work_;
    const Endpoints endpoints_{*scene_, work_, 0};
};

bool has(const HttpReply& reply, const std::string& text) {
    return reply.body.find(text) != std::string::npos;
}

} // namespace

TEST_F(EndpointsTest, AnswersTheSceneAndTheRigAtOnce) {
    EXPECT_TRUE(has(ask("GET", "/scene"), "keiko-view-facts/1"));
    const HttpReply rig = ask("GET", "/rig");
    EXPECT_EQ(rig.type, "application/toml");
    EXPECT_TRUE(has(rig, "c_plane"));
}

TEST_F(EndpointsTest, KnowsNoOtherPathsAndNoOtherMethodsOfThem) {
    for (const char* method : {"GET", "POST", "PUT"})
        EXPECT_EQ(ask(method, "/nothing").status, 404);
    EXPECT_EQ(ask("POST", "/scene").status, 404);
    EXPECT_EQ(ask("GET", "/deep").status, 404);
    EXPECT_EQ(ask("GET", "").status, 404);
}

TEST_F(EndpointsTest, ErrorsOfTheRequestAreAnswersWithTheirReason) {
    const HttpReply wrong = ask("POST", "/deep", "reflections = 9");
    EXPECT_EQ(wrong.status, 400);
    EXPECT_TRUE(has(wrong, "reflections"));
    EXPECT_EQ(ask("PUT", "/rig", "no toml").status, 400);
    EXPECT_EQ(scene_->rig().sources.size(), 1u);
}

TEST_F(EndpointsTest, ANameOfAClientIsPlainAndShort) {
    EXPECT_EQ(ask("GET", "/scene", "", "page-0-A").status, 200);
    EXPECT_EQ(ask("GET", "/scene", "", std::string(64, 'a')).status, 200);
    for (const std::string& name : {std::string(65, 'a'), std::string("a b"), std::string("ä")})
        EXPECT_EQ(ask("GET", "/scene", "", name).status, 400) << name;
}

TEST_F(EndpointsTest, TheDeepBufferComesInFourMessagesOrOne) {
    Reader whole, rows;
    ASSERT_TRUE(ask("POST", "/deep", "interlaced = false").stream(whole));
    ASSERT_TRUE(ask("POST", "/deep").stream(rows));
    constexpr std::size_t header = 32;
    EXPECT_EQ(rows.text.size(), whole.text.size() + 3 * header);
    EXPECT_EQ(whole.text.substr(0, 8), "KEIKOD1\n");
}

TEST_F(EndpointsTest, TheDeepBufferOfAClientThatGoesIsCutOff) {
    Reader reader(1);
    EXPECT_FALSE(ask("POST", "/deep").stream(reader));
    Reader whole;
    ASSERT_TRUE(ask("POST", "/deep").stream(whole));
    EXPECT_LT(reader.text.size(), whole.text.size());
}

TEST_F(EndpointsTest, TheStillHasTheLampsOfItsRequest) {
    Reader own, dark;
    ASSERT_TRUE(ask("POST", "/still").stream(own));
    ASSERT_TRUE(ask("POST", "/still", "c_plane = []").stream(dark));
    EXPECT_EQ(own.text.substr(1, 3), "PNG");
    EXPECT_NE(own.text, dark.text);
}

TEST_F(EndpointsTest, ShowsAnEarlierRevisionOnlyWhereThereIsOne) {
    EXPECT_TRUE(has(ask("GET", "/scene"), "\"against\": false"));
    EXPECT_EQ(ask("GET", "/against/scene").status, 404);
    EXPECT_EQ(ask("POST", "/against/deep").status, 404);
    EXPECT_EQ(ask("POST", "/against/still").status, 404);
    const std::filesystem::path inputs[] = {keiko::test::repository("surfaces/saddle.bpt")};
    scene_->set_against(open_scene(inputs));
    EXPECT_TRUE(has(ask("GET", "/scene"), "\"against\": true"));
    EXPECT_TRUE(has(ask("GET", "/against/scene"), "saddle.bpt"));
    Reader now, before;
    ASSERT_TRUE(ask("POST", "/deep", "interlaced = false").stream(now));
    ASSERT_TRUE(ask("POST", "/against/deep", "interlaced = false").stream(before));
    EXPECT_EQ(before.text.substr(0, 7), "KEIKOD1");
    EXPECT_NE(now.text, before.text);
    Reader still, still_before;
    ASSERT_TRUE(ask("POST", "/still").stream(still));
    ASSERT_TRUE(ask("POST", "/against/still").stream(still_before));
    EXPECT_EQ(still_before.text.substr(1, 3), "PNG");
    EXPECT_NE(still.text, still_before.text);
}

TEST_F(EndpointsTest, AStillMayHaveAnExposure) {
    const auto still = [&](const std::string& exposure) {
        Reader reader;
        EXPECT_TRUE(ask("POST", "/still", exposure).stream(reader));
        return reader.text;
    };
    EXPECT_NE(still("ev = 3"), still("ev = 9"));
    EXPECT_EQ(ask("POST", "/still", "ev = 101").status, 400);
}

TEST_F(EndpointsTest, ProvesAPickedPlace) {
    const HttpReply body = ask("POST", "/pick", "pixel = [24.5, 13.5]");
    EXPECT_EQ(body.status, 200);
    EXPECT_TRUE(has(body, "\"bound\": ")) << body.body;
    EXPECT_TRUE(has(ask("POST", "/pick", "pixel = [0.5, 0.5]"), "\"picked\": null"));
    EXPECT_TRUE(has(ask("POST", "/pick"), "pixel: is missing"));
    EXPECT_EQ(ask("POST", "/pick", "pixel = [-1, 2]").status, 400);
    EXPECT_EQ(ask("POST", "/pick", "pixel = [1, 2]\nhidden = [4000000000]").status, 400);
}

TEST_F(EndpointsTest, HidesFacesInPicturesOnRequest) {
    const auto deep = [&](const std::string& hidden) {
        Reader reader;
        EXPECT_TRUE(ask("POST", "/deep", "interlaced = false\n" + hidden).stream(reader));
        return reader.text;
    };
    const std::string whole = deep("");
    std::string all = "hidden = [";
    for (const Face& face : scene_->scene().model.faces) all += std::to_string(face.id) + ",";
    const std::string none = deep(all + "]");
    EXPECT_NE(whole, none);
    EXPECT_NE(deep("hidden = [1]"), whole);
    EXPECT_EQ(deep(""), whole);
    const HttpReply unknown = ask("POST", "/still", "hidden = [1, 4000000000]");
    EXPECT_EQ(unknown.status, 400);
    EXPECT_TRUE(has(unknown, "no face 4000000000"));
    EXPECT_EQ(ask("POST", "/still", "hidden = [1.5]").status, 400);
}

TEST_F(EndpointsTest, CutsTheBodyByAPlane) {
    const HttpReply cut = ask("POST", "/section", "y=0");
    EXPECT_EQ(cut.status, 200);
    EXPECT_TRUE(has(cut, "keiko-combs/1"));
    EXPECT_TRUE(has(cut, "\"kind\":\"section\""));
    EXPECT_TRUE(has(ask("POST", "/section", "z=1e6"), "\"kind\":\"missed\""));
    for (const char* wrong : {"", "y", "q=1", "y=nan", "0,0,0=1", "y=1 --"})
        EXPECT_EQ(ask("POST", "/section", wrong).status, 400) << wrong;
}

TEST_F(EndpointsTest, FollowsTheLinesOfTheLampsThatAreAskedFor) {
    const auto lines = [&](const std::string& body) {
        Reader reader;
        EXPECT_TRUE(ask("POST", "/lines", body).stream(reader));
        return reader.text;
    };
    const std::string own = lines("");
    EXPECT_NE(own.find("keiko-lines/2"), std::string::npos);
    EXPECT_NE(own.find("\"preset\":{"), std::string::npos);
    EXPECT_NE(lines("[[c_plane]]\norigin = [-3000, -2000, 2500]\nu = [6000, 0, 0]\n"
                    "v = [0, 4000, 0]\nlamps = 3"),
              own);
    const HttpReply none = ask("POST", "/lines", "c_plane = []");
    EXPECT_EQ(none.status, 400);
    EXPECT_TRUE(has(none, "neither a row of lamps nor a panel"));
}

TEST_F(EndpointsTest, AfterTheEndOfTheServerLongAnswersAreRefused) {
    work_.end_all();
    EXPECT_EQ(ask("GET", "/seams").status, 409);
    Reader reader;
    EXPECT_FALSE(ask("POST", "/deep").stream(reader));
    EXPECT_TRUE(reader.text.empty());
    EXPECT_TRUE(ask("GET", "/events").stream(reader));
}

} // namespace keiko::viewer
