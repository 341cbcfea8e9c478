#include "keiko/report/content/acceptance_texts.h"
#include "keiko/report/content/comparison.h"
#include "keiko/report/content/inspection_texts.h"
#include "keiko/report/content/regression.h"
#include "keiko/report/content/scope_texts.h"
#include "keiko/report/markup/junit_suites.h"

#include <map>

namespace keiko {
namespace {

using Outcome = JunitCase::Outcome;

JunitCase case_of(const std::string& source, const LostFace& face) {
    return {source, "face " + std::to_string(face.id) + ": read", Outcome::error, face.reason, "",
            "lost"};
}

/// Case of a check, for the file that it was made on.
JunitCase check_case(const std::string& source, const Check& check) {
    JunitCase one{source, subject_of(check) + ": " + check.quantity};
    if (!check.judged) {
        one.outcome = Outcome::skipped, one.message = check.message;
    } else if (check.accepted) {
        one.outcome = Outcome::skipped;
        one.message = "accepted: " + text_of(*check.accepted) + "; " + check.message;
    } else if (check.is_finding()) {
        one.outcome = check.worst.verdict == Verdict::fail ? Outcome::failure : Outcome::error;
        one.type = check.code, one.message = check.message, one.details = placed_message(check);
    }
    return one;
}

JunitCase case_of(const std::string& class_name, const ComparisonCheck& check) {
    JunitCase one = judged_case(class_name, check.name, check.within, check.message);
    if (!check.judged) one.outcome = Outcome::skipped;
    return one;
}

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

std::string junit_xml(const Inspection& inspection) {
    const std::string& source = inspection.facts.source;
    JunitSuite suite{source,
                     {},
                     {{"preset", inspection.preset.name},
                      {"source", inspection.preset.source},
                      {"verdict", std::string(name_of(inspection.verdict))}}};
    for (const std::string& sentence : scope_sentences(inspection.scope, inspection.preset))
        suite.properties.emplace_back("scope", sentence);
    for (const AcceptanceRemark& remark : inspection.acceptance_remarks)
        suite.properties.emplace_back("acceptance", text_of(remark));
    for (const LostFace& face : inspection.facts.lost_faces)
        suite.cases.push_back(case_of(source, face));
    std::map<std::string, int> uses;
    for (const Check& check : inspection.checks) {
        suite.cases.push_back(check_case(source, check));
        // A face may have several dents; the deepest comes first and keeps its name between runs.
        std::string& name = suite.cases.back().name;
        if (const int use = ++uses[name]; use > 1) name += " " + std::to_string(use);
    }
    return junit_xml(std::vector{std::move(suite)});
}

std::string comparison_junit(const Comparison& c) {
    JunitSuite suite{c.after, {}, {{"before", c.before}, {"after", c.after}}};
    for (const std::string& sentence :
         scope_sentences(c.inspection_after.scope, c.inspection_after.preset))
        suite.properties.emplace_back("scope", sentence);
    for (const ComparisonCheck& check : comparison_checks(c))
        suite.cases.push_back(case_of(c.after, check));
    for (const Check& finding : c.seams.new_findings)
        suite.cases.push_back(check_case(c.after, finding));
    for (const ComparedView& view : c.views) add_picture_cases(view.picture, c.after, suite);
    return junit_xml(std::vector{std::move(suite)});
}

std::string regression_junit(const Regression& regression) {
    std::vector<JunitSuite> suites;
    for (const FixtureOutcome& fixture : regression.fixtures) suites.push_back(suite_of(fixture));
    for (const std::string& name : regression.stale_baselines)
        suites.push_back({name, {judged_case(name, "fixture", false, stale_reason)}});
    return junit_xml(suites);
}

} // namespace keiko
