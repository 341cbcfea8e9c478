#pragma once

#include "keiko/base/export.h"
#include "keiko/import/worker/load_model.h"

#include <filesystem>
#include <string>
#include <vector>

namespace KEIKO_API keiko {

/// Facts on this build of Keiko and on what it runs with, as a report of a defect needs them.
struct BuildFacts {
    std::string version;          ///< "0.1.0"
    std::string build_id;         ///< the linker's hash of the contents, hexadecimal
    std::string compiler;         ///< "GCC 12.2.0"
    std::string instruction_set;  ///< set that the kernels for rays use, as Highway has it: "AVX2"
    std::filesystem::path worker; ///< program that reads CAD files and cages
    std::string worker_fault;     ///< why that program does not answer; empty: it does
    std::vector<std::string> libraries; ///< loaded ones, with versions: "Embree 3.13.5"
};

/// Facts on the running build. The worker is started to name its libraries; a missing worker is one
/// of the facts. Throws Error where Keiko was linked without a build id.
BuildFacts build_facts(const LoadOptions& options = {});

/// The facts as lines of text, a name and a value each.
std::string build_text(const BuildFacts& facts);

} // namespace keiko
