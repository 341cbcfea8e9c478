#include "keiko/report/junit_suites.h"
#include "keiko/report/regression.h"

#include <algorithm>
#include <cstdio>

namespace keiko {
namespace {

using Outcome = JunitCase::Outcome;

std::string number(double value) {
    char text[32];
    std::snprintf(text, sizeof text, "%.4g", value);
    return text;
}

/// One case for all metrics of a check.
JunitCase metrics_case(const FixtureOutcome& fixture, const std::string& check) {
    JunitCase one{fixture.name, check, Outcome::pass, "", ""};
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

JunitCase flips_case(const FixtureOutcome& fixture, const PictureOutcome& picture) {
    JunitCase one{fixture.name, picture.view + ": silhouette", Outcome::pass, "", ""};
    if (picture.flips_within) return one;
    one.outcome = Outcome::failure;
    one.message = std::to_string(picture.coverage_flips) + " pixels where the outline moved, " +
                  std::to_string(picture.face_flips) + " with another face, of " +
                  std::to_string(picture.pixels);
    return one;
}

JunitCase layer_case(const FixtureOutcome& fixture, const PictureOutcome& picture,
                     const LayerDifference& layer) {
    JunitCase one{fixture.name, picture.view + ": " + layer.layer, Outcome::pass, "", ""};
    if (layer.within) return one;
    one.outcome = Outcome::failure;
    one.message = std::to_string(layer.beyond) + " pixels beyond the tolerance; the worst, (" +
                  std::to_string(layer.x) + ", " + std::to_string(layer.y) + "), " +
                  number(layer.excess) + " times; largest difference " + number(layer.largest);
    return one;
}

void add_picture(const FixtureOutcome& fixture, const PictureOutcome& picture, JunitSuite& suite) {
    if (!picture.problem.empty()) {
        suite.cases.push_back({fixture.name, picture.view, Outcome::failure, picture.problem, ""});
        return;
    }
    suite.cases.push_back(flips_case(fixture, picture));
    for (const LayerDifference& layer : picture.layers)
        suite.cases.push_back(layer_case(fixture, picture, layer));
}

JunitSuite suite_of(const FixtureOutcome& fixture) {
    JunitSuite suite{fixture.name, {}};
    if (fixture.state == FixtureState::error) {
        suite.cases.push_back({fixture.name, "run", Outcome::error, fixture.error, ""});
        return suite;
    }
    if (fixture.state == FixtureState::missing) {
        suite.cases.push_back({fixture.name, "baseline", Outcome::failure,
                               "there is no baseline; look at the candidate, then accept it with "
                               "--update " +
                                   fixture.name,
                               ""});
        return suite;
    }
    for (const char* check : {"shape", "seams", "lines"})
        suite.cases.push_back(metrics_case(fixture, check));
    for (const PictureOutcome& picture : fixture.pictures) add_picture(fixture, picture, suite);
    return suite;
}

} // namespace

std::string regression_junit(const Regression& regression) {
    std::vector<JunitSuite> suites;
    for (const FixtureOutcome& fixture : regression.fixtures) suites.push_back(suite_of(fixture));
    return junit_xml(suites);
}

} // namespace keiko
