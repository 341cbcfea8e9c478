#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

namespace keiko {

/// Numbers of lights, rising.
using Lights = std::vector<std::size_t>;

bool holds(const Lights& lights, std::size_t light);
Lights without(const Lights& lights, const Lights& taken);

Lights united(const Lights& a, const Lights& b);
Lights common(const Lights& a, const Lights& b);

/// How far a light may be off, as a share of the error that is allowed.
struct LightError {
    std::size_t light;
    double error = 0;

    void add(double other) { error = std::max(error, other); }
};

/// Of none of them yet.
std::vector<LightError> errors_in(const Lights& lights);
/// Those of no more than `most`.
Lights within(const std::vector<LightError>& errors, double most);
/// The lights in which there is least doubt, as long as all together are within what is `left` of
/// the error, which they lessen.
Lights least_erroneous(std::vector<LightError> errors, double& left);

} // namespace keiko
