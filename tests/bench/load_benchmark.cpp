#include "tests/bench/load_benchmark.h"

#include "keiko/files/model/model_format.h"
#include "keiko/import/cad/cad_import.h"
#include "keiko/import/worker/load_model.h"

#include "tests/support/paths.h"

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <limits>

namespace keiko::bench {
namespace {

namespace fs = std::filesystem;

/// Files of the collection whose reading takes OpenCASCADE the longest.
constexpr const char* large_files[] = {
    "signal-light-assembly-inch.igs", "nist-pmi-2.step",           "wheel-caster.step",
    "tail-section-assembly.step",     "toy-car-top-shell.step",    "nist-ctc-04-ap203.step",
    "die-cast-housing-degree-5.step", "aircraft-d150-fuselage.igs"};

std::vector<fs::path> files_of(const LoadOptions& options) {
    std::vector<fs::path> files(options.files.begin(), options.files.end());
    if (files.empty())
        for (const char* name : large_files) files.push_back(test::shared_model(name));
    files.erase(std::remove_if(files.begin(), files.end(),
                               [](const fs::path& path) { return !fs::exists(path); }),
                files.end());
    return files;
}

/// Seconds that a call takes, if they are fewer than `best`.
template <class Call>
void time(double& best, const Call& call) {
    const auto start = std::chrono::steady_clock::now();
    call();
    const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - start;
    best = std::min(best, taken.count());
}

void measure(const fs::path& path, LoadCost& cost) {
    cad::CadDocument document;
    time(cost.read, [&] { document = cad::read_document(path, detect_model_format(path)); });
    time(cost.convert, [&] { cost.faces = cad::convert_document(document).faces.size(); });
    time(cost.whole, [&] { load_model(path); });
}

} // namespace

std::vector<LoadCost> run_load_benchmark(const LoadOptions& options) {
    constexpr double not_yet = std::numeric_limits<double>::infinity();
    const std::vector<fs::path> files = files_of(options);
    std::vector<LoadCost> costs;
    for (const fs::path& path : files)
        costs.push_back({path.filename().string(), 0, not_yet, not_yet, not_yet});
    for (int round = 0; round < options.rounds; ++round)
        for (std::size_t i = 0; i < files.size(); ++i) measure(files[i], costs[i]);
    return costs;
}

std::string load_table(const std::vector<LoadCost>& costs) {
    std::string text =
        "| file | faces | OpenCASCADE reads | Keiko converts | together | `load_model` |\n"
        "|---|--:|--:|--:|--:|--:|\n";
    for (const LoadCost& cost : costs) {
        char line[300];
        std::snprintf(line, sizeof line,
                      "| `%s` | %zu | %.2f s | %.2f s | %.2f× | %.2f s, %.2f× |\n",
                      cost.file.c_str(), cost.faces, cost.read, cost.convert,
                      (cost.read + cost.convert) / cost.read, cost.whole, cost.whole / cost.read);
        text += line;
    }
    return text;
}

} // namespace keiko::bench
