#pragma once

#include "tests/bench/table.h"

#include <filesystem>
#include <string>
#include <vector>

namespace keiko::bench {

struct StripeOptions {
    std::vector<std::string> scenes{}; ///< names or model files; none: hood and front fender
    int width = 240;                   ///< of the pictures, px
    std::filesystem::path pictures{};  ///< folder for the pictures; empty: none
    std::filesystem::path markdown{};  ///< page to put the table into; empty: none
};

/// Stripes from one ray a pixel with its footprint against 1024 rays a pixel, and what as small an
/// error costs by supersampling.
Table run_stripe_benchmark(const StripeOptions& options);

} // namespace keiko::bench
