#pragma once

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <vector>

namespace keiko {

/// Sets of the numbers 0 to count - 1, each by itself at first (union by the lower number, with
/// path halving) [Tarjan1975].
class DisjointSets {
public:
    /// Sets of one number each, for the numbers 0 to `count` - 1.
    explicit DisjointSets(std::size_t count) : parents_(count) {
        std::iota(parents_.begin(), parents_.end(), std::size_t{0});
    }
    /// The lowest number of the set that holds `i`.
    std::size_t root(std::size_t i) {
        while (parents_[i] != i) i = parents_[i] = parents_[parents_[i]];
        return i;
    }
    /// Joins the sets that hold `a` and `b`, which may be one.
    void join(std::size_t a, std::size_t b) {
        a = root(a), b = root(b);
        parents_[std::max(a, b)] = std::min(a, b);
    }

private:
    std::vector<std::size_t> parents_;
};

} // namespace keiko
