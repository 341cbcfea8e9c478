#pragma once

#include <string>

namespace keiko::bench {

/// Where and with what a run was made.
struct Machine {
    std::string cpu{}, simd{}, compiler{}, date{};
};

Machine this_machine();

} // namespace keiko::bench
