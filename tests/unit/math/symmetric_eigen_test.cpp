#include "keiko/math/symmetric_eigen.h"

#include "tests/support/random.h"
#include <gtest/gtest.h>

#include <algorithm>
#include <numbers>

namespace keiko {
namespace {

TEST(SymmetricEigen, FindsTheValuesOfTheSecondDifference) {
    // Eigenvalues 2 - 2 cos(k pi / 7) of the 6 x 6 matrix (-1, 2, -1).
    SquareMatrix<6> matrix{};
    for (std::size_t i = 0; i < 6; ++i) {
        matrix[i][i] = 2;
        if (i > 0) matrix[i][i - 1] = matrix[i - 1][i] = -1;
    }
    auto values = symmetric_eigen(matrix).values;
    std::sort(values.begin(), values.end());
    for (std::size_t k = 0; k < 6; ++k)
        EXPECT_NEAR(values[k], 2 - 2 * std::cos((double(k) + 1) * std::numbers::pi / 7), 1e-14);
}

TEST(SymmetricEigen, MakesTheMatrixOfItsVectorsAgain) {
    test::Random random(7);
    for (int trial = 0; trial < 100; ++trial) {
        SquareMatrix<6> matrix{};
        for (std::size_t i = 0; i < 6; ++i)
            for (std::size_t j = 0; j <= i; ++j)
                matrix[i][j] = matrix[j][i] = test::uniform(random, -1, 1);
        const SymmetricEigen<6> eigen = symmetric_eigen(matrix);
        for (std::size_t i = 0; i < 6; ++i)
            for (std::size_t j = 0; j < 6; ++j) {
                double sum = 0, product = 0;
                for (std::size_t k = 0; k < 6; ++k) {
                    sum += eigen.values[k] * eigen.vectors[k][i] * eigen.vectors[k][j];
                    product += eigen.vectors[i][k] * eigen.vectors[j][k];
                }
                EXPECT_NEAR(sum, matrix[i][j], 1e-14);
                EXPECT_NEAR(product, i == j ? 1 : 0, 1e-14);
            }
    }
}

TEST(SymmetricEigen, KeepsTheKernelOfASingularMatrix) {
    const SquareMatrix<3> matrix{{{4, 2, 0}, {2, 1, 0}, {0, 0, 0}}}; // (2, 1, 0) with itself
    const SymmetricEigen<3> eigen = symmetric_eigen(matrix);
    int zeros = 0;
    for (std::size_t k = 0; k < 3; ++k) {
        if (std::abs(eigen.values[k]) > 1e-14) continue;
        ++zeros;
        EXPECT_NEAR(2 * eigen.vectors[k][0] + eigen.vectors[k][1], 0, 1e-14);
    }
    EXPECT_EQ(zeros, 2);
}

} // namespace
} // namespace keiko
