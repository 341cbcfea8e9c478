#include "keiko/report/junit.h"

#include "keiko/report/check_place.h"
#include "keiko/report/html_text.h"
#include "keiko/report/xml_attribute.h"

#include <algorithm>

namespace keiko {
namespace {

std::string test_case(const std::string& source, const std::string& name,
                      const std::string& outcome) {
    const std::string head =
        "    <testcase" + xml_attribute("classname", source) + xml_attribute("name", name);
    if (outcome.empty()) return head + "/>\n";
    return head + ">\n      " + outcome + "\n    </testcase>\n";
}

std::string outcome(const Check& check) {
    if (!check.judged) return "<skipped" + xml_attribute("message", check.message) + "/>";
    if (!check.is_finding()) return "";
    const std::string element = check.worst.verdict == Verdict::fail ? "failure" : "error";
    return "<" + element + xml_attribute("type", check.code) +
           xml_attribute("message", check.message) + ">" + html_escaped(placed_message(check)) +
           "</" + element + ">";
}

std::string lost_face_case(const std::string& source, const LostFace& face) {
    return test_case(
        source, "face " + std::to_string(face.id) + ": read",
        "<error" + xml_attribute("type", "lost") + xml_attribute("message", face.reason) + "/>");
}

std::string properties(const Inspection& inspection) {
    const auto property = [](const char* name, std::string_view value) {
        return "      <property" + xml_attribute("name", name) + xml_attribute("value", value) +
               "/>\n";
    };
    return "    <properties>\n" + property("preset", inspection.preset.name) +
           property("source", inspection.preset.source) +
           property("verdict", name_of(inspection.verdict)) + "    </properties>\n";
}

std::string counts(const Inspection& inspection) {
    std::size_t failures = 0, errors = inspection.facts.lost_faces.size(), skipped = 0;
    for (const Check& check : inspection.checks) {
        skipped += check.judged ? 0 : 1;
        failures += check.is_finding() && check.worst.verdict == Verdict::fail;
        errors += check.is_finding() && check.worst.verdict == Verdict::undecided;
    }
    return xml_attribute("tests", inspection.checks.size() + inspection.facts.lost_faces.size()) +
           xml_attribute("failures", failures) + xml_attribute("errors", errors) +
           xml_attribute("skipped", skipped);
}

} // namespace

std::string junit_xml(const Inspection& inspection) {
    const std::string& source = inspection.facts.source;
    std::string xml = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuites" +
                      xml_attribute("name", "keiko") + ">\n  <testsuite" +
                      xml_attribute("name", source) + counts(inspection) + ">\n" +
                      properties(inspection);
    for (const LostFace& face : inspection.facts.lost_faces) xml += lost_face_case(source, face);
    for (const Check& check : inspection.checks)
        xml += test_case(source, subject_of(check) + ": " + check.quantity, outcome(check));
    return xml + "  </testsuite>\n</testsuites>\n";
}

} // namespace keiko
