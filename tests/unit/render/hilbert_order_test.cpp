#include "keiko/render/reflection/sample_batch.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <set>
#include <utility>

using namespace keiko;

namespace {

/// Steps from place to place along the order that are longer than to a neighbour.
int leaps(const std::vector<GridPlace>& order) {
    int count = 0;
    for (std::size_t i = 0; i + 1 < order.size(); ++i)
        count += std::abs(order[i].x - order[i + 1].x) + std::abs(order[i].y - order[i + 1].y) != 1;
    return count;
}

} // namespace

TEST(HilbertOrder, HasEveryPlaceOfAGridOnce) {
    for (const auto& [width, height] :
         {std::pair(1, 1), std::pair(34, 34), std::pair(34, 26), std::pair(3, 40),
          std::pair(64, 64), std::pair(128, 16), std::pair(34, 34)}) {
        std::set<std::size_t> numbers;
        for (const GridPlace& at : hilbert_order(width, height)) {
            ASSERT_TRUE(0 <= at.x && at.x < width && 0 <= at.y && at.y < height);
            ASSERT_EQ(at.number, static_cast<std::size_t>(at.y * width + at.x));
            numbers.insert(at.number);
        }
        EXPECT_EQ(numbers.size(), static_cast<std::size_t>(width * height));
        EXPECT_EQ(numbers.size(), hilbert_order(width, height).size());
    }
}

TEST(HilbertOrder, GoesFromNeighbourToNeighbour) {
    EXPECT_EQ(leaps(hilbert_order(64, 64)), 0);
    EXPECT_EQ(leaps(hilbert_order(2, 2)), 0);
    EXPECT_LT(leaps(hilbert_order(34, 34)), 34);
    EXPECT_LT(leaps(hilbert_order(128, 16)), 8); // from square to square
}

/// A packet of rays is a square of the picture, where a grid's side lets it be.
TEST(HilbertOrder, KeepsSixteenInASquare) {
    for (const auto& [width, height] : {std::pair(32, 32), std::pair(128, 16)}) {
        const auto& order = hilbert_order(width, height);
        for (std::size_t first = 0; first < order.size(); first += 16)
            for (std::size_t i = first; i < first + 16; ++i) {
                ASSERT_EQ(order[i].x / 4, order[first].x / 4);
                ASSERT_EQ(order[i].y / 4, order[first].y / 4);
            }
    }
}
