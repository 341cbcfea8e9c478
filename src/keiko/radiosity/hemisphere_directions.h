#pragma once

#include "keiko/math/vec.h"

#include <cstdint>

namespace keiko {

/// Places in a square and directions over a hemisphere, in a sequence whose first 2^k members are
/// spread evenly for each k: a (0,2)-sequence with random bits added [KolligKeller2002], section 3.
class HemisphereDirections {
public:
    /// `seed`: of the random bits. The same seed gives the same sequence.
    explicit HemisphereDirections(std::uint64_t seed);

    /// Place number i of the sequence, 0 to below 1 in both coordinates.
    Vec2 place(std::uint32_t i) const;
    /// Unit direction number i on the side of the unit normal. Its density is the cosine over pi:
    /// each direction brings the same share of uniform light.
    Vec3 direction(std::uint32_t i, const Vec3& normal) const;

private:
    std::uint32_t first_, second_; ///< bits added to both coordinates
};

} // namespace keiko
