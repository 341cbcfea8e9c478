#include "keiko/visibility/query/visibility_query.h"

#include "keiko/visibility/query/occluder_candidates.h"

namespace keiko {

VisibilityQuery::VisibilityQuery(const Occluders& occluders, const Tracer& tracer,
                                 const Viewpoint& viewpoint, std::span<const Vec3> region,
                                 const std::optional<Vec3>& facing)
    : candidates_(std::make_unique<OccluderCandidates>(*occluders.scene_, tracer, viewpoint, region,
                                                       facing)) {}

VisibilityQuery::~VisibilityQuery() = default;
VisibilityQuery::VisibilityQuery(VisibilityQuery&&) noexcept = default;
VisibilityQuery& VisibilityQuery::operator=(VisibilityQuery&&) noexcept = default;

VisibleIntervals VisibilityQuery::intervals(const Segment& segment) const {
    return candidates_->intervals(segment);
}

std::vector<VisibleIntervals> VisibilityQuery::intervals(std::span<const Segment> row) const {
    if (auto parts = candidates_->intervals_of_row(row)) return std::move(*parts);
    std::vector<VisibleIntervals> parts;
    for (const Segment& ends : row) parts.push_back(candidates_->intervals(ends));
    return parts;
}

std::vector<std::optional<bool>> VisibilityQuery::classify_prisms(
    std::span<const Prism> prisms) const {
    return candidates_->classify_prisms(prisms);
}

std::vector<CriticalSlice> VisibilityQuery::turns(const Prism& prism, const TurnRule& rule) const {
    return candidates_->turns(prism, rule);
}

} // namespace keiko
