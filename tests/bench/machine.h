#pragma once

#include <string>

namespace keiko::bench {

/// Machine that a run was made on, its compiler and the date.
struct Machine {
    std::string cpu{}, simd{}, compiler{}, date{};
};

Machine this_machine();

} // namespace keiko::bench
