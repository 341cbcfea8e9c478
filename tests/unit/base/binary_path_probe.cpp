#include "keiko/base/build_id.h"

#include <cstddef>

/// Path of the shared library that this is compiled into, a character a call; 0 behind the last.
extern "C" char keiko_binary_path_character(std::size_t index) {
    const std::string path = keiko::binary_path().string();
    return index < path.size() ? path[index] : '\0';
}
