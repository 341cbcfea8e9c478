#include "keiko/report/markup/junit_suites.h"

#include "keiko/report/markup/html_text.h"

namespace keiko {
namespace {

using Outcome = JunitCase::Outcome;

/// ` name="value"`, escaped; XML needs no more escapes than HTML.
std::string xml_attribute(const char* name, std::string_view value) {
    return std::string(" ") + name + "=\"" + html_escaped(value) + "\"";
}

std::string xml_attribute(const char* name, std::size_t value) {
    return xml_attribute(name, std::to_string(value));
}

struct Counts {
    std::size_t tests = 0, failures = 0, errors = 0, skipped = 0;

    void add(const JunitSuite& suite) {
        for (const JunitCase& one : suite.cases) {
            ++tests;
            failures += one.outcome == Outcome::failure;
            errors += one.outcome == Outcome::error;
            skipped += one.outcome == Outcome::skipped;
        }
    }
    std::string attributes() const {
        return xml_attribute("tests", tests) + xml_attribute("failures", failures) +
               xml_attribute("errors", errors);
    }
};

std::string outcome_xml(const JunitCase& one) {
    if (one.outcome == Outcome::skipped)
        return "<skipped" + xml_attribute("message", one.message) + "/>";
    const std::string element = one.outcome == Outcome::failure ? "failure" : "error";
    const std::string type = one.type.empty() ? "" : xml_attribute("type", one.type);
    const std::string head = "<" + element + type + xml_attribute("message", one.message);
    if (one.details.empty()) return head + "/>";
    return head + ">" + html_escaped(one.details) + "</" + element + ">";
}

std::string case_xml(const JunitCase& one) {
    const std::string head = "    <testcase" + xml_attribute("classname", one.class_name) +
                             xml_attribute("name", one.name);
    if (one.outcome == Outcome::pass) return head + "/>\n";
    return head + ">\n      " + outcome_xml(one) + "\n    </testcase>\n";
}

std::string properties_xml(const JunitSuite& suite) {
    if (suite.properties.empty()) return "";
    std::string xml = "    <properties>\n";
    for (const auto& [name, value] : suite.properties)
        xml += "      <property" + xml_attribute("name", name) + xml_attribute("value", value) +
               "/>\n";
    return xml + "    </properties>\n";
}

std::string suite_xml(const JunitSuite& suite) {
    Counts counts;
    counts.add(suite);
    std::string xml = "  <testsuite" + xml_attribute("name", suite.name) + counts.attributes() +
                      xml_attribute("skipped", counts.skipped) + ">\n" + properties_xml(suite);
    for (const JunitCase& one : suite.cases) xml += case_xml(one);
    return xml + "  </testsuite>\n";
}

} // namespace

JunitCase judged_case(std::string class_name, std::string name, bool within,
                      const std::string& message) {
    JunitCase one{std::move(class_name), std::move(name)};
    if (!within) one.outcome = Outcome::failure, one.message = message;
    return one;
}

std::string junit_xml(const std::vector<JunitSuite>& suites) {
    Counts counts;
    std::string body;
    for (const JunitSuite& suite : suites) counts.add(suite), body += suite_xml(suite);
    return "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuites" +
           xml_attribute("name", "keiko") + counts.attributes() + ">\n" + body + "</testsuites>\n";
}

} // namespace keiko
