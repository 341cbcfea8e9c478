#pragma once

#include "keiko/base/export.h"
#include "keiko/base/job.h"
#include "keiko/files/model/model_format.h"
#include "keiko/geometry/model/surface_model.h"

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <string>

namespace KEIKO_API keiko {

/// 16 GiB, or the memory of the machine where that is less.
std::uint64_t usual_memory_limit();

/// Knobs of load_model.
struct LoadOptions {
    /// Length unit to read the file's numbers in, whatever the file says; empty: believe it.
    std::string unit;
    /// Axes of the file that point rearwards, to the right and up, "x,-z,y" say; empty: x, y and z.
    std::string axes;
    /// The worker that reads CAD files and cages; empty: $KEIKO_IMPORT, else `keiko-import` beside
    /// the program or library that holds Keiko's code, else in libexec/keiko of its prefix.
    std::filesystem::path worker;
    /// How long the worker may take.
    std::chrono::milliseconds timeout = std::chrono::seconds(120);
    /// How much address space the worker may use, bytes; 0: no limit.
    std::uint64_t memory_limit = usual_memory_limit();
    /// Folder in which models are kept as the worker made them, for the next time; made where it
    /// is missing. Empty: none.
    std::filesystem::path cache;
    /// Size of all models in that folder, bytes: those not used for the longest time are removed
    /// beyond it. 0: no limit.
    std::uint64_t cache_limit = 4ull << 30;
};

/// Reads a model file, its kind found from its content: STEP, IGES, BREP and the cages of OBJ files
/// through a worker process, because OpenCASCADE aborts on some files; .bpt and the teapot text
/// directly. Lengths come back in mm. Reports progress as "import". Faces that could not be
/// converted are in lost_faces.
///
/// Throws Error, one line naming the file and the reason, when the file cannot be read, holds no
/// faces, or changed while it was read into the cache. The same holds when the worker crashes,
/// hangs or needs too much memory. Throws Cancelled when the job is stopped.
SurfaceModel load_model(const std::filesystem::path& path, const LoadOptions& options = {},
                        const Job& job = {});

/// Multiplies all lengths of a model: its control points, tolerances and placements; parameters
/// of faces stay. `factor` > 0.
void scale_lengths(SurfaceModel& model, double factor);

/// The worker executable that the options ask for.
std::filesystem::path worker_path(const LoadOptions& options);

/// Has the worker executable read a CAD file or a cage; it answers as WorkerAnswer says. Throws as
/// load_model does.
SurfaceModel import_in_worker(const std::filesystem::path& path, ModelFormat format,
                              const LoadOptions& options, const Job& job);

} // namespace keiko
