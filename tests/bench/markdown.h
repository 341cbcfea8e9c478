#pragma once

#include "tests/bench/results.h"

#include <filesystem>
#include <string>

namespace keiko::bench {

/// Conditions of a run and its summary; all figures are in the JSON.
std::string markdown_of(const TraceResults& results);

/// Puts `tables` between the two markers of the page's group, keeping the rest. Throws Error for a
/// page without them.
void update_page(const std::filesystem::path& page, const std::string& group,
                 const std::string& tables);

} // namespace keiko::bench
