#include "keiko/cli/inspection_files.h"

#include "keiko/api/model.h"
#include "keiko/base/error.h"
#include "keiko/cli/output_place.h"

namespace keiko::cli {
namespace fs = std::filesystem;
namespace {

std::vector<fs::path> model_files(const Inspection& inspection) {
    return {inspection.facts.files.begin(), inspection.facts.files.end()};
}

} // namespace

void InspectionFiles::add_to(CLI::App& command) {
    const auto add = [&](const char* name, std::vector<fs::path>& files, const char* text) {
        command.add_option(name, files, text)->allow_extra_args(false);
    };
    add("--junit", junit_, "JUnit XML file to write: a test case a seam or face and criterion");
    add("--sarif", sarif_, "SARIF 2.1.0 file to write: a result a finding");
    add("--csv", csv_, "CSV file to write: a row a seam or face and criterion");
}

void InspectionFiles::add_json_and_output(CLI::App& command) {
    command.add_option("--json", json_, "JSON file to write: all that was measured")
        ->allow_extra_args(false);
    command
        .add_option("-o,--output", outputs_,
                    "file to write, its format by its ending: .json, .xml (JUnit), .sarif or .csv; "
                    "may repeat")
        ->allow_extra_args(false);
}

std::vector<InspectionFiles::File> InspectionFiles::files() const {
    std::vector<File> all;
    const auto add = [&](const std::vector<fs::path>& paths, Format format) {
        for (const fs::path& path : paths) all.push_back({path, format});
    };
    add(json_, Format::json), add(junit_, Format::junit);
    add(sarif_, Format::sarif), add(csv_, Format::csv);
    for (const fs::path& path : outputs_) {
        const fs::path ending = path.extension();
        if (ending == ".json")
            all.push_back({path, Format::json});
        else if (ending == ".xml")
            all.push_back({path, Format::junit});
        else if (ending == ".sarif")
            all.push_back({path, Format::sarif});
        else if (ending == ".csv")
            all.push_back({path, Format::csv});
        else
            throw Error("", "--output",
                        "'" + path.string() + "' ends in none of .json, .xml, .sarif and .csv");
    }
    return all;
}

void InspectionFiles::require_places(std::span<const fs::path> inputs) const {
    const std::vector<fs::path> asked = paths();
    for (const fs::path& path : asked) require_place_for_file(path);
    require_distinct(asked, inputs);
}

std::vector<fs::path> InspectionFiles::paths() const {
    std::vector<fs::path> paths;
    for (const File& file : files()) paths.push_back(file.path);
    return paths;
}

void InspectionFiles::add_to(FileTransaction& batch, const Inspection& inspection) const {
    for (const auto& [path, format] : files()) switch (format) {
            case Format::json:
                batch.add(path, inspection_json(inspection, version()));
                break;
            case Format::junit:
                batch.add(path, junit_xml(inspection));
                break;
            case Format::sarif:
                batch.add(path, sarif_json(inspection, version(), model_files(inspection)));
                break;
            case Format::csv:
                batch.add(path, checks_csv(inspection));
                break;
        }
}

} // namespace keiko::cli
