#pragma once

#include "keiko/base/error.h"
#include "keiko/files/scene/rig_file.h"

#include <string>
#include <variant>

namespace keiko::test {

/// The message of the Error that a rig text causes; "" when there is none.
inline std::string rig_error(const std::string& text) {
    try {
        parse_rig(text, "bad.toml");
    } catch (const Error& error) {
        return error.what();
    }
    return "";
}

/// The first light of a rig text.
template <class Light>
Light only_light(const std::string& text) {
    return std::get<Light>(parse_rig(text, "rig.toml").sources.at(0));
}

} // namespace keiko::test
