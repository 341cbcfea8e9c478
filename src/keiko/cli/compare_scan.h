#pragma once

#include "keiko/api/compare.h"
#include "keiko/base/job.h"
#include "keiko/cli/scene_options.h"

#include <CLI/App.hpp>

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace keiko::cli {

/// Options of `keiko compare` for a scan, besides those of its nominal.
struct ScanArguments {
    std::filesystem::path scan, output, json;
    std::vector<std::string> views;  ///< as --view names them
    std::string unit = "mm";         ///< of the numbers in the scan
    double least_share = 100;        ///< percent of the points that must be within the tolerance
    std::optional<double> surface{}; ///< value of the surface, if the scan is voxels
    bool stay = false;               ///< the points are not moved onto the nominal
    double tolerance = 0;            ///< mm, if the command has --tolerance
    double reach = 0;                ///< mm; 0: the default

    /// Adds the options that scans alone have.
    void add_to(CLI::App& command);
};

/// True if -o names a page rather than a folder.
bool is_page(const std::filesystem::path& output);

/// Throws Error if the command was given an option that scans do not have, or one that only they
/// have without a scan.
void require_options_of_kind(const CLI::App& command, bool is_scan);

/// Compares a scan with the nominal, which is the input of `scene`, writes what is requested and
/// prints the outcome. Returns the exit code. Throws Error, Cancelled.
int compare_with_scan(const CLI::App& command, const SceneArguments& scene,
                      const ScanArguments& arguments, const Job& job);

} // namespace keiko::cli
