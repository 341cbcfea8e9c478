#include "keiko/compare/fixture_record.h"

#include <gtest/gtest.h>

#include <cmath>

namespace keiko {
namespace {

const MetricTolerances tolerances = [] {
    MetricTolerances made;
    made[Quantity::gap] = {0.01, 0};
    made[Quantity::area] = {0, 0.1};
    return made;
}();

std::vector<MetricDifference> between(const Metric& before, const Metric& after) {
    return metric_differences(std::array{before}, std::array{after}, tolerances);
}

Metric gap(double value) {
    return {"seams", "a | b: gap", Quantity::gap, value};
}

TEST(MetricDifference, NumbersWithinTheirToleranceAreTheSame) {
    EXPECT_TRUE(between(gap(1), gap(1.009)).empty());
    EXPECT_EQ(between(gap(1), gap(1.011)).size(), 1u);
    const auto area = [](double value) { return Metric{"shape", "area", Quantity::area, value}; };
    EXPECT_TRUE(between(area(100), area(110)).empty());
    EXPECT_EQ(between(area(100), area(112)).size(), 1u);
}

TEST(MetricDifference, NoNumberIsFarFromEveryNumberAndLikeItself) {
    EXPECT_EQ(between(gap(1), gap(NAN)).size(), 1u);
    EXPECT_TRUE(between(gap(NAN), gap(NAN)).empty());
    EXPECT_EQ(between(gap(1), gap(INFINITY)).size(), 1u);
    EXPECT_TRUE(between(gap(INFINITY), gap(INFINITY)).empty());
}

TEST(MetricDifference, WordsMustAgree) {
    const auto verdict = [](const char* word) {
        return Metric{"seams", "verdict", Quantity::verdict, std::string(word)};
    };
    EXPECT_TRUE(between(verdict("pass"), verdict("pass")).empty());
    const auto found = between(verdict("pass"), verdict("fail"));
    ASSERT_EQ(found.size(), 1u);
    EXPECT_EQ(text_of(found[0]), "seams: verdict: pass -> fail");
}

TEST(MetricDifference, WhatOnlyOneListHasIsADifference) {
    const std::array before{gap(1)};
    const std::array after{Metric{"seams", "c | d: gap", Quantity::gap, 2.0}};
    const auto found = metric_differences(before, after, tolerances);
    ASSERT_EQ(found.size(), 2u);
    EXPECT_EQ(text_of(found[0]), "seams: c | d: gap: none -> 2 mm");
    EXPECT_EQ(text_of(found[1]), "seams: a | b: gap: 1 -> none mm");
}

TEST(MetricDifference, TellsHowMuchMoreOrLessAndWhatIsAllowed) {
    EXPECT_EQ(text_of(between(gap(1), gap(0.5)).at(0)),
              "seams: a | b: gap: 1 -> 0.5 mm, 0.5 less; 0.01 allowed");
}

std::vector<Metric> face(const std::string& name, double area, double place) {
    return {{"shape", name + ": area", Quantity::area, area},
            {"shape", name + ": centre x", Quantity::place, place}};
}

TEST(MetricDifference, ANewNameAloneIsNone) {
    EXPECT_TRUE(
        metric_differences(face("face 7 (roof)", 100, 5), face("face 1", 100, 5), {}).empty());
}

TEST(MetricDifference, ANewNameWithOtherNumbersIsOneThingGoneAndOneNew) {
    EXPECT_EQ(metric_differences(face("face 7", 100, 5), face("face 1", 100, 5.1), {}).size(), 4u);
    std::vector<Metric> less = face("face 1", 100, 5);
    less.pop_back();
    EXPECT_EQ(metric_differences(face("face 7", 100, 5), less, {}).size(), 3u);
}

} // namespace
} // namespace keiko
