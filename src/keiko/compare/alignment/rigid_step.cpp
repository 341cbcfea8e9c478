#include "keiko/compare/alignment/rigid_step.h"

#include <cmath>

namespace keiko {

void RigidStep::add(const Vec3& place, const Vec3& direction, double distance, double weight) {
    const Vec3 turn = ((place - pivot_) / size_).cross(direction);
    const std::array<double, 6> row{turn.x, turn.y, turn.z, direction.x, direction.y, direction.z};
    for (std::size_t i = 0; i < 6; ++i) {
        for (std::size_t j = 0; j < 6; ++j) matrix_[i][j] += weight * row[i] * row[j];
        right_[i] -= weight * row[i] * distance;
    }
}

/// Cholesky's decomposition of the matrix with a little of its trace on the diagonal, so that what
/// is free does not move.
std::array<double, 6> RigidStep::solution() const {
    double trace = 0;
    for (std::size_t i = 0; i < 6; ++i) trace += matrix_[i][i];
    std::array<double, 6> x{};
    if (!(trace > 0)) return x;
    constexpr double damping = 1e-13;
    auto l = matrix_;
    for (std::size_t i = 0; i < 6; ++i) {
        l[i][i] += damping * trace;
        for (std::size_t j = 0; j <= i; ++j) {
            double sum = l[i][j];
            for (std::size_t k = 0; k < j; ++k) sum -= l[i][k] * l[j][k];
            l[i][j] = i == j ? std::sqrt(std::max(sum, damping * trace)) : sum / l[j][j];
        }
    }
    for (std::size_t i = 0; i < 6; ++i) {
        x[i] = right_[i];
        for (std::size_t k = 0; k < i; ++k) x[i] -= l[i][k] * x[k];
        x[i] /= l[i][i];
    }
    for (std::size_t i = 6; i-- > 0;) {
        for (std::size_t k = i + 1; k < 6; ++k) x[i] -= l[k][i] * x[k];
        x[i] /= l[i][i];
    }
    return x;
}

Affine RigidStep::motion() const {
    const std::array<double, 6> x = solution();
    const Vec3 turn = Vec3(x[0], x[1], x[2]) / size_, shift(x[3], x[4], x[5]);
    const Affine turned = turn == Vec3(0) ? Affine{} : Affine::rotate(turn, turn.length());
    return Affine::translate(pivot_ + shift) * turned * Affine::translate(-pivot_);
}

double RigidStep::length() const {
    double square = 0;
    for (const double x : solution()) square += x * x;
    return std::sqrt(square);
}

} // namespace keiko
