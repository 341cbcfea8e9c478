#include "keiko/files/scene/camera_table.h"

#include "keiko/files/toml/toml_reader.h"

namespace keiko {
namespace {

constexpr double narrowest_fov = 1e-3, widest_fov = 175; ///< degrees
constexpr double largest_size = 65536;                   ///< pixels, either way

void require_direction(const TomlTable& table, const Camera& camera) {
    const Vec3 view = camera.target - camera.eye;
    if (!(view.length() > 0)) throw table.error("target", "must differ from eye");
    if (!(camera.up.length() > 0)) throw table.error("up", "must not be a zero vector");
    if (!(view.cross(camera.up).length() > 1e-6 * view.length() * camera.up.length()))
        throw table.error("up", "must not be along the view direction");
}

} // namespace

std::optional<PictureSize> picture_size_from(const TomlTable& table) {
    const auto size = table.numbers("size", 2, {.low = 1, .high = largest_size});
    if (!size) return {};
    for (const double edge : *size)
        if (edge != static_cast<int>(edge)) throw table.error("size", "must be whole numbers");
    return PictureSize{static_cast<int>((*size)[0]), static_cast<int>((*size)[1])};
}

Camera camera_of(const TomlTable& table) {
    Camera camera;
    if (table.choice("projection", {"perspective", "orthographic"}).value_or(0) == 1)
        camera.projection = Projection::orthographic;
    camera.eye = table.required("eye", table.vector("eye"));
    camera.target = table.required("target", table.vector("target"));
    camera.up = table.vector("up").value_or(camera.up);
    require_direction(table, camera);

    const auto fov = table.number("vertical_fov", {.low = narrowest_fov, .high = widest_fov});
    const auto height = table.number("orthographic_height", TomlLimits::length());
    if (camera.projection == Projection::orthographic) {
        if (fov) throw table.error("vertical_fov", "belongs to perspective cameras");
        camera.orthographic_height = table.required("orthographic_height", height);
    } else {
        if (height) throw table.error("orthographic_height", "belongs to orthographic cameras");
        camera.vertical_fov = fov.value_or(camera.vertical_fov);
    }
    return camera;
}

Camera camera_from(const TomlTable& table) {
    Camera camera = camera_of(table);
    if (const auto size = picture_size_from(table))
        camera.width = size->width, camera.height = size->height;
    table.finish();
    return camera;
}

bool is_view_file(std::string_view name) {
    return name.ends_with(".toml");
}

Camera read_view(const std::filesystem::path& path) {
    const TomlTable table = TomlTable::read(path);
    table.require_format("keiko-view/1");
    Camera camera = camera_of(table);
    table.finish();
    return camera;
}

} // namespace keiko
