#pragma once

#include "keiko/base/error.h"

#include <string>
#include <utility>

namespace keiko {

/// Error in one field of the options that a caller passes; what() begins with the field's name:
/// "columns: ...". A front end puts the name that its users know the field by in its place.
class FieldError : public Error {
public:
    FieldError(std::string field, std::string reason)
        : Error("", std::move(field), std::move(reason)) {}

    const std::string& field() const { return where(); }
};

} // namespace keiko
