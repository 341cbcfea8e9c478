#include "keiko/inspect/basics/curve_chains.h"

#include <algorithm>
#include <optional>

namespace keiko {
namespace {

class Chainer {
public:
    Chainer(std::span<const std::array<Vec3, 2>> ends, double reach)
        : ends_(ends), reach_(reach), taken_(ends.size()) {}

    std::vector<CurveChain> run() {
        std::vector<CurveChain> chains;
        for (std::size_t i = 0; i < ends_.size(); ++i)
            if (!taken_[i]) chains.push_back(chain_from(i));
        return chains;
    }

private:
    const Vec3& head(const ChainLink& link) const { return ends_[link.piece][link.turned ? 1 : 0]; }
    const Vec3& tail(const ChainLink& link) const { return ends_[link.piece][link.turned ? 0 : 1]; }

    bool closed(const CurveChain& chain) const {
        const Vec3 &first = head(chain.links.front()), &last = tail(chain.links.back());
        // A short piece is no loop.
        constexpr double same = 1e-5; // mm
        const bool alone = chain.links.size() == 1;
        return (first - last).length() <= (alone ? std::min(same, reach_) : reach_);
    }

    CurveChain chain_from(std::size_t first) {
        CurveChain chain{{{first, false}}, false};
        taken_[first] = true;
        for (int end = 0; end < 2; ++end) {
            while (!closed(chain)) {
                const auto next = nearest(tail(chain.links.back()));
                if (!next) break;
                taken_[next->piece] = true;
                chain.links.push_back(*next);
            }
            std::reverse(chain.links.begin(), chain.links.end());
            for (ChainLink& link : chain.links) link.turned = !link.turned;
        }
        chain.closed = closed(chain);
        return chain;
    }

    std::optional<ChainLink> nearest(const Vec3& end) const {
        double least = reach_;
        std::optional<ChainLink> found;
        for (std::size_t i = 0; i < ends_.size(); ++i)
            for (const bool turned : {false, true}) {
                if (taken_[i]) continue;
                const double distance = (ends_[i][turned ? 1 : 0] - end).length();
                if (distance > least || (found && distance == least)) continue;
                least = distance, found = ChainLink{i, turned};
            }
        return found;
    }

    std::span<const std::array<Vec3, 2>> ends_;
    double reach_;
    std::vector<bool> taken_;
};

} // namespace

std::vector<CurveChain> chain_curves(std::span<const std::array<Vec3, 2>> ends, double reach) {
    return Chainer(ends, reach).run();
}

} // namespace keiko
