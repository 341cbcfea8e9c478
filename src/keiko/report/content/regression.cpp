#include "keiko/report/content/regression.h"

#include "keiko/base/text.h"

#include <algorithm>

namespace keiko {

std::string_view name_of(FixtureState state) {
    constexpr std::array<std::string_view, 4> names{"same", "different", "missing", "error"};
    return names[static_cast<std::size_t>(state)];
}

std::size_t Regression::count(FixtureState state) const {
    return static_cast<std::size_t>(
        std::count_if(fixtures.begin(), fixtures.end(),
                      [&](const FixtureOutcome& fixture) { return fixture.state == state; }));
}

FixtureState Regression::state() const {
    FixtureState worst = stale_baselines.empty() ? FixtureState::same : FixtureState::different;
    for (const FixtureOutcome& fixture : fixtures) worst = std::max(worst, fixture.state);
    return worst;
}

std::string summary_of(const Regression& regression) {
    std::string text = counted(regression.fixtures.size(), "fixture");
    for (const FixtureState state : every_fixture_state)
        text += ", " + std::to_string(regression.count(state)) + " " + std::string(name_of(state));
    return text;
}

} // namespace keiko
