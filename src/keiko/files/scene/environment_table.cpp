#include "keiko/files/scene/environment_table.h"

#include "keiko/files/toml/toml_reader.h"

namespace keiko {

EnvironmentSpec environment_from(const TomlTable& table) {
    EnvironmentSpec environment;
    environment.file = table.required("file", path_from(table, "file"));
    if (table.choice("layout", {"lat-long", "cube"}).value_or(0) == 1)
        environment.layout = EnvironmentSpec::Layout::cube;
    environment.luminance =
        table.rgb("luminance", TomlLimits::light()).value_or(environment.luminance);
    environment.azimuth =
        table.number("azimuth", {.low = -360, .high = 360}).value_or(environment.azimuth);
    environment.visible = table.flag("visible").value_or(environment.visible);
    environment.lights = table.flag("lights").value_or(environment.lights);
    table.finish();
    return environment;
}

} // namespace keiko
