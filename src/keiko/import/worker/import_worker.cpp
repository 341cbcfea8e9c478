#include "keiko/base/build_id.h"
#include "keiko/base/error.h"
#include "keiko/base/text.h"
#include "keiko/files/model/curve_serialization.h"
#include "keiko/files/model/mesh_serialization.h"
#include "keiko/files/model/model_serialization.h"
#include "keiko/import/worker/curve_files.h"
#include "keiko/import/worker/load_model.h"
#include "keiko/import/worker/mesh_in_worker.h"
#include "keiko/import/worker/worker_answer.h"
#include "keiko/import/worker/worker_libraries.h"
#include "keiko/import/worker/worker_process.h"

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <cstring>
#include <sstream>

namespace keiko {
namespace {

namespace fs = std::filesystem;

std::string seconds(std::chrono::milliseconds duration) {
    std::ostringstream text;
    text << static_cast<double>(duration.count()) / 1000 << " s";
    return text.str();
}

/// Some of OpenCASCADE crashes where it gets no memory. A limit counts address space, and a good
/// part of that never becomes memory.
bool short_of_memory(const WorkerExit& exit, const LoadOptions& options) {
    return options.memory_limit > 0 && exit.peak_memory > options.memory_limit / 4;
}

/// The one line about a worker that did not answer. `worker`: "reader" or "mesher".
std::string failure(const std::string& worker, const WorkerExit& exit, const LoadOptions& options) {
    if (exit.timed_out)
        return "the " + worker + " did not finish within " + seconds(options.timeout);
    if (exit.signal != 0)
        return "the " + worker + " crashed on it: " + strsignal(exit.signal) +
               (short_of_memory(exit, options) ? ", perhaps for lack of memory" : "");
    return "the " + worker + (worker == "mesher" ? " gave no mesh" : " gave no model") +
           " (exit code " + std::to_string(exit.code) + ")" +
           (exit.last_complaint.empty() ? "" : ": " + shortened(exit.last_complaint));
}

/// The worker of a program or library in `folder`: beside it, as it is built, or else in libexec of
/// the prefix, whether the folder is bin, lib or lib/TRIPLET. Beside it where there is none.
fs::path installed_worker(const fs::path& folder) {
    const fs::path name = "keiko-import";
    fs::path beside = folder / name;
    std::error_code unknown;
    if (fs::is_regular_file(beside, unknown)) return beside;
    const fs::path prefix = folder.parent_path();
    for (const fs::path& above : {prefix, prefix.parent_path()})
        if (fs::path file = above / "libexec/keiko" / name; fs::is_regular_file(file, unknown))
            return file;
    return beside;
}

/// The format that a name of a file asks for.
std::optional<ModelFormat> curve_format(const fs::path& path) {
    const std::string ending = lower_case(path.extension().string());
    if (ending == ".step" || ending == ".stp") return ModelFormat::step;
    if (ending == ".iges" || ending == ".igs") return ModelFormat::iges;
    return std::nullopt;
}

} // namespace

fs::path worker_path(const LoadOptions& options) {
    if (!options.worker.empty()) return options.worker;
    if (const char* named = std::getenv("KEIKO_IMPORT"); named && *named) return named;
    return installed_worker(binary_path().parent_path());
}

std::vector<std::string> worker_libraries(const LoadOptions& options) {
    const fs::path worker = worker_path(options);
    std::string answer;
    const auto receive = [&](std::string_view bytes) {
        constexpr std::size_t most = 4096; // whatever program stands there
        answer.append(bytes.substr(0, most - std::min(most, answer.size())));
    };
    const auto patience =
        std::min<std::chrono::milliseconds>(options.timeout, std::chrono::seconds(10));
    const WorkerExit exit = run_worker({worker, {"versions"}}, patience, receive, Job{});
    if (exit.timed_out || exit.signal != 0 || exit.code != 0 || answer.empty())
        throw Error(worker.string(), "", "does not state what it reads with");
    std::vector<std::string> libraries;
    std::istringstream lines(answer);
    for (std::string line; std::getline(lines, line);) libraries.push_back(one_line(line));
    return libraries;
}

namespace {

/// The worker's answer to a call about `file`. Throws Error naming `file` for any fault of it.
WorkerAnswer answer_of(const std::string& file, std::vector<std::string> arguments,
                       std::string_view input, const LoadOptions& options, const Job& job) {
    const fs::path worker = worker_path(options);
    std::error_code unknown;
    if (!fs::is_regular_file(worker, unknown))
        throw Error(file, "",
                    std::string(input.empty() ? "cannot be read" : "cannot be written") +
                        ": no reader at " + worker.string());
    WorkerAnswer answer(file, options.memory_limit, job);
    const std::string called = arguments.front() == "mesh" ? "mesher" : "reader";
    const WorkerExit exit = run_worker(
        {worker, std::move(arguments), input}, options.timeout,
        [&](std::string_view bytes) { answer.receive(bytes); }, job);
    const bool ended_well = !exit.timed_out && exit.signal == 0 && exit.code == 0;
    if (answer.reason().empty() && !(ended_well && answer.has_result()))
        throw Error(file, "", failure(called, exit, options));
    return answer;
}

std::vector<std::string> arguments_of(const std::string& file, ModelFormat format,
                                      const LoadOptions& options, const Job& job) {
    return {file, std::string(name_of(format)), std::to_string(options.memory_limit),
            std::to_string(job.threads)};
}

} // namespace

SurfaceModel import_in_worker(const fs::path& path, ModelFormat format, const LoadOptions& options,
                              const Job& job) {
    const auto arguments = arguments_of(path.string(), format, options, job);
    return answer_of(path.string(), arguments, "", options, job).model();
}

ModelMesh mesh_in_worker(const SurfaceModel& model, double deviation, const LoadOptions& options,
                         const Job& job) {
    std::ostringstream limit;
    limit.precision(17);
    limit << deviation;
    const WorkerAnswer answer = answer_of(
        model.source,
        {"mesh", limit.str(), std::to_string(options.memory_limit), std::to_string(job.threads)},
        serialize(model), options, job);
    ModelMesh mesh = deserialize_mesh(answer.result(), model.source);
    if (mesh.size() != model.faces.size())
        throw Error(model.source, "", "its mesh is damaged: it has another number of faces");
    return mesh;
}

bool is_curve_file(const fs::path& path) {
    return curve_format(path).has_value();
}

std::string curve_file(const CurveSet& set, const fs::path& path, const LoadOptions& options,
                       const Job& job) {
    const std::optional<ModelFormat> format = curve_format(path);
    if (!format) throw Error(path.string(), "", "ends in none of .step, .stp, .iges and .igs");
    auto arguments = arguments_of("write-curves", *format, options, job);
    return answer_of(path.string(), std::move(arguments), serialize(set), options, job).result();
}

CurveSet read_curves(const fs::path& path, const LoadOptions& options, const Job& job) {
    const ModelFormat format = detect_model_format(path);
    if (format != ModelFormat::step && format != ModelFormat::iges)
        throw Error(path.string(), "", "curves are read from STEP and IGES files alone");
    auto arguments = arguments_of(path.string(), format, options, job);
    arguments.insert(arguments.begin(), "read-curves");
    const WorkerAnswer answer = answer_of(path.string(), std::move(arguments), "", options, job);
    return deserialize_curves(answer.result(), path.string());
}

} // namespace keiko
