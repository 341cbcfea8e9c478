#include "tests/bench/inspect_benchmark.h"

#include "keiko/api/inspect.h"
#include "keiko/api/scene.h"
#include "keiko/base/error.h"

#include "tests/bench/brep_mesh.h"
#include "tests/bench/cpu_clock.h"
#include "tests/bench/progress.h"
#include "tests/integration/opencascade_tracer.h"
#include "tests/support/paths.h"
#include <TopoDS_Shape.hxx>
#include <sys/resource.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <map>

namespace keiko::bench {
namespace {

namespace fs = std::filesystem;

constexpr std::array columns{"import", "build", "place", "inspect", "pictures", "lines", "files"};

/// Column of each stage that a Job reports, by what its name begins with; a stage that is not named
/// here counts with the one before it.
const std::map<std::string, std::string, std::less<>>& column_of_stage() {
    static const std::map<std::string, std::string, std::less<>> columns_of{
        {"import", "import"},   {"build", "build"},          {"choose view", "place"},
        {"look", "place"},      {"place", "place"},          {"borders", "inspect"},
        {"seams", "inspect"},   {"measure", "inspect"},      {"knots", "inspect"},
        {"faces", "inspect"},   {"ripples", "inspect"},      {"flaws", "inspect"},
        {"render", "pictures"}, {"silhouettes", "pictures"}, {"creases", "pictures"},
        {"lines", "lines"},     {"joints", "lines"},         {"crossings", "lines"},
        {"run-outs", "lines"},  {"shapes", "lines"},
    };
    return columns_of;
}

/// Processor time of this process and of the workers that it has waited for.
double processor_seconds() {
    rusage workers{};
    getrusage(RUSAGE_CHILDREN, &workers);
    const auto seconds = [](const timeval& t) {
        return static_cast<double>(t.tv_sec) + 1e-6 * static_cast<double>(t.tv_usec);
    };
    return seconds_on(CLOCK_PROCESS_CPUTIME_ID) + seconds(workers.ru_utime) +
           seconds(workers.ru_stime);
}

/// Parts the processor time of a run among the stages that its Job reports. What passes between
/// two reports belongs to the stage of the second: a stage reports when a piece of it is done.
class StageClock {
public:
    StageClock() : last_(processor_seconds()) {}

    Job job() {
        Job job;
        job.progress = [this](const Progress& progress) { report(progress.stage); };
        return job;
    }

    void report(std::string_view stage) {
        // The longest name that a stage begins with; what it is about may follow: "render front".
        for (const auto& [name, column] : column_of_stage())
            if (stage.starts_with(name)) column_ = column;
        add_to(column_);
    }

    void add_to(const std::string& column) {
        const double now = processor_seconds();
        seconds_[column] += now - last_;
        last_ = now;
    }

    const std::map<std::string, double>& seconds() const { return seconds_; }

private:
    double last_;
    std::string column_ = columns.front();
    std::map<std::string, double> seconds_;
};

std::map<std::string, double> inspect_seconds(const fs::path& file, const fs::path& rig) {
    StageClock clock;
    const Job job = clock.job();
    InspectOptions options;
    if (!rig.empty()) options.rig = rig;
    const Scene scene = open_scene(std::array{file}, {}, job);
    const InspectResult result = inspect_scene(scene, options, job);
    clock.add_to("pictures"); // close-ups come last
    const FolderContent content = result_files(fs::path("out"), result);
    if (content.empty()) throw Error(file, "", "its inspection wrote nothing");
    clock.add_to("files");
    return clock.seconds();
}

double mesh_seconds() {
    const TopoDS_Shape car = test::read_shape(test::repository("surfaces/concept-car.step"));
    return brep_mesh(car, 0.1, Vec3(0)).mesh_seconds;
}

std::vector<fs::path> files_of(const InspectBenchmarkOptions& options) {
    std::vector<fs::path> files(options.files.begin(), options.files.end());
    if (!files.empty()) return files;
    files.push_back(test::repository("surfaces/concept-car.step"));
    for (const char* name :
         {"car-hood.brep", "car-front-fender.brep", "car-rear-deck-half-panel.brep",
          "linkrods.step", "hammer.igs", "toy-car-top-shell.step", "subd-bigguy.obj"})
        if (const fs::path file = test::shared_model(name); fs::exists(file)) files.push_back(file);
    return files;
}

std::vector<std::string> row_of(const std::string& name, const std::map<std::string, double>& cost,
                                double unit) {
    double whole = 0;
    for (const auto& [column, seconds] : cost) whole += seconds;
    std::vector<std::string> row{name, digits(whole / unit)};
    for (const char* column : columns) {
        const auto found = cost.find(column);
        row.push_back(digits(found == cost.end() ? 0 : found->second / unit));
    }
    return row;
}

} // namespace

Table run_inspect_benchmark(const InspectBenchmarkOptions& options) {
    tell("concept-car", "OpenCASCADE meshes at 0.1 mm");
    const double unit = mesh_seconds();
    std::array<char, 64> unit_text{};
    std::snprintf(unit_text.data(), unit_text.size(), "inspect, 1 = %.2f s", unit);
    Table table{.head = {unit_text.data(), "whole"}};
    table.head.insert(table.head.end(), columns.begin(), columns.end());
    for (const fs::path& file : files_of(options)) {
        tell(file.filename().string(), "inspect");
        table.rows.push_back(
            row_of(file.filename().string(), inspect_seconds(file, options.rig), unit));
    }
    return table;
}

} // namespace keiko::bench
