#include "keiko/files/toml/own_formats.h"

namespace keiko {
namespace {

struct OwnFormat {
    std::string_view name, use;
};

constexpr OwnFormat own_formats[] = {
    {"keiko-scene", "a scene: inspect, check, render and trace take it, as FILE.toml"},
    {"keiko-rig", "a rig: inspect, render and lines take it as their rig"},
    {"keiko-materials", "a file of materials: a scene names it"},
    {"keiko-preset", "a file of limits: inspect, check and lines take it as their preset"},
    {"keiko-fixture", "a fixture: regress takes the folder of its suite"},
    {"keiko-hits", "registered hits: place takes them instead of views"},
};

} // namespace

std::string use_of_format(std::string_view format) {
    const std::string_view name = format.substr(0, format.find('/'));
    for (const OwnFormat& own : own_formats)
        if (name == own.name) return std::string(own.use);
    return "";
}

} // namespace keiko
