#pragma once

#include "keiko/base/new_file.h"

#include <string>

namespace keiko::test {

/// Temporary name of a process of this machine that does not run: a writer that was killed.
inline std::string abandoned_name() {
    const std::string own = temporary_name();
    return ".keiko-999999999" + own.substr(own.find('-', std::string(".keiko-").size()));
}

} // namespace keiko::test
