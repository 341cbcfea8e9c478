#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <stdexcept>

namespace keiko {

/// A range in the pieces between some places.
class Breakpoints {
public:
    static constexpr std::size_t most_pieces = 9;

    Breakpoints(double begin, double end) : places_{begin, end} {}

    /// Places outside of the range do not count. Throws std::length_error for more than
    /// `most_pieces`.
    void cut_at(double x) {
        if (!(x > places_[0] && x < places_[last_])) return;
        if (last_ + 1 == places_.size()) throw std::length_error("a range of too many pieces");
        std::size_t at = ++last_;
        for (; places_[at - 1] > x; --at) places_[at] = places_[at - 1];
        places_[at] = x;
    }
    /// Begin, cuts and end, rising.
    std::span<const double> places() const { return std::span(places_).first(last_ + 1); }

private:
    std::array<double, most_pieces + 1> places_{};
    std::size_t last_ = 1;
};

/// Sum of `f(a, b)` over the pieces from begin to end.
template <class F>
auto sum_over_pieces(const Breakpoints& range, const F& f) {
    const std::span<const double> places = range.places();
    auto sum = f(places[0], places[1]);
    for (std::size_t i = 1; i + 1 < places.size(); ++i) sum += f(places[i], places[i + 1]);
    return sum;
}

} // namespace keiko
