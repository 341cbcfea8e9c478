#pragma once

#include "keiko/base/export.h"

namespace KEIKO_API keiko {

/// How a scene is divided into elements that exchange light, and how far that is followed
/// (docs/theory/radiosity.md).
struct RadiositySpec {
    double element = 500;  ///< mm, largest extent of an element on a body, above 0
    double smallest = 100; ///< mm, extent where direct light changes, above 0
    double contrast = 0.1; ///< of direct light between neighbours that are not cut, above 0
    double deviation = 5;  ///< mm that surfaces may leave their elements by, above 0
    int rays = 1024;       ///< from each face of an element, and each corner, 64 to 65536
    double error = 0.001;  ///< share of the reflected light that may be left out, 1e-6 to 0.5

    bool operator==(const RadiositySpec&) const = default;
};

} // namespace keiko
