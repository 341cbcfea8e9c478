#pragma once

#include "keiko/base/output_folder.h"
#include "keiko/compare/fixture_record.h"
#include "keiko/report/content/picture_outcome.h"

#include <array>
#include <string>
#include <vector>

namespace keiko {

/// What became of a fixture, from good to bad.
enum class FixtureState {
    same,      ///< within its tolerances
    different, ///< beyond one of them
    missing,   ///< has no baseline to be held against
    error      ///< could not be run, or its baseline is damaged
};

inline constexpr std::array every_fixture_state{FixtureState::same, FixtureState::different,
                                                FixtureState::missing, FixtureState::error};
std::string_view name_of(FixtureState state);

/// What became of a fixture.
struct FixtureOutcome {
    std::string name;
    FixtureState state = FixtureState::same;
    std::string error{}; ///< one line, of an error
    /// Of "shape", "seams" and "lines" those that were asked for.
    std::vector<std::string> checks{};
    std::size_t metrics_compared = 0;
    std::vector<MetricDifference> metrics{};
    std::vector<PictureOutcome> pictures{};
    FolderContent pngs{}; ///< of views that differ or have nothing to be held against
};

/// One run of a suite, or of a share of it.
struct Regression {
    std::string tool_version;
    std::vector<std::string> suite;             ///< every fixture of the suite, by name
    std::string suite_key{};                    ///< of all that the suite's outcome depends on
    std::vector<std::string> stale_baselines{}; ///< folders of baselines that no fixture has
    int shard = 1, shards = 1;                  ///< fixture i is of shard i % shards + 1
    std::vector<FixtureOutcome> fixtures{};     ///< those of the shard, by name

    std::size_t count(FixtureState state) const;
    /// The worst of all fixtures; different where a baseline is stale, for then a fixture has gone.
    FixtureState state() const;
};

/// "7 fixtures, 5 same, 1 different, 0 missing, 1 error"
std::string summary_of(const Regression& regression);

/// "keiko-regression/1": everything but the pictures' bytes. No times: every run gives the same.
std::string regression_json(const Regression& regression);
/// What regression_json wrote; `file` is for messages. Throws Error.
Regression parse_regression(const std::string& json, const std::string& file);

/// A page of its own with what is not the same: pictures before, after, difference, and numbers.
std::string regression_html(const Regression& regression);

/// For build servers: a suite a fixture, a case a check, view and layer.
std::string regression_junit(const Regression& regression);

} // namespace keiko
