#include "keiko/report/comparison.h"

namespace keiko {
namespace {

using Outcome = JunitCase::Outcome;

JunitCase case_of(const std::string& class_name, const ComparisonCheck& check) {
    JunitCase one{class_name, check.name};
    if (!check.within) one.outcome = Outcome::failure, one.message = check.message;
    return one;
}

/// Findings of the latter that the former did not have, a case each.
void add_findings(const Comparison& c, JunitSuite& suite) {
    for (const Check& finding : c.seams.new_findings)
        suite.cases.push_back({c.after, finding.faces + ": " + finding.quantity, Outcome::failure,
                               finding.message, "", finding.code});
}

} // namespace

std::string comparison_junit(const Comparison& c) {
    JunitSuite suite{c.after, {}, {{"before", c.before}, {"after", c.after}}};
    for (const ComparisonCheck& check : comparison_checks(c))
        suite.cases.push_back(case_of(c.after, check));
    add_findings(c, suite);
    for (const ComparedView& view : c.views) add_picture_cases(view.picture, c.after, suite);
    return junit_xml(std::vector{std::move(suite)});
}

} // namespace keiko
