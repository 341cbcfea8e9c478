#pragma once

#include <CLI/App.hpp>

namespace keiko::cli {

/// Accepts an option's number from `low` to `high`; NaN and infinity are rejected.
CLI::Validator number_between(double low, double high);

} // namespace keiko::cli
