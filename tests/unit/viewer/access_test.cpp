#include "keiko/viewer/access.h"

#include <gtest/gtest.h>

#include <set>

namespace keiko::viewer {
namespace {

const Access own{8000, "0123456789abcdef0123456789abcdef"};

/// A request of the page itself, without a body.
HttpRequest allowed(std::string method = "GET", std::string path = "/scene") {
    return {std::move(method),
            std::move(path),
            {{"host", "127.0.0.1:8000"}, {"x-keiko-token", own.token}},
            ""};
}

/// The status of the answer, 200 for a request that is allowed.
int status_of(const HttpRequest& head) {
    const auto reply = refusal(head, own);
    return reply ? reply->status : 200;
}

HttpRequest with(HttpRequest head, const std::string& name, std::string value) {
    head.headers[name] = std::move(value);
    return head;
}

} // namespace

TEST(Access, AllowsTheOwnHostByBothNames) {
    EXPECT_EQ(status_of(allowed()), 200);
    EXPECT_EQ(status_of(with(allowed(), "host", "localhost:8000")), 200);
}

TEST(Access, RefusesEveryOtherHost) {
    for (const char* host :
         {"", "127.0.0.1", "127.0.0.1:80", "127.0.0.1:80000", "evil.example:8000",
          "127.0.0.1:8000.evil.example", "127.0.0.1:8000,evil.example"})
        EXPECT_EQ(status_of(with(allowed(), "host", host)), 403) << host;
    HttpRequest without = allowed();
    without.headers.erase("host");
    EXPECT_EQ(status_of(without), 403);
}

TEST(Access, RefusesEveryOtherOriginEvenForThePage) {
    for (const char* origin : {"", "null", "https://127.0.0.1:8000", "http://127.0.0.1:8001",
                               "http://127.0.0.1:8000/", "http://evil.example:8000"})
        for (const char* path : {"/", "/scene"})
            EXPECT_EQ(status_of(with(allowed("GET", path), "origin", origin)), 403) << origin;
    EXPECT_EQ(status_of(with(allowed(), "origin", "http://localhost:8000")), 200);
}

TEST(Access, NeedsTheWholeTokenExceptForFilesOfThePage) {
    for (const std::string& token :
         {std::string(), own.token.substr(1), own.token + "0", std::string(32, '0'),
          "1" + own.token.substr(1), own.token.substr(0, 31) + "0"})
        EXPECT_EQ(status_of(with(allowed(), "x-keiko-token", token)), 401) << token;
    HttpRequest page = allowed("GET", "/viewer.js");
    page.headers.erase("x-keiko-token");
    EXPECT_EQ(status_of(page), 200);
    page.method = "POST";
    EXPECT_EQ(status_of(page), 401);
}

TEST(Access, KnowsThreeMethods) {
    for (const char* method : {"HEAD", "DELETE", "OPTIONS", "PATCH", "get", ""})
        EXPECT_EQ(status_of(with(allowed(method), "content-length", "0")), 405) << method;
}

TEST(Access, LimitsTheAnnouncedLengthOfABody) {
    const auto with_length = [](std::string length) {
        return status_of(with(allowed("POST", "/deep"), "content-length", std::move(length)));
    };
    EXPECT_EQ(with_length("0"), 200);
    EXPECT_EQ(with_length(std::to_string(most_body)), 200);
    EXPECT_EQ(with_length(std::to_string(most_body + 1)), 413);
    for (const char* wrong :
         {"", "-1", "+1", " 1", "1 ", "0x10", "1,1", "1e3", "99999999999999999999999999"})
        EXPECT_EQ(with_length(wrong), 411) << wrong;
    EXPECT_EQ(status_of(allowed("PUT", "/rig")), 411);
}

TEST(Access, TakesNoBodyInPiecesAndNoneThatIsCompressed) {
    const HttpRequest plain = with(allowed("POST", "/deep"), "content-length", "4");
    EXPECT_EQ(status_of(with(plain, "transfer-encoding", "chunked")), 411);
    EXPECT_EQ(status_of(with(plain, "content-encoding", "gzip")), 415);
    EXPECT_EQ(status_of(with(allowed(), "transfer-encoding", "chunked")), 411);
}

TEST(Access, EndsTheConnectionOfWhatItRefuses) {
    const auto reply = refusal(with(allowed(), "host", "evil.example"), own);
    ASSERT_TRUE(reply);
    EXPECT_TRUE(reply->ends_connection);
    EXPECT_EQ(reply->type, "application/json");
}

TEST(Access, MakesTokensOf128BitsThatDiffer) {
    std::set<std::string> tokens;
    for (int i = 0; i < 100; ++i) {
        const std::string token = random_token();
        EXPECT_EQ(token.size(), 32u);
        EXPECT_EQ(token.find_first_not_of("0123456789abcdef"), std::string::npos);
        tokens.insert(token);
    }
    EXPECT_EQ(tokens.size(), 100u);
}

} // namespace keiko::viewer
