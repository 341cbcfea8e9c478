#include "keiko/files/scene/view_request.h"

#include "keiko/files/scene/rig_tables.h"
#include "keiko/files/scene/scene_file.h"

#include <algorithm>
#include <cmath>

namespace keiko {

namespace {

std::vector<std::uint32_t> hidden_from(const TomlTable& root) {
    constexpr double largest_id = 0xffffffff;
    std::vector<std::uint32_t> hidden;
    for (const double id :
         root.list("hidden", {.low = 1, .high = largest_id}).value_or(std::vector<double>())) {
        if (id != std::floor(id)) throw root.error("hidden", "must be whole numbers");
        hidden.push_back(static_cast<std::uint32_t>(id));
    }
    std::sort(hidden.begin(), hidden.end());
    return hidden;
}

std::optional<Vec2> pixel_from(const TomlTable& root) {
    constexpr double largest = 65536; // as for sizes of pictures
    const auto pixel = root.numbers("pixel", 2, {.low = 0, .high = largest});
    return pixel ? std::optional(Vec2((*pixel)[0], (*pixel)[1])) : std::nullopt;
}

AnalysisView view_from(const TomlTable& table) {
    const auto camera = table.required("camera", table.table("camera"));
    AnalysisView view{table.required("name", table.text("name")), camera_from(camera)};
    view.look = table.text("look").value_or(view.look);
    view.across = table.vector("across");
    return view;
}

AnalysisNote note_from(const TomlTable& table) {
    return {table.required("text", table.text("text")),
            table.required("place", table.vector("place"))};
}

} // namespace

ViewRequest parse_view_request(std::string_view text) {
    constexpr int most_reflections = 8;
    constexpr double most_ev = 100; // either way: 2^100 has no meaning as light
    ViewRequest request;
    const TomlTable root = TomlTable::parse_alone(text, "request");
    if (root.has("format")) root.require_format("keiko-view-request/1");
    if (const auto camera = root.table("camera")) request.camera = camera_from(*camera);
    // `c_plane = []` requests darkness, no word of planes the rig's own.
    if (root.has("c_plane")) request.planes.emplace();
    for (const TomlTable& plane : root.tables("c_plane"))
        request.planes->push_back(c_plane_from(plane));
    request.interlaced = root.flag("interlaced").value_or(request.interlaced);
    request.reflections =
        root.integer("reflections", 1, most_reflections).value_or(request.reflections);
    request.hidden = hidden_from(root);
    request.pixel = pixel_from(root);
    request.ev = root.number("ev", {.low = -most_ev, .high = most_ev});
    for (const TomlTable& view : root.tables("view")) request.views.push_back(view_from(view));
    request.sections = root.texts("sections").value_or(std::vector<std::string>());
    for (const TomlTable& note : root.tables("note")) request.notes.push_back(note_from(note));
    root.finish();
    return request;
}

LightRig with_planes(const LightRig& rig, const std::vector<CPlane>& planes) {
    LightRig changed = rig;
    changed.sources.clear();
    auto next = planes.begin();
    for (const LightSource& source : rig.sources) {
        if (!std::holds_alternative<CPlane>(source))
            changed.sources.push_back(source);
        else if (next != planes.end())
            changed.sources.emplace_back(*next++);
    }
    changed.sources.insert(changed.sources.end(), next, planes.end());
    return changed;
}

} // namespace keiko
