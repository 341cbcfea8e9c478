#include "keiko/base/binary_path.h"

#include <dlfcn.h>
#include <link.h>

namespace keiko {
namespace {

/// Any address in the file that this code was linked into.
constexpr char own_data = 0;

} // namespace

std::filesystem::path binary_path() {
    Dl_info info;
    link_map* map = nullptr;
    std::error_code failure;
    const bool found =
        dladdr1(&own_data, &info, reinterpret_cast<void**>(&map), RTLD_DL_LINKMAP) != 0;
    // The program itself has no name in the list of what is loaded. Its link holds where it was
    // started from even if it was built anew meanwhile.
    if (!found || !map || !*map->l_name)
        return std::filesystem::read_symlink("/proc/self/exe", failure);
    const std::filesystem::path file = map->l_name;
    const std::filesystem::path real = std::filesystem::canonical(file, failure);
    return failure ? file : real;
}

} // namespace keiko
