#include "keiko/report/content/regression.h"
#include "keiko/report/markup/junit_suites.h"

namespace keiko {
namespace {

using Outcome = JunitCase::Outcome;

constexpr const char* stale_reason =
    "the baseline is stale: no fixture has its name; put the fixture back or remove the baseline";

/// One case for all metrics of a check.
JunitCase metrics_case(const FixtureOutcome& fixture, const std::string& check) {
    JunitCase one{fixture.name, check};
    std::size_t count = 0;
    for (const MetricDifference& metric : fixture.metrics) {
        if (metric.check != check) continue;
        if (count++ == 0) one.message = text_of(metric);
        one.details += text_of(metric) + "\n";
    }
    if (count == 0) return one;
    one.outcome = Outcome::failure;
    if (count > 1) one.message += " (and " + std::to_string(count - 1) + " more)";
    return one;
}

JunitSuite suite_of(const FixtureOutcome& fixture) {
    JunitSuite suite{fixture.name, {}};
    if (fixture.state == FixtureState::error) {
        suite.cases.push_back({fixture.name, "run", Outcome::error, fixture.error});
        return suite;
    }
    if (fixture.state == FixtureState::missing) {
        suite.cases.push_back(
            judged_case(fixture.name, "baseline", false,
                        "there is no baseline; inspect the candidate, then accept it by the "
                        "name " +
                            fixture.name));
        return suite;
    }
    for (const std::string& check : fixture.checks)
        suite.cases.push_back(metrics_case(fixture, check));
    for (const PictureOutcome& picture : fixture.pictures)
        add_picture_cases(picture, fixture.name, suite);
    return suite;
}

} // namespace

std::string regression_junit(const Regression& regression) {
    std::vector<JunitSuite> suites;
    for (const FixtureOutcome& fixture : regression.fixtures) suites.push_back(suite_of(fixture));
    for (const std::string& name : regression.stale_baselines)
        suites.push_back({name, {judged_case(name, "fixture", false, stale_reason)}});
    return junit_xml(suites);
}

} // namespace keiko
