#pragma once

#include "keiko/base/export.h"

namespace KEIKO_API keiko {

/// How a scene is divided into elements that exchange light, and how far that is followed
/// (docs/theory/radiosity.md).
struct RadiositySpec {
    double element = 500;   ///< mm, longest side of an element on a body, above 0
    double smallest = 100;  ///< mm, longest side where direct light changes, above 0
    double contrast = 0.25; ///< of direct light between neighbours, above 0; beyond it they are cut
    double deviation = 5;   ///< mm that surfaces may leave their elements by, above 0
    int cells = 64;         ///< along an edge of the hemicube, even, 8 to 1024
    double error = 0.01;    ///< share of the reflected light that may be left out, 1e-6 to 0.5

    bool operator==(const RadiositySpec&) const = default;
};

} // namespace keiko
