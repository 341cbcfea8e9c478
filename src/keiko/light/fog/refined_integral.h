#pragma once

#include "keiko/base/job.h"
#include "keiko/math/quadrature.h"
#include "keiko/math/rgb.h"

#include <algorithm>
#include <cmath>
#include <span>
#include <utility>
#include <vector>

namespace keiko {

/// Integral of a colour over pieces of a line, each smooth inside, by Gauss quadrature. Rules of
/// `order` and of twice as many nodes are compared on each piece. The piece with the largest
/// difference is halved until all differences together are within the tolerance.
template <class F>
class RefinedIntegral {
public:
    /// `tolerance`: of the whole integral.
    RefinedIntegral(const F& f, double tolerance) : f_(f), tolerance_(tolerance) {}

    /// Integral over the pieces between neighbouring `ends`, which rise.
    Rgb operator()(std::span<const double> ends) {
        pieces_.clear();
        error_ = 0;
        order_ = order_of(ends.size() - 1);
        double scale = 0;
        for (std::size_t i = 0; i + 1 < ends.size(); ++i) {
            add(ends[i], ends[i + 1], 0);
            scale += max_channel(pieces_.back().sum);
        }
        std::make_heap(pieces_.begin(), pieces_.end());
        while (error_ > tolerance_ * scale && pieces_.front().error > 0) halve_worst();
        Rgb sum;
        for (const Piece& piece : pieces_) sum += piece.sum;
        return sum;
    }

private:
    static constexpr int most_halvings = 12;

    struct Piece {
        double a, b;
        Rgb sum;
        double error;
        int halvings;

        bool operator<(const Piece& other) const { return error < other.error; }
    };

    /// Order of the rule; between the many kinks of a table a low one suffices.
    int order_of(std::size_t pieces) const {
        constexpr std::size_t many = 6;
        return tolerance_ < 1e-6 ? 8 : pieces > many ? 2 : tolerance_ < 1e-4 ? 4 : 3;
    }

    void add(double a, double b, int halvings) {
        check_stop();
        const Rgb fine = integrate(f_, a, b, 2 * order_);
        const Rgb off = fine - integrate(f_, a, b, order_);
        // A piece that cannot be halved any more counts as accurate.
        const bool last = halvings == most_halvings;
        const double error =
            last ? 0 : std::max({std::abs(off.r), std::abs(off.g), std::abs(off.b)});
        pieces_.push_back({a, b, fine, error, halvings});
        error_ += error;
    }

    void halve_worst() {
        std::pop_heap(pieces_.begin(), pieces_.end());
        const Piece worst = pieces_.back();
        pieces_.pop_back();
        error_ -= worst.error;
        const double middle = (worst.a + worst.b) / 2;
        for (const auto& [a, b] : {std::pair(worst.a, middle), std::pair(middle, worst.b)}) {
            add(a, b, worst.halvings + 1);
            std::push_heap(pieces_.begin(), pieces_.end());
        }
    }

    const F& f_;
    double tolerance_;
    int order_ = 0;
    std::vector<Piece> pieces_;
    double error_ = 0; ///< of all pieces
};

} // namespace keiko
