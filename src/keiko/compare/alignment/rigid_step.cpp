#include "keiko/compare/alignment/rigid_step.h"

#include <cmath>

namespace keiko {
namespace {

double dot(const RigidTwist& a, const RigidTwist& b) {
    double sum = 0;
    for (std::size_t i = 0; i < a.size(); ++i) sum += a[i] * b[i];
    return sum;
}

double trace_of(const SquareMatrix<6>& matrix) {
    double trace = 0;
    for (std::size_t i = 0; i < 6; ++i) trace += matrix[i][i];
    return trace;
}

/// Least-squares solution of matrix x = right without the eigenvectors of at most `least`.
RigidTwist solved(const SquareMatrix<6>& matrix, const RigidTwist& right, double least) {
    const SymmetricEigen<6> eigen = symmetric_eigen(matrix);
    RigidTwist x{};
    for (std::size_t k = 0; k < 6; ++k) {
        if (!(eigen.values[k] > least)) continue;
        const double along = dot(eigen.vectors[k], right) / eigen.values[k];
        for (std::size_t i = 0; i < 6; ++i) x[i] += along * eigen.vectors[k][i];
    }
    return x;
}

} // namespace

void RigidStep::add(const Vec3& place, const Vec3& direction, double distance, double weight) {
    const Vec3 turn = ((place - pivot_) / size_).cross(direction);
    const RigidTwist row{turn.x, turn.y, turn.z, direction.x, direction.y, direction.z};
    for (std::size_t i = 0; i < 6; ++i) {
        for (std::size_t j = 0; j < 6; ++j) matrix_[i][j] += weight * row[i] * row[j];
        right_[i] -= weight * row[i] * distance;
    }
}

std::vector<RigidTwist> RigidStep::free_twists(double share) const {
    const SymmetricEigen<6> eigen = symmetric_eigen(matrix_);
    std::vector<RigidTwist> twists;
    for (std::size_t k = 0; k < 6; ++k)
        if (!(eigen.values[k] > share * trace_of(matrix_))) twists.push_back(eigen.vectors[k]);
    return twists;
}

RigidTwist RigidStep::solution(double share) const {
    return solved(matrix_, right_, share * trace_of(matrix_));
}

RigidTwist RigidStep::solution_within(const std::vector<RigidTwist>& twists) const {
    // In coordinates of the twists; those left over have a row of zeros and stay 0.
    SquareMatrix<6> matrix{};
    RigidTwist right{};
    for (std::size_t k = 0; k < twists.size(); ++k) {
        for (std::size_t l = 0; l < twists.size(); ++l)
            for (std::size_t i = 0; i < 6; ++i)
                matrix[k][l] += twists[k][i] * dot(matrix_[i], twists[l]);
        right[k] = dot(twists[k], right_);
    }
    const RigidTwist along = solved(matrix, right, rounding_share * trace_of(matrix));
    RigidTwist x{};
    for (std::size_t k = 0; k < twists.size(); ++k)
        for (std::size_t i = 0; i < 6; ++i) x[i] += along[k] * twists[k][i];
    return x;
}

Affine RigidStep::motion(const RigidTwist& twist) const {
    const Vec3 turn = Vec3(twist[0], twist[1], twist[2]) / size_;
    const Vec3 shift(twist[3], twist[4], twist[5]);
    const double angle = turn.length();
    if (!(angle > 0)) return Affine::translate(shift);
    const Vec3 axis = turn / angle, along = axis * axis.dot(shift), across = shift - along;
    const double half_sine = std::sin(angle / 2);
    const Vec3 moved = along + across * (std::sin(angle) / angle) +
                       axis.cross(across) * (2 * half_sine * half_sine / angle);
    return Affine::translate(pivot_ + moved) * Affine::rotate(axis, angle) *
           Affine::translate(-pivot_);
}

double length_of(const RigidTwist& twist) {
    return std::sqrt(dot(twist, twist));
}

} // namespace keiko
