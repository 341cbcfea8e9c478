#include "keiko/report/junit/junit.h"

#include "keiko/report/content/check_place.h"

#include <map>

namespace keiko {
namespace {

using Outcome = JunitCase::Outcome;

JunitCase case_of(const std::string& source, const LostFace& face) {
    return {source, "face " + std::to_string(face.id) + ": read", Outcome::error, face.reason, "",
            "lost"};
}

} // namespace

JunitCase check_case(const std::string& source, const Check& check) {
    JunitCase one{source, subject_of(check) + ": " + check.quantity};
    if (!check.judged) {
        one.outcome = Outcome::skipped, one.message = check.message;
    } else if (check.is_finding()) {
        one.outcome = check.worst.verdict == Verdict::fail ? Outcome::failure : Outcome::error;
        one.type = check.code, one.message = check.message, one.details = placed_message(check);
    }
    return one;
}

std::string junit_xml(const Inspection& inspection) {
    const std::string& source = inspection.facts.source;
    JunitSuite suite{source,
                     {},
                     {{"preset", inspection.preset.name},
                      {"source", inspection.preset.source},
                      {"verdict", std::string(name_of(inspection.verdict))}}};
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

} // namespace keiko
