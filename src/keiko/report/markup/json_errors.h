#pragma once

#include "keiko/base/error.h"
#include "keiko/report/markup/json_text.h"

#include <string>

namespace keiko {

/// "line 3, column 7" of an error of the library, whose text names the place before its reason.
inline std::string place_of(const Json::parse_error& error) {
    const std::string text = error.what();
    const std::size_t begin = text.find("line "), end = text.find(':', begin);
    if (begin == text.npos || end == text.npos) return "byte " + std::to_string(error.byte);
    return text.substr(begin, end - begin);
}

/// Calls `read`, whose errors then name the file and the part of it.
template <class Read>
auto with_errors_named(const std::string& file, const std::string& part, const Read& read) {
    try {
        return read();
    } catch (const Error& error) {
        const std::string& key = error.where();
        throw Error(file, part.empty() || key.empty() ? part + key : part + ", " + key,
                    error.reason());
    } catch (const Json::parse_error& error) {
        throw Error(file, part, "no JSON at " + place_of(error));
    } catch (const Json::exception&) {
        throw Error(file, part, "a key is missing or not of the right kind");
    }
}

} // namespace keiko
