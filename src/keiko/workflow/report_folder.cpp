#include "keiko/workflow/report_folder.h"

#include "keiko/base/input_file.h"
#include "keiko/base/sha256.h"
#include "keiko/report/content/report_origin.h"

namespace keiko {
namespace {

namespace fs = std::filesystem;

constexpr const char* report_name = "report.json";

/// Remarks on the files that are not those of the report.
Diagnostics changes_of(const std::vector<InputFile>& inputs) {
    Diagnostics changes;
    for (const InputFile& input : inputs)
        if (!fs::is_regular_file(input.path))
            changes.push_back({Severity::warning, input.path, "is missing since the inspection"});
        else if (sha256_hex(read_file(input.path)) != input.sha256)
            changes.push_back({Severity::warning, input.path,
                               "has changed since the inspection: faults and verdicts are those "
                               "of the file of then"});
    return changes;
}

} // namespace

bool is_report_folder(const fs::path& path) {
    return fs::is_regular_file(path / report_name);
}

ReportFolder read_report_folder(const fs::path& folder) {
    const fs::path report = folder / report_name, faults = folder / "faults.json";
    ReportFolder read;
    read.report = read_text_file(report);
    ReportOrigin origin = report_origin_from_json(read.report, report.string());
    read.inputs.assign(origin.opened.begin(), origin.opened.end());
    for (const fs::path& input : read.inputs)
        if (!fs::is_regular_file(input))
            throw Error(report.string(), "opened",
                        in_quotes(input.string()) +
                            " is not there; its path is relative to where the inspection ran");
    read.views = std::move(origin.views);
    read.rig = folder / "rig.toml";
    if (const fs::path analysis = folder / "analysis.json"; fs::is_regular_file(analysis))
        read.analysis = analysis;
    read.faults = read_text_file(faults);
    require_faults_json(read.faults, faults.string());
    read.changes = changes_of(origin.inputs);
    return read;
}

} // namespace keiko
