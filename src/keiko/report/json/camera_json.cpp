#include "keiko/report/json/camera_json.h"

namespace keiko {

Json camera_json(const Camera& camera) {
    return {{"projection",
             camera.projection == Projection::perspective ? "perspective" : "orthographic"},
            {"eye", point(camera.eye)},
            {"target", point(camera.target)},
            {"up", point(camera.up)},
            {"vertical_fov", camera.vertical_fov},
            {"orthographic_height", camera.orthographic_height},
            {"width", camera.width},
            {"height", camera.height}};
}

Camera camera_from(const Json& json) {
    Camera camera;
    camera.projection =
        json.at("projection") == "perspective" ? Projection::perspective : Projection::orthographic;
    camera.eye = point_from(json.at("eye"));
    camera.target = point_from(json.at("target"));
    camera.up = point_from(json.at("up"));
    camera.vertical_fov = json.at("vertical_fov");
    camera.orthographic_height = json.at("orthographic_height");
    camera.width = int_at(json, "width");
    camera.height = int_at(json, "height");
    return camera;
}

} // namespace keiko
