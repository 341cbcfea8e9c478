#pragma once

#include <string>
#include <utility>
#include <vector>

namespace keiko {

/// A test case as displayed by build servers.
struct JunitCase {
    enum class Outcome { pass, failure, error, skipped };
    std::string class_name, name;
    Outcome outcome = Outcome::pass;
    std::string message{}; ///< one line
    std::string details{}; ///< any number of lines
    std::string type{};    ///< of a failure or an error: a code, or empty
};

/// A case that passes, or fails with a message.
JunitCase judged_case(std::string class_name, std::string name, bool within,
                      const std::string& message);

struct JunitSuite {
    std::string name;
    std::vector<JunitCase> cases{};
    std::vector<std::pair<std::string, std::string>> properties{}; ///< name and value
};

/// JUnit XML (the schema of the xUnit plugin of Jenkins, junit-10.xsd), without times, so that
/// every run gives the same bytes.
std::string junit_xml(const std::vector<JunitSuite>& suites);

} // namespace keiko
