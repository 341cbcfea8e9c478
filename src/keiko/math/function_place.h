#pragma once

namespace keiko {

/// A place of a function and its value there.
struct FunctionPlace {
    double at = 0;    ///< argument of the function
    double value = 0; ///< of the function there
};

} // namespace keiko
