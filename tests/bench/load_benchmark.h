#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace keiko::bench {

struct LoadOptions {
    std::vector<std::string> files{}; ///< model files; none: the large ones of ../shared/models
    int rounds = 3;                   ///< interleaved; the least time of each counts
    std::filesystem::path markdown{}; ///< page to put the table into; empty: none
};

/// Cost of loading one file.
struct LoadCost {
    std::string file;
    std::size_t faces = 0;
    double read = 0;    ///< s, OpenCASCADE alone: file to shapes
    double convert = 0; ///< s, shapes to patches and trims
    double whole = 0;   ///< s, load_model: both in the worker, its start and the way back
};

/// Reads each file by OpenCASCADE, converts what it read, and loads it as every command does, in
/// turns. Files that are not there are left out.
std::vector<LoadCost> run_load_benchmark(const LoadOptions& options);

/// The costs as a table in Markdown.
std::string load_table(const std::vector<LoadCost>& costs);

} // namespace keiko::bench
