#include "keiko/inspect/seams/continuing_lines.h"

#include <algorithm>

namespace keiko {

std::vector<SeamProbe> ContinuingLines::beyond(std::uint32_t line) const {
    constexpr std::size_t most = 16;
    std::vector<std::uint32_t> lines{line};
    for (std::size_t i = 0; i < lines.size() && lines.size() <= most; ++i)
        for (std::uint32_t other = 0; other < chains_.size() && lines.size() <= most; ++other)
            if (std::find(lines.begin(), lines.end(), other) == lines.end() &&
                go_on(lines[i], other))
                lines.push_back(other);
    std::vector<SeamProbe> probes;
    for (const std::uint32_t other : std::span(lines).subspan(1))
        for (const std::uint32_t piece : chains_[other]) {
            probes.emplace_back(curves_, seams_[piece]);
            probes.back().set_runs_out(runs_out(curves_, seams_[piece]));
        }
    return probes;
}

const std::vector<ContinuingLines::Ends>& ContinuingLines::ends() const {
    std::call_once(made_, [this] {
        for (const std::vector<std::uint32_t>& chain : chains_) {
            Ends& of_line = ends_.emplace_back();
            for (const std::uint32_t piece : chain)
                of_line.push_back(ends_of(curves_, seams_[piece]));
        }
    });
    return ends_;
}

bool ContinuingLines::go_on(std::uint32_t from, std::uint32_t into) const {
    for (const auto& a : ends()[from])
        for (const auto& b : ends()[into])
            if (touch(a, b, join_)) return true;
    return false;
}

} // namespace keiko
