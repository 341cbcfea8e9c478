#include "keiko/workflow/version.h"

namespace keiko {

std::string version() {
    return KEIKO_VERSION;
}

} // namespace keiko
