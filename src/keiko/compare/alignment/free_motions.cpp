#include "keiko/compare/alignment/free_motions.h"

#include "keiko/math/symmetric_eigen.h"

namespace keiko {
namespace {

/// Projects onto the eigenvectors of at least `least`.
SquareMatrix<3> projector(const SquareMatrix<3>& matrix, double least) {
    const SymmetricEigen<3> eigen = symmetric_eigen(matrix);
    SquareMatrix<3> onto{};
    for (std::size_t k = 0; k < 3; ++k)
        for (std::size_t i = 0; i < 3 && eigen.values[k] >= least; ++i)
            for (std::size_t j = 0; j < 3; ++j)
                onto[i][j] += eigen.vectors[k][i] * eigen.vectors[k][j];
    return onto;
}

/// Basis of what a projector projects onto: from the axis that it shortens least on.
std::vector<Vec3> basis_of(SquareMatrix<3> onto) {
    constexpr double least = 1.0 / 6; // of rank r it has an entry of r / 3 or more on the diagonal
    std::vector<Vec3> basis;
    while (basis.size() < 3) {
        std::size_t best = 0;
        for (std::size_t i = 1; i < 3; ++i)
            if (onto[i][i] > onto[best][best] * (1 + 1e-9)) best = i;
        if (onto[best][best] < least) break;
        const Vec3 found = Vec3(onto[best][0], onto[best][1], onto[best][2]).normalized();
        for (unsigned i = 0; i < 3; ++i)
            for (unsigned j = 0; j < 3; ++j) onto[i][j] -= found[i] * found[j];
        basis.push_back(found);
    }
    return basis;
}

/// A block of the sum of the twists' products with themselves.
SquareMatrix<3> block_of(std::span<const std::array<double, 6>> twists, std::size_t first) {
    SquareMatrix<3> block{};
    for (const std::array<double, 6>& twist : twists)
        for (std::size_t i = 0; i < 3; ++i)
            for (std::size_t j = 0; j < 3; ++j) block[i][j] += twist[first + i] * twist[first + j];
    return block;
}

} // namespace

FreeMotions free_motions(std::span<const std::array<double, 6>> twists) {
    // The sum is the projector onto the twists. A shift is a twist of it without a turn, so that
    // the block of shifts leaves it as it is; what turns at all is a turn.
    constexpr double turned = 1e-3; // square of a turn in a unit twist
    return {.shifts = basis_of(projector(block_of(twists, 3), 1 - turned)),
            .turns = basis_of(projector(block_of(twists, 0), turned))};
}

} // namespace keiko
