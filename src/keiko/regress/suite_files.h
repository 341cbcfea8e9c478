#pragma once

#include "keiko/files/scene/fixture_file.h"
#include "keiko/regress/regress.h"

namespace keiko {

// The files of a suite: what its fixtures are now, were, and are required to be.

/// Name of the report that marks a run as done.
constexpr const char* regression_file = "regression.json";

/// Names of fixtures, in their order.
std::vector<std::string> names_of(std::span<const FixtureFile> fixtures);

/// The fixtures of these names, in the order of the suite. Throws Error for a name without one.
std::vector<FixtureFile> chosen(std::vector<FixtureFile> fixtures,
                                std::span<const std::string> names);

/// Runs a fixture and keeps what it showed, or takes what an earlier run has kept of it.
FixtureRecord candidate_of(const FixtureSpec& spec, const RegressOptions& options, const Job& job);

/// Folder of the baselines: the one of the options, or else `baselines` in the suite.
std::filesystem::path baseline_folder(const RegressOptions& options);

/// Baseline that a folder holds; nullopt where there is none. Throws Error for a damaged one.
std::optional<KeptRecord> kept_baseline(const std::filesystem::path& folder);

/// The baseline of a fixture, read while no one writes it.
std::optional<KeptRecord> locked_baseline(const RegressOptions& options, const std::string& name);

/// SHA-256 of everything on which the outcome of each fixture depends: its key and its baseline.
std::vector<std::string> outcome_keys(std::span<const FixtureFile> suite,
                                      const RegressOptions& options);

/// SHA-256 of the keys of all outcomes of a suite: the same for runs that must have the same one.
std::string suite_key(std::span<const std::string> outcome_keys);

/// Names of baselines that belong to no fixture.
std::vector<std::string> stale_baselines(std::span<const FixtureFile> suite,
                                         const RegressOptions& options);

/// Throws Error where the output folder lies in that of the baselines, or has a fixture's folder
/// there: a run would write into what it compares with, and wait for its own lock.
void require_apart(const RegressOptions& options, std::span<const FixtureFile> fixtures);

/// Writes pictures, junit.xml, index.html and, last, regression.json.
void write_reports(const std::filesystem::path& output, const Regression& regression);
/// Run whose reports write_reports left in a folder. Throws Error.
Regression read_reports(const std::filesystem::path& output);

} // namespace keiko
