#pragma once

#include "keiko/report/markup/html_text.h"

#include <string>
#include <string_view>

namespace keiko {

/// ` name="value"`, escaped; XML needs no more escapes than HTML.
inline std::string xml_attribute(const char* name, std::string_view value) {
    return std::string(" ") + name + "=\"" + html_escaped(value) + "\"";
}

inline std::string xml_attribute(const char* name, std::size_t value) {
    return xml_attribute(name, std::to_string(value));
}

} // namespace keiko
