#include "keiko/io/own_formats.h"

namespace keiko {
namespace {

struct OwnFormat {
    std::string_view name, use;
};

constexpr OwnFormat own_formats[] = {
    {"keiko-scene", "a scene: inspect, check, render and trace take it, as FILE.toml"},
    {"keiko-rig", "a rig: --rig of inspect, render and lines takes it"},
    {"keiko-materials", "a file of materials: a scene names it"},
    {"keiko-preset", "a file of limits: --preset takes it"},
    {"keiko-fixture", "a fixture: regress takes the folder of its suite"},
    {"keiko-hits", "registered hits: place --from takes them"},
};

} // namespace

std::string use_of_format(std::string_view format) {
    const std::string_view name = format.substr(0, format.find('/'));
    for (const OwnFormat& own : own_formats)
        if (name == own.name) return std::string(own.use);
    return "";
}

} // namespace keiko
