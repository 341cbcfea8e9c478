#include "bernstein_fit.h"

#include <math_Gauss.hxx>
#include <math_Matrix.hxx>
#include <math_Vector.hxx>

#include <cmath>
#include <cstddef>
#include <numbers>

namespace keiko::fixtures {
namespace {

double bernstein(int degree, int k, double t) {
    double choose = 1.0;
    for (int i = 1; i <= k; ++i) choose *= static_cast<double>(degree - k + i) / i;
    return choose * std::pow(t, k) * std::pow(1.0 - t, degree - k);
}

} // namespace

std::vector<double> fit_parameters(int degree) {
    std::vector<double> parameters;
    for (int i = 0; i <= degree; ++i)
        parameters.push_back(0.5 * (1.0 - std::cos(std::numbers::pi * i / degree)));
    parameters.front() = 0.0;
    parameters.back() = 1.0;
    return parameters;
}

std::vector<double> bernstein_fit(const std::vector<double>& samples) {
    const int degree = static_cast<int>(samples.size()) - 1;
    const std::vector<double> parameters = fit_parameters(degree);
    math_Matrix system(0, degree, 0, degree);
    math_Vector right(0, degree);
    for (int i = 0; i <= degree; ++i) {
        const auto index = static_cast<std::size_t>(i);
        right(i) = samples[index];
        for (int k = 0; k <= degree; ++k) system(i, k) = bernstein(degree, k, parameters[index]);
    }
    math_Gauss(system).Solve(right);
    std::vector<double> coefficients;
    for (int k = 0; k <= degree; ++k) coefficients.push_back(right(k));
    coefficients.front() = samples.front();
    coefficients.back() = samples.back();
    return coefficients;
}

} // namespace keiko::fixtures
