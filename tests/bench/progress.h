#pragma once

#include <cstdio>
#include <string>

namespace keiko::bench {

/// Tells on stderr what is being done to which scene.
inline void tell(const std::string& scene, const std::string& what) {
    std::fprintf(stderr, "%s: %s\n", scene.c_str(), what.c_str());
}

} // namespace keiko::bench
