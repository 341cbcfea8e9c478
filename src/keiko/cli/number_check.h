#pragma once

#include <CLI/App.hpp>

namespace keiko::cli {

/// Lets an option's number pass that is from `low` to `high`; neither NaN nor infinity is.
CLI::Validator number_between(double low, double high);

} // namespace keiko::cli
