#pragma once

#include "keiko/report/content/regression.h"

#include <optional>

namespace keiko {

/// Tells how a fixture's record is held against its baseline, with pictures of what differs, or of
/// all views where there is no baseline.
FixtureOutcome fixture_outcome(const FixtureSpec& spec, const FixtureRecord* baseline,
                               const FixtureRecord& candidate);

} // namespace keiko
