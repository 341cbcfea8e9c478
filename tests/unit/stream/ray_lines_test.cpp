#include "keiko/stream/ray_lines.h"

#include "tests/unit/stream/cut_text.h"
#include <gtest/gtest.h>

namespace keiko {
namespace {

ParsedRays parse(const std::string& text) {
    return rays_of({.text = text, .first_line = 1, .first_ray = 0});
}

std::string refusal_of(const std::string& line) {
    const ParsedRays parsed = parse(line);
    return parsed.fault ? parsed.fault->what() : "";
}

/// All pieces of a text that comes `size` bytes at a time.
std::vector<RayLines> pieces_of(const std::string& text, std::size_t size) {
    RayLineReader reader(test::cut_text(text, size));
    std::vector<RayLines> pieces;
    for (RayLines lines; reader.read(lines);) pieces.push_back(lines);
    return pieces;
}

TEST(RaysOf, ReadsNumbersAsTheyAreWritten) {
    const ParsedRays parsed = parse("1,-2.5,3e2,0.1,0,-1\n 4 ,\t5,6,7,8,9\r\n1,1,1,1,1,1");
    ASSERT_FALSE(parsed.fault);
    ASSERT_EQ(parsed.rays.size(), 3u);
    EXPECT_EQ(parsed.rays[0].origin, Vec3(1, -2.5, 300));
    EXPECT_EQ(parsed.rays[0].direction, Vec3(0.1, 0, -1));
    EXPECT_EQ(parsed.rays[1].direction, Vec3(7, 8, 9));
}

TEST(RaysOf, NamesLineAndFieldOfWhatIsNoRay) {
    const std::string at = "standard input:1: ";
    EXPECT_EQ(refusal_of("1,2,x,4,5,6"), at + "oz is not a number: \"x\"");
    EXPECT_EQ(refusal_of("1,,3,4,5,6"), at + "oy is empty");
    EXPECT_EQ(refusal_of("1,2,3,4,5,6 mm"), at + "dz is not a number: \"6 mm\"");
    EXPECT_EQ(refusal_of("1,2,3,nan,5,6"), at + "dx is not finite: \"nan\"");
    EXPECT_EQ(refusal_of("-inf,2,3,4,5,6"), at + "ox is not finite: \"-inf\"");
    EXPECT_EQ(refusal_of("1,1e999,3,4,5,6"), at + "oy is beyond all doubles: \"1e999\"");
    EXPECT_EQ(refusal_of("1,2,3,4,5"), at + "expected ox,oy,oz,dx,dy,dz, got 5 fields");
    EXPECT_EQ(refusal_of("1;2;3;4;5;6"), at + "expected ox,oy,oz,dx,dy,dz, got 1 field");
    EXPECT_EQ(refusal_of("1,2,3,4,5,6,"), at + "expected ox,oy,oz,dx,dy,dz, got 7 fields");
    EXPECT_EQ(refusal_of("\n"), at + "expected ox,oy,oz,dx,dy,dz, got an empty line");
    EXPECT_EQ(refusal_of(" \r\r\n"), at + "expected ox,oy,oz,dx,dy,dz, got an empty line");
    EXPECT_EQ(refusal_of(std::string(2000, '1')), at + "longer than 1024 characters");
}

TEST(RaysOf, RefusesWhatCannotBeTraced) {
    const std::string at = "standard input:1: ";
    EXPECT_EQ(refusal_of("1,2,3,0,-0,0"), at + "dx,dy,dz is no direction: all are 0");
    EXPECT_EQ(refusal_of("1,2,3,1e200,0,0"), at + "dx,dy,dz has a length beyond 1e-100 to 1e100");
    EXPECT_EQ(refusal_of("1,2,3,1e-200,0,0"), at + "dx,dy,dz has a length beyond 1e-100 to 1e100");
    EXPECT_EQ(refusal_of("1,-1e16,3,1,0,0"), at + "ox,oy,oz lies beyond 1e15 mm");
}

TEST(RaysOf, KeepsTheRaysBeforeAFault) {
    const ParsedRays parsed =
        rays_of({.text = "1,2,3,4,5,6\n1,2,3,4,5,6\n?\n1,2,3,4,5,6\n", .first_line = 40});
    EXPECT_EQ(parsed.rays.size(), 2u);
    ASSERT_TRUE(parsed.fault);
    EXPECT_EQ(parsed.fault->where(), "42");
}

TEST(RayLineReader, GivesTheSameLinesHoweverTheStreamIsCut) {
    const std::string rays = "1,2,3,4,5,6\n7,8,9,1,2,3\r\n-1,-2,-3,-4,-5,-6";
    for (const std::string& text :
         {std::string(ray_header) + "\n" + rays, std::string(ray_header) + "\r\n" + rays})
        for (std::size_t size = 1; size <= text.size(); ++size) {
            std::string joined;
            std::uint64_t line = 2, ray = 0;
            for (const RayLines& lines : pieces_of(text, size)) {
                if (lines.text.empty()) continue;
                EXPECT_EQ(lines.first_line, line);
                EXPECT_EQ(lines.first_ray, ray);
                const auto count = static_cast<std::uint64_t>(
                    std::count(lines.text.begin(), lines.text.end(), '\n'));
                line += count, ray += count;
                joined += lines.text;
            }
            EXPECT_EQ(joined, rays) << size;
        }
}

TEST(RayLineReader, TakesAHeaderOnlyWhereItIsThatAndFirst) {
    EXPECT_EQ(pieces_of("ox,oy,oz,dx,dy,dz,\n", 99)[0].text, "ox,oy,oz,dx,dy,dz,\n");
    EXPECT_EQ(pieces_of("1,2,3,4,5,6\nox,oy,oz,dx,dy,dz\n", 99)[0].first_line, 1u);
    EXPECT_TRUE(pieces_of("ox,oy,oz,dx,dy,dz", 4)[0].text.empty());
    EXPECT_EQ(pieces_of(" ox, oy ,oz\t,dx,dy,dz \r\n1,2,3,4,5,6\n", 99)[0].text, "1,2,3,4,5,6\n");
    EXPECT_TRUE(pieces_of("", 4).empty());
}

/// The rays of a stream that comes `size` bytes at a time, and what ends it before its end.
std::pair<std::size_t, std::string> read_all(const std::string& text, std::size_t size) {
    std::size_t rays = 0;
    for (const RayLines& lines : pieces_of(text, size)) {
        EXPECT_EQ(lines.first_ray, rays);
        const ParsedRays parsed = rays_of(lines);
        rays += parsed.rays.size();
        if (parsed.fault) return {rays, parsed.fault->where()};
    }
    return {rays, ""};
}

TEST(RayLineReader, LeavesOutAByteOrderMarkAndBlankLinesAtTheEndAlone) {
    const std::string mark = "\xEF\xBB\xBF", header = "ox,oy,oz,dx,dy,dz\r\n",
                      ray = "1,2,3,4,5,6\n";
    for (std::size_t size = 1; size < 60; ++size) {
        EXPECT_EQ(read_all(mark + header + ray, size), std::pair(std::size_t{1}, std::string()));
        EXPECT_EQ(read_all(mark + ray + ray + "\r\n \n\t", size),
                  std::pair(std::size_t{2}, std::string()));
        EXPECT_EQ(read_all(header + ray + "\n \n\n" + ray, size),
                  std::pair(std::size_t{1}, std::string("3")));
        EXPECT_EQ(read_all("\n" + ray, size), std::pair(std::size_t{0}, std::string("1")));
        EXPECT_EQ(read_all(ray + mark + ray, size), std::pair(std::size_t{1}, std::string("2")));
    }
}

TEST(RayLineReader, NeverGathersALineWithoutEnd) {
    for (const RayLines& lines : pieces_of(std::string(1 << 20, '1'), 4096))
        EXPECT_LE(lines.text.size(), 1u << 17);
}

} // namespace
} // namespace keiko
