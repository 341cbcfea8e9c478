#include "keiko/base/tbb_version.h"

#include <tbb/version.h>

namespace keiko {

std::string tbb_version() {
    return TBB_runtime_version();
}

} // namespace keiko
