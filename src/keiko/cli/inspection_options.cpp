#include "keiko/cli/inspection_options.h"

#include "keiko/api/lines.h"
#include "keiko/api/model.h"
#include "keiko/api/results.h"
#include "keiko/base/error.h"
#include "keiko/base/log.h"
#include "keiko/cli/outputs.h"
#include "keiko/cli/session.h"

#include <CLI/Validators.hpp>

#include <algorithm>

namespace keiko::cli {
namespace fs = std::filesystem;
namespace {

std::vector<fs::path> model_files(const Inspection& inspection) {
    return {inspection.facts.files.begin(), inspection.facts.files.end()};
}

} // namespace

void CombArguments::add_to(CLI::App& command) {
    command
        .add_option("--section", planes_,
                    "plane x=MM, y=MM, z=MM or A,B,C=MM: the curvature comb of its section; may "
                    "repeat")
        ->allow_extra_args(false);
    constexpr int most = 1000;
    command
        .add_option("--iso-curves", iso_curves_,
                    "curvature combs of so many iso-curves a face, each way")
        ->check(CLI::Range(1, most));
}

void CombArguments::add_files(CLI::App& command) {
    command
        .add_option("--combs", files_,
                    "file to write the combs to, .json, .csv or .svg; may repeat")
        ->allow_extra_args(false);
}

CombOptions CombArguments::options(double join) const {
    CombOptions options;
    for (const std::string& plane : planes_) {
        if (std::count(planes_.begin(), planes_.end(), plane) > 1)
            throw Error("", "--section", "'" + plane + "' is asked for twice");
        options.planes.push_back(section_plane(plane));
    }
    options.iso_curves = iso_curves_, options.join = join;
    return options;
}

void CombArguments::require_places(bool as_curves) const {
    const bool asked = !planes_.empty() || iso_curves_ > 0;
    if (asked && files_.empty() && !as_curves)
        throw Error("", "--combs", "names no file for the combs of --section and --iso-curves");
    if (!asked && !files_.empty()) throw Error("", "--combs", "needs --section or --iso-curves");
    for (const std::filesystem::path& file : files_) {
        require_place_for_file(file);
        if (std::count(files_.begin(), files_.end(), file) > 1)
            throw Error("", "--combs", "'" + file.string() + "' is asked for twice");
        const std::filesystem::path ending = file.extension();
        if (ending != ".json" && ending != ".csv" && ending != ".svg")
            throw Error("", "--combs",
                        "'" + file.string() + "' ends in none of .json, .csv and .svg");
    }
}

void CombArguments::add_to(FileTransaction& batch, const Combs& combs) const {
    for (const std::filesystem::path& file : files_) {
        if (file.extension() == ".json") batch.add(file, combs.json);
        if (file.extension() == ".csv") batch.add(file, combs.csv);
        if (file.extension() != ".svg") continue;
        for (const CombPicture& picture : combs.pictures) {
            std::filesystem::path named = file;
            if (planes_.size() > 1 || iso_curves_ > 0)
                named.replace_filename(file.stem().string() + "-" + picture.name + ".svg");
            batch.add(named, picture.svg);
        }
    }
}

void CurveFilesOption::add_to(CLI::App& command, const char* text) {
    command.add_option("--curves", files_, text)->allow_extra_args(false)->check(not_empty());
}

void CurveFilesOption::require_places() const {
    for (const fs::path& file : files_) {
        require_place_for_file(file);
        if (std::count(files_.begin(), files_.end(), file) > 1)
            throw Error("", "--curves", "'" + file.string() + "' is asked for twice");
        if (!is_curve_output(file))
            throw Error(
                "", "--curves",
                "'" + file.string() + "' ends in none of .step, .stp, .iges, .igs and .vtp");
    }
}

void ProfileArguments::add_to(CLI::App& command) {
    command
        .add_option("--profiles", files_,
                    "file to write gap, angle and curvatures along every seam to, .json or .csv; "
                    "may repeat")
        ->allow_extra_args(false);
}

void ProfileArguments::require_places() const {
    for (const fs::path& file : files_) {
        require_place_for_file(file);
        if (std::count(files_.begin(), files_.end(), file) > 1)
            throw Error("", "--profiles", "'" + file.string() + "' is asked for twice");
        if (file.extension() != ".json" && file.extension() != ".csv")
            throw Error("", "--profiles", "'" + file.string() + "' ends in none of .json and .csv");
    }
}

void ProfileArguments::add_to(FileTransaction& batch, const CheckResult& result) const {
    for (const fs::path& file : files_)
        batch.add(file, file.extension() == ".csv"
                            ? profiles_csv(result.profiles, result.inspection)
                            : profiles_json(result.profiles, result.inspection, version()));
}

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
                    "may repeat; the folder of the run with --shard")
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

