#pragma once

#include "keiko/intersect/traversal/tracer.h"

#include "tests/bench/accuracy.h"
#include "tests/bench/contender.h"
#include "tests/bench/kernel_costs.h"
#include "tests/bench/machine.h"
#include "tests/bench/scenes.h"

#include <optional>
#include <string>
#include <vector>

namespace keiko::bench {

/// One contender on one class of rays.
struct Measurement {
    Kind kind = Kind::keiko;
    std::string name{};
    Mode mode = Mode::single;
    double rate = 0; ///< rays per second of processor time, median of the rounds
    /// How many times faster Keiko is, medians of the rounds' ratios: whole hits, single and in
    /// packets; and stopped at t and uv, in the same mode as this.
    double keiko_single = 0, keiko_packets = 0, crossings = 0;
    std::optional<Accuracy> accuracy{};

    /// Whole hits in the same mode.
    double ratio() const { return mode == Mode::single ? keiko_single : keiko_packets; }
};

struct ClassResult {
    std::string name{};
    std::size_t rays = 0, hits = 0;
    std::size_t tangential = 0; ///< hits of Keiko that say so
    std::vector<Measurement> measurements{};
    CostsByMode costs{};
};

struct SceneResult {
    std::string name{};
    bool free_form = true;
    std::size_t faces = 0, patches = 0;
    double size = 0; ///< mm
    std::vector<ContenderFacts> contenders{};
    std::vector<ClassResult> classes{};
};

/// Results of ./dev bench trace.
struct TraceResults {
    Machine machine{};
    std::size_t rays = 0;
    int rounds = 0;
    std::vector<SceneResult> scenes{};
    double trimming_cost = 0;           ///< share, see trimming_cost.h
    std::vector<std::string> skipped{}; ///< scenes whose file is not there
};

} // namespace keiko::bench
