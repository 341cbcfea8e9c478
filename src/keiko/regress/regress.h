#pragma once

#include "keiko/base/export.h"
#include "keiko/batch/shard.h"
#include "keiko/import/worker/load_model.h"
#include "keiko/report/content/regression.h"
#include "keiko/report/record_files.h"

#include <optional>

namespace KEIKO_API keiko {

/// Options of a run of a suite.
struct RegressOptions {
    std::filesystem::path suite;                    ///< folder of the fixtures
    std::filesystem::path baselines;                ///< empty: suite / "baselines"
    std::filesystem::path output = "keiko-regress"; ///< folder of candidates and reports
    std::vector<std::string> only;                  ///< fixtures by name; empty: all
    std::optional<Shard> shard;                     ///< the share that is run; none: all
    bool fresh = false;                             ///< run fixtures again whose candidate is there
    LoadOptions load;                               ///< of the models
};

/// Runs the fixtures of a suite and holds each against its baseline. Writes into the output folder
/// NAME/candidate of each fixture once it is done, NAME/pictures of those that are not the same,
/// and at the end regression.json, junit.xml and index.html; each whole or not at all. A candidate
/// that is there is taken where all it was made from is the same, this program included. A fixture
/// that cannot be run is reported in its outcome. A shard does all this in `output`/shard-K, beside
/// shards.json, the plan of the run. Throws Error for a suite that cannot be read, while another
/// process writes to the output folder, and for a shard where that is of another run; Cancelled.
Regression run_regression(const RegressOptions& options, const Job& job = {});

/// Baseline that was accepted, and what it changes.
struct AcceptedBaseline {
    std::string name;      ///< of the fixture
    BaselineChange change; ///< its `changed` empty: the baseline is what it was
};

/// Makes the candidates of the named fixtures, run if need be, their baselines, and adds who
/// changed what to their manifests. Throws Error for an unknown name, before anything is changed.
std::vector<AcceptedBaseline> update_baselines(const RegressOptions& options,
                                               std::span<const std::string> names,
                                               const std::string& by, const std::string& reason,
                                               const Job& job = {});

/// Joins the shards of a run into one, as if it had not been divided; its reports are written into
/// `output`. `named` are output folders with shards in them, or shards by themselves. Throws Error
/// where a shard is missing, there twice, or of another run.
Regression merge_regressions(std::span<const std::filesystem::path> named,
                             const std::filesystem::path& output);

} // namespace keiko
