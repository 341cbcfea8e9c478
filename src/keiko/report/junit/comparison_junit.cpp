#include "keiko/report/content/comparison.h"
#include "keiko/report/junit/junit.h"

namespace keiko {
namespace {

using Outcome = JunitCase::Outcome;

JunitCase case_of(const std::string& class_name, const ComparisonCheck& check) {
    JunitCase one = judged_case(class_name, check.name, check.within, check.message);
    if (!check.judged) one.outcome = Outcome::skipped;
    return one;
}

} // namespace

std::string comparison_junit(const Comparison& c) {
    JunitSuite suite{c.after, {}, {{"before", c.before}, {"after", c.after}}};
    for (const ComparisonCheck& check : comparison_checks(c))
        suite.cases.push_back(case_of(c.after, check));
    for (const Check& finding : c.seams.new_findings)
        suite.cases.push_back(check_case(c.after, finding));
    for (const ComparedView& view : c.views) add_picture_cases(view.picture, c.after, suite);
    return junit_xml(std::vector{std::move(suite)});
}

} // namespace keiko
