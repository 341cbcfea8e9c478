#pragma once

#include "keiko/base/export.h"
#include "keiko/base/text.h"

#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace KEIKO_API keiko {

/// Bad input, reported in one line: which file, where in it (a line, an entity, a key; may be
/// empty) and why. Every error a user can cause is thrown as this type or a kind of it.
class Error : public std::runtime_error {
public:
    /// `file` and `where` may be empty.
    Error(std::string file, std::string where, std::string reason)
        : std::runtime_error(line_of(file, where, reason)),
          file_(std::move(file)),
          where_(std::move(where)),
          reason_(std::move(reason)) {}

    /// Path of the file, or empty.
    const std::string& file() const { return file_; }
    /// Place in the file: a line, an entity, a key; or empty.
    const std::string& where() const { return where_; }
    /// The reason without file and place.
    const std::string& reason() const { return reason_; }

private:
    static std::string line_of(const std::string& file, const std::string& where,
                               const std::string& reason) {
        std::string line = file;
        if (!where.empty()) line += line.empty() ? where : ":" + where;
        return one_line(line.empty() ? reason : line + ": " + reason);
    }

    std::string file_, where_, reason_;
};

/// Thrown out of a long function when its Job was asked to stop.
class Cancelled : public std::runtime_error {
public:
    /// With what() "interrupted".
    Cancelled() : std::runtime_error("interrupted") {}
};

/// Error in one field of the options that a caller passes; what() begins with the field's name:
/// "columns: ...". A front end puts the name that its users know the field by in its place.
class FieldError : public Error {
public:
    /// The field's name, and what is wrong with its value.
    FieldError(std::string field, std::string reason)
        : Error("", std::move(field), std::move(reason)) {}

    /// Name of the field.
    const std::string& field() const { return where(); }
};

/// How much a remark matters.
enum class Severity {
    note,    ///< changes nothing
    warning, ///< results may differ from what was meant
    error    ///< part of the input is missing
};

/// A remark on the input that did not stop the work: a repaired loop, a face left out.
struct Diagnostic {
    Severity severity = Severity::note; ///< how much it matters
    std::string entity;  ///< what it is about, e.g. "face 12 (fender-outer)"; may be empty
    std::string message; ///< one sentence
};

/// Returned beside a result, never printed by the library.
using Diagnostics = std::vector<Diagnostic>;

} // namespace keiko
