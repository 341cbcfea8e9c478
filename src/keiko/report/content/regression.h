#pragma once

#include "keiko/base/export.h"
#include "keiko/base/output_folder.h"
#include "keiko/compare/fixture_record.h"
#include "keiko/report/content/picture_outcome.h"

#include <array>
#include <string>
#include <vector>

namespace KEIKO_API keiko {

/// Result of a fixture, from good to bad.
enum class FixtureState {
    same,      ///< within its tolerances
    different, ///< beyond one of its tolerances
    missing,   ///< has no baseline to compare with
    error      ///< could not be run, or its baseline is damaged
};

/// All states, from good to bad.
inline constexpr std::array every_fixture_state{FixtureState::same, FixtureState::different,
                                                FixtureState::missing, FixtureState::error};
/// "same", "different", "missing", "error"
std::string_view name_of(FixtureState state);

/// Outcome of a fixture.
struct FixtureOutcome {
    std::string name;                        ///< of the fixture
    FixtureState state = FixtureState::same; ///< worst of its checks
    std::string error{};                     ///< one line, of an error
    /// Requested checks among "shape", "seams" and "lines".
    std::vector<std::string> checks{};
    /// Metrics of either record.
    std::size_t metrics_compared = 0;
    std::vector<MetricDifference> metrics{}; ///< those beyond their tolerance
    std::vector<PictureOutcome> pictures{};  ///< one a view
    FolderContent pngs{};                    ///< of views that differ or have no baseline
};

/// One run of a suite, or of a shard of it.
struct Regression {
    std::string tool_version;                   ///< version of Keiko that ran the suite
    std::vector<std::string> suite;             ///< every fixture of the suite, by name
    std::string suite_key{};                    ///< of everything on which the suite's outcome
                                                ///< depends
    std::vector<std::string> stale_baselines{}; ///< folders of baselines without a fixture
    int shard = 1, shards = 1;                  ///< its own number, and that of all shards
    std::vector<FixtureOutcome> fixtures{};     ///< those of the shard, by name

    /// Number of fixtures in a state.
    std::size_t count(FixtureState state) const;
    /// The worst state of all fixtures; different if a baseline is stale, since then a fixture is
    /// gone.
    FixtureState state() const;
};

/// "7 fixtures, 5 same, 1 different, 0 missing, 1 error"
std::string summary_of(const Regression& regression);

/// The run as "keiko-regression/1": everything except the pictures' bytes. It holds no times: every
/// run gives the same bytes.
std::string regression_json(const Regression& regression);
/// Inverse of regression_json; `file` is for messages. Throws Error.
Regression parse_regression(const std::string& json, const std::string& file);

/// The run as a self-contained page with everything that is not the same: pictures before, after,
/// difference, and numbers.
std::string regression_html(const Regression& regression);

/// The run for build servers: a suite a fixture, a case a check, view and layer.
std::string regression_junit(const Regression& regression);

} // namespace keiko
