#include "keiko/workflow/build_facts.h"

#include "keiko/base/build_id.h"
#include "keiko/base/error.h"
#include "keiko/base/tbb_version.h"
#include "keiko/base/text.h"
#include "keiko/film/openimageio_version.h"
#include "keiko/import/worker/worker_libraries.h"
#include "keiko/intersect/kernels/sub_patch_kernels.h"
#include "keiko/intersect/traversal/embree_scene.h"
#include "keiko/workflow/version.h"

namespace keiko {
namespace {

#if defined(__clang__)
constexpr const char* compiler = "Clang " __clang_version__;
#else
constexpr const char* compiler = "GCC " __VERSION__;
#endif

} // namespace

BuildFacts build_facts(const LoadOptions& options) {
    BuildFacts facts{.version = version(),
                     .build_id = build_id(),
                     .compiler = compiler,
                     .instruction_set = sub_patch_kernels().name,
                     .worker = worker_path(options),
                     .worker_fault = "",
                     .libraries = {"Embree " + embree_version(), "oneTBB " + tbb_version(),
                                   "OpenImageIO " + openimageio_version()}};
    try {
        for (std::string& library : worker_libraries(options))
            facts.libraries.push_back(std::move(library));
    } catch (const Error& error) {
        facts.worker_fault = error.reason();
    }
    return facts;
}

std::string build_text(const BuildFacts& facts) {
    TextLines lines;
    lines.line("version") << facts.version;
    lines.line("build id") << facts.build_id;
    lines.line("compiler") << facts.compiler;
    lines.line("SIMD") << facts.instruction_set;
    std::ostream& worker = lines.line("reader");
    worker << facts.worker.string();
    if (!facts.worker_fault.empty()) worker << ": " << facts.worker_fault;
    for (const std::string& library : facts.libraries) lines.line("library") << library;
    return lines.text();
}

} // namespace keiko
