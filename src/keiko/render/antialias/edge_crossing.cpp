#include "keiko/render/antialias/edge_crossing.h"

#include "keiko/render/antialias/edge_detection.h"

#include <utility>

namespace keiko {
namespace {

bool is_upright(const Vec2& a, const Vec2& b) {
    return a.x + a.y < b.x + b.y; // sides run along an axis of the picture
}

EdgeCrossing turned(EdgeCrossing side) {
    std::swap(side.a, side.b);
    std::swap(side.at_a, side.at_b);
    return side;
}

} // namespace

EdgeCrossing EdgeCrossing::upright() const {
    return is_upright(a, b) ? *this : turned(*this);
}

void EdgeCrossing::take(const EdgeCrossing& upright) {
    const std::size_t number = side;
    *this = is_upright(a, b) ? upright : turned(upright);
    side = number;
}

void EdgeCrossing::halve(const PixelSample& seen) {
    const bool like_a = !differ_closely(*at_a, seen), like_b = !differ_closely(seen, *at_b);
    if (like_a == like_b) state = like_a ? State::bent : State::tangled;
    (like_a ? a : b) = middle();
    (like_a ? at_a : at_b) = &seen;
}

} // namespace keiko
