#include "keiko/report/junit_suites.h"

#include "keiko/report/html_text.h"
#include "keiko/report/xml_attribute.h"

#include <algorithm>

namespace keiko {
namespace {

using Outcome = JunitCase::Outcome;

std::size_t count(const JunitSuite& suite, Outcome outcome) {
    return static_cast<std::size_t>(
        std::count_if(suite.cases.begin(), suite.cases.end(),
                      [&](const JunitCase& one) { return one.outcome == outcome; }));
}

std::string counts(std::size_t tests, std::size_t failures, std::size_t errors) {
    return xml_attribute("tests", std::to_string(tests)) +
           xml_attribute("failures", std::to_string(failures)) +
           xml_attribute("errors", std::to_string(errors));
}

std::string lines_escaped(const std::string& text) {
    std::string escaped;
    for (std::size_t begin = 0; begin < text.size();) {
        const std::size_t end = std::min(text.find('\n', begin), text.size());
        escaped += html_escaped(std::string_view(text).substr(begin, end - begin)) + "\n";
        begin = end + 1;
    }
    return escaped;
}

std::string case_xml(const JunitCase& one) {
    const std::string head = "    <testcase" + xml_attribute("classname", one.class_name) +
                             xml_attribute("name", one.name);
    if (one.outcome == Outcome::pass) return head + "/>\n";
    const std::string element = one.outcome == Outcome::failure ? "failure" : "error";
    return head + ">\n      <" + element + xml_attribute("message", one.message) + ">" +
           lines_escaped(one.details) + "</" + element + ">\n    </testcase>\n";
}

} // namespace

std::string junit_xml(const std::vector<JunitSuite>& suites) {
    std::size_t tests = 0, failures = 0, errors = 0;
    std::string body;
    for (const JunitSuite& suite : suites) {
        const std::size_t failed = count(suite, Outcome::failure),
                          broken = count(suite, Outcome::error);
        body += "  <testsuite" + xml_attribute("name", suite.name) +
                counts(suite.cases.size(), failed, broken) + ">\n";
        for (const JunitCase& one : suite.cases) body += case_xml(one);
        body += "  </testsuite>\n";
        tests += suite.cases.size(), failures += failed, errors += broken;
    }
    return "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuites" +
           xml_attribute("name", "keiko") + counts(tests, failures, errors) + ">\n" + body +
           "</testsuites>\n";
}

} // namespace keiko
