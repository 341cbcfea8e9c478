#include "keiko/workflow/curve_output.h"

#include "keiko/base/error.h"
#include "keiko/base/text.h"
#include "keiko/import/worker/curve_files.h"
#include "keiko/report/content/mesh_files.h"

namespace keiko {
namespace {

bool is_vtp(const std::filesystem::path& path) {
    return lower_case(path.extension().string()) == ".vtp";
}

} // namespace

bool is_curve_output(const std::filesystem::path& path) {
    return is_curve_file(path) || is_vtp(path);
}

std::string curve_output(const CurveSet& set, const std::filesystem::path& path,
                         const LoadOptions& options, const Job& job) {
    if (set.curves.empty())
        throw Error(path.string(), "", "is not written: there is no curve to put in it");
    constexpr double chord_error = 0.001; // mm, far below what the curves themselves are within
    return is_vtp(path) ? vtp_file(set, chord_error) : curve_file(set, path, options, job);
}

} // namespace keiko
