#include "tests/support/ray_tally.h"

#include <gtest/gtest.h>

#include <iostream>

namespace keiko::test {
namespace {

constexpr std::size_t most_reports = 8;
const char* const class_names[] = {"random",      "near normal", "grazing",      "span edge",
                                   "span corner", "iso line",    "axis parallel"};

} // namespace

void RayTally::report(const Ray& ray, const std::string& what, const std::string& label) {
    if (++reported_ > most_reports) return;
    std::cout << name_ << ": " << what << ", " << label << ": " << exact_text(ray) << "\n";
}

void RayTally::add(const RayScene& scene, const AimedRay& aimed, Verdict verdict,
                   const std::string& label) {
    ++rays_;
    at_borders_ += aimed.side == TrimSide::mixed;
    lost_ += verdict == Verdict::lost;
    wrong_ += verdict == Verdict::wrong;
    undecided_ += verdict == Verdict::undecided;
    if (verdict == Verdict::found) return;
    const char* word = verdict == Verdict::lost    ? "lost"
                       : verdict == Verdict::wrong ? "wrong"
                                                   : "undecided";
    const char* kind = class_names[static_cast<std::size_t>(aimed.kind)];
    const auto text = [&] { return std::string(word) + " " + kind + ", " + scene.describe(aimed); };
    if (reported_ < most_reports) report(aimed.ray, text(), label);
}

void RayTally::add_brute_force(const Ray& ray, Verdict verdict, const std::string& label) {
    ++brute_force_;
    if (verdict == Verdict::found) return;
    ++lost_to_brute_force_;
    report(ray, "a root of brute force is lost", label);
}

void RayTally::expect_none_lost() const {
    const double seconds =
        std::chrono::duration<double>(std::chrono::steady_clock::now() - begin_).count();
    std::cout << name_ << ": " << rays_ << " rays, lost " << lost_ << ", wrong " << wrong_
              << ", undecided " << undecided_ << ", within trim tolerance or at an open border "
              << at_borders_ << ", not to be made " << unmade_ << "; " << brute_force_
              << " by brute force, lost " << lost_to_brute_force_ << "; "
              << static_cast<std::size_t>(static_cast<double>(rays_) / seconds) << " rays/s\n";
    EXPECT_EQ(lost_, 0u);
    EXPECT_EQ(wrong_, 0u);
    EXPECT_EQ(lost_to_brute_force_, 0u);
    EXPECT_LE(static_cast<double>(undecided_), 1e-6 * static_cast<double>(rays_));
}

} // namespace keiko::test
