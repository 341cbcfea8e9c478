#pragma once

#include "tests/support/ray_scene.h"

#include <chrono>
#include <string>

namespace keiko::test {

/// Counts verdicts, prints the first failures so that they can be traced again, and sums up.
class RayTally {
public:
    explicit RayTally(std::string name) : name_(std::move(name)) {}

    /// `label` tells where the ray comes from: seed and number.
    void add(const RayScene& scene, const AimedRay& aimed, Verdict verdict,
             const std::string& label);
    void add_brute_force(const Ray& ray, Verdict verdict, const std::string& label);
    /// A ray that could not be made: no normal, or tangential beyond what long double can tell.
    void add_unmade() { ++unmade_; }
    std::size_t rays() const { return rays_; }

    /// Prints the counts and expects that none was lost or wrong and that at most one in 1e6 was
    /// undecided.
    void expect_none_lost() const;

private:
    void report(const Ray& ray, const std::string& what, const std::string& label);

    std::string name_;
    std::chrono::steady_clock::time_point begin_ = std::chrono::steady_clock::now();
    std::size_t rays_ = 0, lost_ = 0, wrong_ = 0, undecided_ = 0, at_borders_ = 0, unmade_ = 0;
    std::size_t brute_force_ = 0, lost_to_brute_force_ = 0, reported_ = 0;
};

} // namespace keiko::test
