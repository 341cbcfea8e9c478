#pragma once

namespace keiko::cli {

constexpr int exit_pass = 0;
constexpr int exit_findings = 1;
constexpr int exit_error = 2;
constexpr int exit_interrupted = 130;

} // namespace keiko::cli
