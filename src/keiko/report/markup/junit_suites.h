#pragma once

#include "keiko/base/export.h"

#include <string>
#include <utility>
#include <vector>

namespace KEIKO_API keiko {

/// A test case as displayed by build servers.
struct JunitCase {
    /// Outcome of a test case.
    enum class Outcome {
        pass,    ///< as expected
        failure, ///< not as expected
        error,   ///< could not be tested
        skipped  ///< was not tested
    };
    std::string class_name, name;    ///< as displayed; the class groups cases
    Outcome outcome = Outcome::pass; ///< of this case
    std::string message{};           ///< one line
    std::string details{};           ///< any number of lines
    std::string type{};              ///< of a failure or an error: a code, or empty
};

/// A case that passes, or fails with a message.
JunitCase judged_case(std::string class_name, std::string name, bool within,
                      const std::string& message);

/// Test cases that belong together.
struct JunitSuite {
    std::string name;                                              ///< as displayed
    std::vector<JunitCase> cases{};                                ///< in order
    std::vector<std::pair<std::string, std::string>> properties{}; ///< name and value
};

/// JUnit XML (the schema of the xUnit plugin of Jenkins, junit-10.xsd), without times, so that
/// every run gives the same bytes.
std::string junit_xml(const std::vector<JunitSuite>& suites);

} // namespace keiko
