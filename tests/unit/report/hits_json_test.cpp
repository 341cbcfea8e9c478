#include "keiko/base/error.h"
#include "keiko/report/json/placement_json.h"

#include <gtest/gtest.h>

namespace keiko {
namespace {

RegisteredHits one_hit() {
    RegisteredHits hits;
    hits.views = {{"top", {.eye = {0, 0, 9}, .up = {0, 1, 0}, .width = 4, .height = 3}}};
    hits.faces = 2, hits.instances = 1;
    hits.body = {Vec3(0), Vec3(1, 2, 3)};
    ViewSample& hit = hits.samples.emplace_back();
    hit.face = 1, hit.edge = 5, hit.weight = 1e-3;
    hit.normal = hit.mirror.direction = {0, 0, 1};
    hit.mirror.differentials.emplace();
    return hits;
}

std::string text_of_one() {
    return hits_json(one_hit(), "1");
}

std::string refusal_of(const std::string& text) {
    try {
        hits_from_json(text, "hits.json");
    } catch (const Error& error) {
        return error.what();
    }
    return "taken";
}

std::string changed(const std::string& from, const std::string& to) {
    std::string text = text_of_one();
    const std::size_t at = text.find(from);
    EXPECT_NE(at, std::string::npos) << from;
    return text.replace(at, from.size(), to);
}

TEST(HitsJson, ReadsBackAsItWas) {
    const RegisteredHits read = hits_from_json(text_of_one(), "hits.json");
    EXPECT_EQ(hits_json(read, "1"), text_of_one());
    ASSERT_EQ(read.samples.size(), 1u);
    EXPECT_EQ(read.samples[0].face, 1u);
    EXPECT_EQ(read.samples[0].edge, 5);
    EXPECT_EQ(read.views[0].camera, one_hit().views[0].camera);
}

TEST(HitsJson, CountsThatAreNoneAreRefused) {
    for (const std::string count : {"1e300", "0.5", "-4294967295", "4294967296"})
        EXPECT_EQ(refusal_of(changed("\n[0,0,1,5", "\n[0,0," + count + ",5")).find("hits.json:"),
                  0u)
            << count;
    EXPECT_EQ(refusal_of(changed("\n[0,0,1,5", "\n[0,0,1,1e300")),
              "hits.json:hits: \"1e+300\" is no count");
    EXPECT_EQ(refusal_of(changed("\"width\":4", "\"width\":4.5")),
              "hits.json:views.width: \"4.5\" is no whole number");
}

TEST(HitsJson, WordsForNumbersAreRefusedInAShortLine) {
    EXPECT_EQ(refusal_of(changed("0.001", "\"some\"")), "hits.json:hits: \"some\" is no number");
    EXPECT_EQ(refusal_of(changed("0.001", "\"inf\"")), "hits.json:hits: a number is not finite");
    EXPECT_LE(refusal_of(changed("0.001", '"' + std::string(5000, 'x') + '"')).size(), 200u);
}

TEST(HitsJson, PlacesBesideThePictureAreRefused) {
    for (const Vec2& pixel : {Vec2(1e300, 1), Vec2(5, 1), Vec2(-1, 1), Vec2(1, 3.5)}) {
        RegisteredHits hits = one_hit();
        hits.samples[0].pixel = pixel;
        EXPECT_EQ(refusal_of(hits_json(hits, "1")), "hits.json:hits: one is beside its picture");
    }
}

TEST(HitsJson, TheNameOfAViewIsToldInAShortLine) {
    RegisteredHits hits = one_hit();
    hits.views[0].name.assign(5000, 'x');
    hits.views[0].camera.target = hits.views[0].camera.eye;
    const std::string refusal = refusal_of(hits_json(hits, "1"));
    EXPECT_NE(refusal.find("target must differ from eye"), std::string::npos);
    EXPECT_LE(refusal.size(), 1000u);
}

} // namespace
} // namespace keiko
