#pragma once

#include "keiko/base/error.h"
#include "keiko/base/job.h"

#include <span>
#include <string_view>

namespace keiko::cli {

/// Standard input as it comes; a wait for more ends when the job is stopped.
class StandardInput {
public:
    /// Keeps a reference to the job.
    explicit StandardInput(const Job& job) : job_(job) {}

    /// Fills the front of `bytes` with the available bytes, at least one; returns 0 at the end.
    /// Throws Error, or Cancelled when the job is stopped.
    std::size_t read(std::span<char> bytes) const;

private:
    const Job& job_;
};

/// Error of standard output that takes no more. `code`: the errno of the write; 0 if unknown.
Error unwritten_output(int code);

/// Standard output for a command that writes while it reads; a wait for the reader ends when the
/// job is stopped.
class StandardOutput {
public:
    /// Opens the output; from then on a reader that closes it does not end the process.
    explicit StandardOutput(const Job& job);

    /// Writes all of it; false if no reader is left. Throws Error, or Cancelled when the job is
    /// stopped.
    bool write(std::string_view text) const;

private:
    const Job& job_;
    std::size_t most_at_once_; ///< bytes that never block once poll has reported room
};

} // namespace keiko::cli