std::string InspectionFiles::text_of(Format format, const Inspection& inspection) {
    switch (format) {
        case Format::json:
            return inspection_json(inspection, version());
        case Format::junit:
            return junit_xml(inspection);
        case Format::sarif:
            return sarif_json(inspection, version(), model_files(inspection));
        case Format::csv:
            break;
    }
    return checks_csv(inspection);
}

void InspectionFiles::add_to(FileTransaction& batch, const Inspection& inspection) const {
    for (const auto& [path, format] : files()) batch.add(path, text_of(format, inspection));
}

fs::path InspectionFiles::folder() const {
    if (outputs_.size() == 1) return outputs_.front();
    throw Error("", "--output", "is the folder of the run with --shard, and needed once");
}

FolderContent InspectionFiles::every_format(const Inspection& inspection) {
    return {{"inspection.json", text_of(Format::json, inspection)},
            {"junit.xml", text_of(Format::junit, inspection)},
            {"findings.sarif", text_of(Format::sarif, inspection)},
            {"findings.csv", text_of(Format::csv, inspection)}};
}

void DateOption::add_to(CLI::App& command) {
    command
        .add_option("--today", date_, "day by which acceptances end, as 2026-11-27 [today, UTC]")
        ->check(not_empty());
}

std::string DateOption::date() const {
    if (date_.empty()) return date_today();
    if (!is_date(date_)) throw Error("", "--today", "'" + date_ + "' is no date as 2026-11-27");
    return date_;
}

void AcceptedOption::add_to(CLI::App& command) {
    command
        .add_option("--accepted", file_,
                    "file of findings without a part in the verdict (keiko-accepted/1), of keiko "
                    "accept")
        ->check(not_empty());
    today_.add_to(command);
}

AcceptanceList AcceptedOption::list() const {
    const std::string today = today_.date();
    return file_.empty() ? AcceptanceList{{}, today} : read_acceptances(file_, today);
}

void warn_of_acceptances(const Inspection& inspection) {
    for (const AcceptanceRemark& remark : inspection.acceptance_remarks)
        log_warning(text_of(remark));
    if (const std::string warning = curvature_not_judged(inspection); !warning.empty())
        log_warning(warning);
}

void SymmetryOption::add_to_placement(CLI::App& command) {
    command
        .add_option("--symmetry", plane_,
                    "plane that lamps are symmetric about where views and body are: auto, off, or "
                    "a plane as y or y=12.5 (mm) [auto]")
        ->option_text("auto|off|PLANE");
}

void SymmetryOption::add_to(CLI::App& command, bool also_places) {
    command
        .add_option(
            "--symmetry", plane_,
            also_places
                ? "plane that the body is to be symmetric about, as y or y=12.5 (mm), and "
                  "placed lamps with it; auto: lamps alone, off: neither [auto, and what "
                  "the preset judges]"
                : "plane that the body is to be symmetric about, as y or y=12.5 (mm); auto: "
                  "one that is found, as worth a look, off: none [the preset's, or none]")
        ->option_text("auto|off|PLANE");
    command
        .add_option("--symmetry-limit", limit_,
                    "mm that it may be from its mirror image [the preset's, or 0.01]")
        ->check(number_between(1e-6, 1000));
}

SymmetryChoice SymmetryOption::choice() const {
    SymmetryChoice choice = SymmetryChoice::parse(plane_.empty() ? "auto" : plane_);
    if (limit_ > 0) choice.distance = limit_;
    return choice;
}

void SymmetryOption::apply_to(CriteriaPreset& preset) const {
    std::optional<SymmetryLimit>& limit = preset.surface.symmetry;
    const SymmetryChoice asked = choice();
    if (!plane_.empty() && asked.kind == SymmetryChoice::Kind::off) limit.reset();
    if (asked.kind == SymmetryChoice::Kind::plane) {
        if (!limit) limit.emplace();
        limit->plane = asked.plane;
    }
    if (limit_ == 0 || plane_ == "auto") return;
    if (!limit) throw Error("", "", "--symmetry-limit asks for --symmetry too");
    limit->distance = limit_;
}

void SymmetryOption::look_in(CriteriaPreset& preset) const {
    if (plane_ == "auto") preset.look.symmetry = choice().distance;
}

} // namespace keiko::cli
