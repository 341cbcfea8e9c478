#include "keiko/base/build_id.h"

#include <cstddef>

/// Build id of the shared library that this is compiled into, a digit a call; 0 behind the last.
extern "C" char keiko_build_id_digit(std::size_t index) {
    const std::string id = keiko::build_id();
    return index < id.size() ? id[index] : '\0';
}
