#pragma once

#include "tests/support/paths.h"

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

namespace keiko::test {

/// Keys with their values as TOML, in order.
using Keys = std::vector<std::pair<std::string, std::string>>;

/// A table with right values, behind text that is right.
struct Table {
    std::string header;     ///< "[sky]"
    std::string path;       ///< in messages: "sky"
    std::string definition; ///< JSON pointer into the schema
    Keys keys{};
    std::string before{};

    std::string text(const Keys& shown) const {
        std::string all = before + header + "\n";
        for (const auto& [key, value] : shown) all += key + " = " + value + "\n";
        return all;
    }
    std::string with(const std::string& changed, const std::string& value) const {
        Keys shown = keys;
        for (auto& [key, own] : shown)
            if (key == changed) own = value;
        return text(shown);
    }
    std::string without(const std::string& left_out) const {
        Keys shown = keys;
        std::erase_if(shown, [&](const auto& key) { return key.first == left_out; });
        return text(shown);
    }
    /// Line of the table's header, or of a key of it.
    std::size_t line(const std::string& key = "") const {
        const std::string all = text(keys);
        const std::size_t at =
            key.empty() ? before.size() : all.find("\n" + key + " = ", before.size());
        return static_cast<std::size_t>(
                   std::count(all.begin(), all.begin() + static_cast<std::ptrdiff_t>(at), '\n')) +
               (key.empty() ? 1 : 2);
    }
};

inline std::string quoted(const std::filesystem::path& file) {
    return "\"" + file.string() + "\"";
}

inline const std::string head = "format = \"keiko-scene/1\"\n[[model]]\nfile = " +
                                quoted(test::repository("surfaces/saddle.bpt")) + "\n";
inline const std::string paint = head + "[model.material]\ndiffuse = 0.5\n";
inline const std::string map_head = paint + "[[model.material.map]]\ndrives = \"diffuse\"\n";
inline const std::string noise = "texture = { kind = \"noise\" }\n";
inline const std::string checker = "texture = { kind = \"checker\" }";
inline const std::string picture = quoted(test::repository("docs/images/hood.png"));
inline const std::string square =
    "[[0, 0, 2000], [0, 900, 2000], [900, 900, 2000], [900, 0, 2000]]";
inline const std::string triangle = "[[100, 100, 2000], [100, 300, 2000], [300, 300, 2000]]";

inline Table light(const std::string& name, Keys keys) {
    const std::string definition = name == "polygon" ? "mappedPolygon" : name; // of a scene
    return {"[[" + name + "]]", name + "[0]", "/$defs/" + definition, std::move(keys), head};
}

inline Table map_part(const std::string& name, Keys keys, std::string before,
                      std::string definition) {
    return {"[model.material.map." + name + "]", "model[0].material.map[0]." + name,
            std::move(definition), std::move(keys), std::move(before)};
}

inline Table texture(Keys keys, const std::string& drives = "diffuse") {
    const std::string before = paint + "[[model.material.map]]\ndrives = \"" + drives + "\"\n";
    return map_part("texture", std::move(keys), before, "/$defs/texture");
}

inline Table projection(Keys keys) {
    return map_part("projection", std::move(keys), map_head + noise, "/$defs/projection");
}

inline Table material_map(Keys keys) {
    return {"[[model.material.map]]", "model[0].material.map[0]", "/$defs/map", std::move(keys),
            paint};
}

/// Several of one kind where no single one can have all keys.
inline std::vector<Table> daylight_tables() {
    return {{"[sky]",
             "sky",
             "/$defs/sky",
             {{"model", "\"gradient\""},
              {"horizon", "2"},
              {"luminance", "[1, 2, 3]"},
              {"color", "0.5"},
              {"ground", "10"}},
             head},
            {"[sky]",
             "sky",
             "/$defs/sky",
             {{"model", "\"clear\""}, {"sun", "[0, 1, 1]"}, {"illuminance", "2e4"}},
             head},
            {"[place]",
             "place",
             "/$defs/place",
             {{"latitude", "48.1"},
              {"longitude", "11.6"},
              {"time", "2026-06-21T14:30:00+02:00"},
              {"north", "[1, 0, 0]"}},
             head + "[sky]\n"},
            {"[sun]",
             "sun",
             "/$defs/sun",
             {{"direction", "[0, 0, -1]"},
              {"illuminance", "2e4"},
              {"color", "[1, 1, 0.5]"},
              {"shaft", "false"}},
             head},
            {"[environment]",
             "environment",
             "/$defs/environment",
             {{"file", picture},
              {"layout", "\"lat-long\""},
              {"luminance", "20"},
              {"azimuth", "-90"},
              {"visible", "false"},
              {"lights", "true"}},
             head}};
}

/// Lights of tables with many words.
inline std::vector<Table> lamp_tables() {
    const std::string file =
        quoted(test::repository("surfaces/headlamp.ies")); // type A: it needs an aim
    return {light("c_plane", {{"origin", "[0, 0, 900]"},
                              {"u", "[900, 0, 0]"},
                              {"v", "[0, 900, 0]"},
                              {"lamps", "3"},
                              {"pitch", "200"},
                              {"diameter", "30"},
                              {"luminance", "[1, 2, 3]"},
                              {"color", "0.5"},
                              {"caps", "\"luminous\""},
                              {"diffuse", "\"strip\""},
                              {"mirror", "\"flat\""}}),
            light("c_plane", {{"origin", "[0, 0, 900]"},
                              {"u", "[900, 0, 0]"},
                              {"v", "[0, 900, 0]"},
                              {"luminous_flux", "3000"},
                              {"fidelity", "\"exact\""}}),
            light("luminaire", {{"file", file},
                                {"position", "[0, 0, 900]"},
                                {"aim", "[9, 0, 900]"},
                                {"reference", "[0, 0, 1]"},
                                {"spin", "30"},
                                {"flip_h", "true"},
                                {"dimming", "0.5"},
                                {"color", "[1, 1, 0.5]"},
                                {"shaft", "false"}}),
            light("luminaire", {{"file", file},
                                {"position", "[0, 0, 900]"},
                                {"aim", "[9, 0, 900]"},
                                {"luminous_flux", "900"}})};
}

inline std::vector<Table> light_tables() {
    const Keys place{{"position", "[0, 0, 900]"}}, ends{{"a", "[0, 0, 900]"}, {"b", "[9, 0, 900]"}};
    const Keys edges{
        {"origin", "[0, 0, 900]"}, {"u", "[9, 0, 0]"}, {"v", "[0, 9, 0]"}, {"w", "[0, 0, 9]"}};
    const Keys ball{{"center", "[0, 0, 900]"}, {"radius", "50"}}, corners{{"corners", square}};
    const auto and_keys = [](Keys keys, const Keys& more) {
        keys.insert(keys.end(), more.begin(), more.end());
        return keys;
    };
    const Keys flux{{"luminous_flux", "700"}};
    const Keys bright{{"luminance", "[1, 2, 3]"}, {"color", "2"}};
    const Keys strong{{"intensity", "50"}, {"color", "[1, 0.5, 0]"}};
    const Keys beam{{"axis", "[1, 0, 0]"},
                    {"distribution", "\"power\""},
                    {"exponent", "2"},
                    {"shaft", "false"}};
    return {
        light("point", and_keys(and_keys(place, beam), strong)),
        light("point", and_keys(place, flux)),
        light("line", and_keys(ends, strong)),
        light("line", and_keys(ends, flux)),
        light("box", and_keys(edges, bright)),
        light("box", and_keys(edges, flux)),
        light("sphere", and_keys(ball, bright)),
        light("sphere", and_keys(ball, flux)),
        light("polygon", and_keys(and_keys(corners, {{"two_sided", "true"}}), bright)),
        light("polygon", and_keys(corners, flux)),
        light("polygon", and_keys(corners, {{"map", "[ { " + checker + " } ]"}})),
        {"[[polygon.map]]",
         "polygon[0].map[0]",
         "/$defs/luminanceMap",
         {{"texture", "{ kind = \"checker\" }"},
          {"projection", "{ kind = \"planar\" }"},
          {"low", "[0, 0.1, 0]"},
          {"high", "2"},
          {"factor", "0.5"},
          {"region", "{ corners = [[0, 0], [1, 0], [1, 1]] }"}},
         head + "[[polygon]]\ncorners = " + square + "\n"},
        light("sign", and_keys(and_keys(corners, bright),
                               {{"legend", "[ { corners = " + triangle + " } ]"}})),
        {"[[sign.legend]]", "sign[0].legend[0]", "/$defs/sign/properties/legend/items",
         and_keys({{"corners", triangle}}, bright), head + "[[sign]]\ncorners = " + square + "\n"}};
}

inline std::vector<Table> material_tables() {
    const auto texels = [](Keys keys) {
        return Table{"[model.material.texels]", "model[0].material.texels", "/$defs/texels",
                     std::move(keys), paint};
    };
    const auto roughness = [](Keys keys) {
        return Table{"[model.material.roughness]", "model[0].material.roughness",
                     "/$defs/roughness", std::move(keys), paint};
    };
    return {
        texels({{"kind", "\"fur\""},
                {"thickness", "20"},
                {"diffuse", "0.5"},
                {"specular", "[0.1, 0.2, 0.3]"},
                {"exponent", "20"},
                {"voxels", "16"},
                {"hairs", "100"},
                {"length", "25"},
                {"variation", "0.2"},
                {"width", "0.1"},
                {"lean", "20"},
                {"droop", "30"},
                {"toward", "-90"},
                {"disorder", "30"},
                {"curl", "{ radius = 1, turns = 2 }"},
                {"block", "20"},
                {"seed", "3"}}),
        texels({{"kind", "\"cloth\""},
                {"thickness", "1"},
                {"weave", "\"twill\""},
                {"spacing", "2"},
                {"extinction", "10"}}),
        roughness({{"distribution", "\"gauss\""}, {"width", "0.2"}, {"mode", "\"brdf\""}}),
        roughness({{"distribution", "\"phong\""}, {"exponent", "20"}}),
        roughness({{"width", "0.1"}, {"across", "0.3"}, {"along", "[0, 1, 0]"}}),
        roughness({{"width", "0.1"}, {"across", "0.3"}, {"around", "{ axis = [0, 0, 1] }"}}),
        material_map({{"drives", "\"diffuse\""},
                      {"texture", "{ kind = \"noise\" }"},
                      {"projection", "{ kind = \"planar\" }"},
                      {"low", "[0, 0.1, 0]"},
                      {"high", "2"},
                      {"factor", "0.5"},
                      {"region", "{ corners = [[0, 0], [1, 0], [1, 1]] }"}}),
        material_map(
            {{"drives", "\"bump\""}, {"texture", "{ kind = \"noise\" }"}, {"height", "-0.5"}}),
        material_map({{"drives", "\"normal\""},
                      {"texture", "{ kind = \"picture\", file = " + picture + " }"},
                      {"flip_green", "true"}}),
        map_part("region",
                 {{"projection", "{ kind = \"planar\" }"}, {"corners", "[[0, 0], [1, 0], [1, 1]]"}},
                 map_head + noise, "/$defs/mapRegion"),
        texture({{"kind", "\"picture\""}, {"file", picture}, {"srgb", "true"}}),
        texture({{"kind", "\"grid\""}, {"size", "20"}, {"line", "0.1"}}),
        texture({{"kind", "\"brick\""}, {"brick", "[2, 1]"}, {"mortar", "0.1"}}),
        texture({{"kind", "\"marble\""},
                 {"seed", "3"},
                 {"octaves", "4"},
                 {"gain", "0.5"},
                 {"lacunarity", "2.2"},
                 {"distortion", "3"}}),
        texture({{"kind", "\"voronoi\""}, {"value", "\"cell\""}}),
        texture({{"kind", "\"reaction-diffusion\""}, {"feed", "0.037"}, {"kill", "0.06"}}),
        texture({{"kind", "\"orange-peel\""}, {"bands", "[0.1, 0.2, 0.3, 0.4, 0.5]"}}, "bump"),
        projection({{"kind", "\"planar\""},
                    {"origin", "[0, 0, 0]"},
                    {"u", "[9, 0, 0]"},
                    {"v", "[0, 9, 0]"},
                    {"scale", "[2, 1]"},
                    {"offset", "[0, 1]"}}),
        projection({{"kind", "\"cylindrical\""},
                    {"axis", "[0, 0, 1]"},
                    {"u", "[1, 0, 0]"},
                    {"height", "50"}})};
}

inline std::vector<Table> all_tables() {
    std::vector<Table> tables = daylight_tables();
    for (const auto& more : {lamp_tables(), light_tables(), material_tables()})
        tables.insert(tables.end(), more.begin(), more.end());
    return tables;
}

} // namespace keiko::test
