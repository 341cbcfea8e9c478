#include "keiko/report/html/fault_words.h"

#include "tests/unit/report/sample_report.h"
#include <gtest/gtest.h>

#include <tuple>

namespace keiko {
namespace {

using test::report;

TEST(FaultWords, PlacesAreThirdsOfTheBody) {
    const Box3 body{Vec3(-300, -90, 0), Vec3(300, 0, 30)};
    EXPECT_EQ(words_of_place({-250, -80, 2}, body), "front left, low");
    EXPECT_EQ(words_of_place({0, -45, 15}, body), "middle");
    EXPECT_EQ(words_of_place({250, -5, 29}, body), "rear right, high");
    EXPECT_EQ(words_of_place({1, 1, 5}, {Vec3(1, 1, 5), Vec3(1, 1, 5)}), "middle");
}

TEST(FaultWords, WhatIsMendedFirstStandsFirst) {
    Report any = report();
    const std::size_t first = any.inspection.findings.size();
    const auto add = [&](const char* code, const char* faces, std::uint32_t seam, double value) {
        Check check;
        check.code = code, check.faces = faces, check.seam = seam;
        check.worst.value = value, check.worst.limit = 0.1;
        any.inspection.findings.push_back(check);
    };
    add("KEIKO-LINE-KINK", "f 1 | f 2", no_index, 90);
    add("G-SU-NS", "f 3 | f 4", 0, 1);
    add("G-SU-NT", "f 5 | f 6", 0, 0.4);
    add("G-SU-NT", "f 7 | f 8", 0, 0.5);
    TriageItem fault;
    fault.findings = {0, first, first + 1, first + 2, first + 3};
    EXPECT_EQ(also_text(fault, any.inspection),
              "also f 7 | f 8: kink of 0.5°; f 5 | f 6: kink of 0.4°; f 3 | f 4: curvature jump; "
              "f 1 | f 2: reflections of lamps break");
}

TEST(FaultWords, AnAngleThatAGapBringsIsNamedWithIt) {
    Report any = report();
    const std::size_t first = any.inspection.findings.size();
    for (const auto& [code, faces, value] : {std::tuple("G-SU-NT", "f 1 | f 2", 1.45),
                                             {"G-SU-LG", "f 1 | f 2", 0.125},
                                             {"G-SU-NT", "f 3 | f 4", 0.5}}) {
        Check check;
        check.code = code, check.faces = faces, check.seam = 0;
        check.worst.value = value, check.worst.limit = 0.1;
        any.inspection.findings.push_back(check);
    }
    TriageItem fault;
    fault.findings = {0, first, first + 1};
    EXPECT_EQ(also_text(fault, any.inspection), "also f 1 | f 2: gap of 0.125 mm, kink of 1.45°");
    fault.findings = {first + 1, first, first + 2};
    EXPECT_EQ(also_text(fault, any.inspection),
              "also f 1 | f 2: kink of 1.45°; f 3 | f 4: kink of 0.5°")
        << "the worst finding stands at the head";
}

TEST(FaultWords, APatchToRebuildAndACreaseThatEndsAreNamed) {
    const Report any = report();
    TriageItem fault;
    fault.findings = {0}, fault.seams = {0}, fault.mending = Mending::tangent;
    EXPECT_EQ(sight_text(fault, any.inspection).find("rebuild"), std::string::npos);
    EXPECT_EQ(sight_text(fault, any.inspection).find("crease"), std::string::npos);
    fault.patch = 0, fault.left_of_crease = 2.3717;
    const std::string text = sight_text(fault, any.inspection);
    EXPECT_NE(text.find("rebuild " + any.inspection.faces.at(0).name), std::string::npos);
    EXPECT_NE(text.find("a crease fades to 2.37° and ends"), std::string::npos);
    EXPECT_EQ(fault_title(fault, any.inspection), "Crease that ends (G1)");
}

TEST(FaultWords, JumpsTooFineForAnEyeStandByFallingRadius) {
    Report any = report();
    any.inspection.seams.resize(4);
    for (const auto& [seam, radius] : {std::pair(0, 15.0), {1, 40.0}, {2, 3270.4}}) {
        CurvatureStep step;
        step.curvature_b = -1 / radius;
        any.inspection.seams[std::size_t(seam)].curvature = step;
    }
    any.inspection.seams[3].curvature.reset();
    TriageItem fault;
    fault.findings = {0}, fault.seams = {0, 1, 2, 3}, fault.fine = true;
    EXPECT_EQ(also_text(fault, any.inspection),
              "seam 3 (R 3270 mm), seam 2 (R 40 mm), seam 1 (R 15 mm), seam 4");
    fault.seams.assign(12, 1);
    const std::string many = also_text(fault, any.inspection);
    EXPECT_EQ(many.substr(many.find(';')), "; and 2 more");
}

TEST(FaultWords, HolesAreCounted) {
    Report any = report();
    const std::size_t first = any.inspection.findings.size();
    for (const double length : {20.0, 0.0, 16.0}) {
        Check check;
        check.opening_length = length, check.seam = length > 0 ? no_index : 0;
        any.inspection.findings.push_back(check);
    }
    TriageItem fault;
    fault.findings = {first, first + 1};
    EXPECT_EQ(fault_title(fault, any.inspection), "Hole");
    fault.findings.push_back(first + 2);
    EXPECT_EQ(fault_title(fault, any.inspection), "2 holes");
}

TEST(FaultWords, TitlesNameTheContinuityThatBreaks) {
    const Report any = report();
    TriageItem fault;
    fault.findings = {0}, fault.seams = {0};
    for (const auto& [mending, title] : {std::pair(Mending::position, "Gap (G0)"),
                                         {Mending::tangent, "Kink (G1)"},
                                         {Mending::curvature, "Curvature jump (G2)"},
                                         {Mending::layout, "Layout of patches"}}) {
        fault.mending = mending;
        EXPECT_EQ(fault_title(fault, any.inspection), title);
    }
}

} // namespace
} // namespace keiko
