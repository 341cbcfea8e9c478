#include "keiko/viewer/http_message.h"

#include "keiko/base/text.h"

namespace keiko::viewer {
namespace {

/// The line as a JSON string, quotes included.
std::string json_string(std::string_view line) {
    std::string text = "\"";
    for (const char c : as_utf8(one_line(line))) {
        if (c == '"' || c == '\\') text += '\\';
        text += c;
    }
    return text + '"';
}

} // namespace

HttpReply error_reply(int status, std::string_view reason) {
    return {.status = status, .body = "{\"error\":" + json_string(reason) + "}\n"};
}

} // namespace keiko::viewer
