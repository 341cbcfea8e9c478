#include "keiko/files/scene/view_file.h"

#include "keiko/files/scene/camera_table.h"

namespace keiko {

bool is_view_file(std::string_view name) {
    return name.ends_with(".toml");
}

Camera read_view(const std::filesystem::path& path) {
    const TomlTable table = TomlTable::read(path);
    table.require_format("keiko-view/1");
    const Camera camera = camera_of(table);
    table.finish();
    return camera;
}

} // namespace keiko
