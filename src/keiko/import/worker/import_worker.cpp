#include "keiko/import/worker/import_worker.h"

#include "keiko/base/error.h"
#include "keiko/import/worker/worker_answer.h"
#include "keiko/import/worker/worker_process.h"

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

/// Some of OpenCASCADE crashes where it gets no memory. A limit counts address space, of which a
/// good part never becomes memory.
bool short_of_memory(const WorkerExit& exit, const LoadOptions& options) {
    return options.memory_limit > 0 && exit.peak_memory > options.memory_limit / 4;
}

/// The one line about a worker that did not answer.
std::string failure(const WorkerExit& exit, const LoadOptions& options) {
    if (exit.timed_out) return "the reader did not finish within " + seconds(options.timeout);
    if (exit.signal != 0)
        return std::string("the reader crashed on it: ") + strsignal(exit.signal) +
               (short_of_memory(exit, options) ? ", perhaps for lack of memory" : "");
    return "the reader gave no model (exit code " + std::to_string(exit.code) + ")" +
           (exit.last_complaint.empty() ? "" : ": " + shortened(exit.last_complaint));
}

} // namespace

fs::path worker_path(const LoadOptions& options) {
    if (!options.worker.empty()) return options.worker;
    if (const char* named = std::getenv("KEIKO_IMPORT"); named && *named) return named;
    std::error_code none;
    return fs::read_symlink("/proc/self/exe", none).parent_path() / "keiko-import";
}

SurfaceModel import_in_worker(const fs::path& path, ModelFormat format, const LoadOptions& options,
                              const Job& job) {
    const fs::path worker = worker_path(options);
    std::error_code unknown;
    if (!fs::is_regular_file(worker, unknown))
        throw Error(path.string(), "", "cannot be read: no reader at " + worker.string());
    WorkerAnswer answer(path.string(), options.memory_limit, job);
    const WorkerExit exit = run_worker(
        worker,
        {path.string(), std::string(name_of(format)), std::to_string(options.memory_limit),
         std::to_string(job.threads)},
        options.timeout, [&](std::string_view bytes) { answer.receive(bytes); }, job);
    const bool ended_well = !exit.timed_out && exit.signal == 0 && exit.code == 0;
    if (answer.reason().empty() && !(ended_well && answer.has_model()))
        throw Error(path.string(), "", failure(exit, options));
    return answer.model();
}

} // namespace keiko
