#include "keiko/inspect/seams/isoline_places.h"

#include <cmath>
#include <numbers>

namespace keiko {

std::vector<double> isoline_places(int count) {
    std::vector<double> places;
    for (int i = 0; i < count; ++i)
        places.push_back((1 - std::cos(std::numbers::pi * (i + 0.5) / count)) / 2);
    return places;
}

} // namespace keiko
