#include "keiko/report/json/json_parts.h"

#include <algorithm>
#include <cmath>

namespace keiko {
namespace {

Json layer_json(const LayerDifference& layer) {
    return {{"layer", layer.layer},
            {"beyond", layer.beyond},
            {"largest", real_json(layer.largest)},
            {"excess", real_json(layer.excess)},
            {"root_mean_square", real_json(layer.root_mean_square)},
            {"x", layer.x},
            {"y", layer.y},
            {"within", layer.within}};
}

LayerDifference layer_from(const Json& json) {
    return {.layer = json.at("layer"),
            .beyond = count_at<std::size_t>(json, "beyond"),
            .largest = real_from(json.at("largest")),
            .excess = real_from(json.at("excess")),
            .root_mean_square = real_from(json.at("root_mean_square")),
            .x = count_at<int>(json, "x"),
            .y = count_at<int>(json, "y"),
            .within = json.at("within")};
}

} // namespace

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

Camera checked_camera_from(const Json& json) {
    constexpr int largest_size = 16384;
    const auto require = [](bool holds, const char* key, const char* reason) {
        if (!holds) throw Error("", key, reason);
    };
    const Json& projection = json.at("projection");
    require(projection == "perspective" || projection == "orthographic", "projection",
            "is neither perspective nor orthographic");
    const Camera camera = camera_from(json);
    const Vec3 way = camera.target - camera.eye;
    require(way.length() > 0 && std::isfinite(way.length()), "target", "must differ from eye");
    require(way.cross(camera.up).length() > 1e-6 * way.length() * camera.up.length(), "up",
            "must be a direction other than that of the view");
    require(camera.projection == Projection::orthographic
                ? camera.orthographic_height > 0 && std::isfinite(camera.orthographic_height)
                : camera.vertical_fov > 0 && camera.vertical_fov < 180,
            camera.projection == Projection::orthographic ? "orthographic_height" : "vertical_fov",
            "is out of range");
    require(std::min(camera.width, camera.height) >= 1 &&
                std::max(camera.width, camera.height) <= largest_size,
            "width", "and height must be from 1 to 16384 pixels");
    return camera;
}

Json picture_outcome_json(const PictureOutcome& picture) {
    Json json = {{"view", picture.view},
                 {"problem", picture.problem},
                 {"pixels", picture.pixels},
                 {"coverage_flips", picture.coverage_flips},
                 {"face_flips", picture.face_flips},
                 {"flips_within", picture.flips_within},
                 {"layers", Json::array()},
                 {"width", picture.width},
                 {"height", picture.height},
                 {"before", picture.before},
                 {"after", picture.after},
                 {"difference", picture.difference}};
    for (const LayerDifference& layer : picture.layers) json["layers"].push_back(layer_json(layer));
    return json;
}

PictureOutcome picture_outcome_from(const Json& json) {
    PictureOutcome picture{.view = json.at("view"),
                           .problem = json.at("problem"),
                           .pixels = count_at<std::size_t>(json, "pixels"),
                           .coverage_flips = count_at<std::size_t>(json, "coverage_flips"),
                           .face_flips = count_at<std::size_t>(json, "face_flips"),
                           .flips_within = json.at("flips_within"),
                           .layers = {},
                           .width = count_at<int>(json, "width"),
                           .height = count_at<int>(json, "height"),
                           .before = json.at("before"),
                           .after = json.at("after"),
                           .difference = json.at("difference")};
    for (const Json& layer : json.at("layers")) picture.layers.push_back(layer_from(layer));
    return picture;
}

Json alignment_json(const Alignment& a) {
    Json matrix = Json::array();
    for (std::size_t i = 0; i < 3; ++i) {
        const Vec3& row = a.motion.rows[i];
        matrix.push_back({row.x, row.y, row.z, a.motion.translation[static_cast<unsigned>(i)]});
    }
    return {{"matrix", matrix},        {"axis", point(a.axis)},  {"angle", a.angle},
            {"shift", point(a.shift)}, {"residual", a.residual}, {"steps", a.steps},
            {"converged", a.converged}};
}

} // namespace keiko
