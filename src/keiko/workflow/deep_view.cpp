#include "keiko/workflow/deep_view.h"

#include "keiko/base/error.h"
#include "keiko/scene/view.h"
#include "keiko/workflow/version.h"

#include <algorithm>
#include <bit>
#include <type_traits>

namespace keiko {
namespace {

static_assert(std::endian::native == std::endian::little, "keiko-deep/1 is little-endian");

constexpr std::string_view magic = "KEIKOD1\n";
constexpr float ground = -1;
constexpr int most_reflections = 8;

void require(const DeepOptions& options) {
    const RowSet& rows = options.rows;
    if (rows.step < 1 || rows.first < 0 || rows.first >= rows.step)
        throw FieldError("rows", "the first must be 0 or more and less than the step");
    if (options.reflections < 1 || options.reflections > most_reflections)
        throw FieldError("reflections", "must be from 1 to " + std::to_string(most_reflections));
}

template <class T>
void append(std::string& bytes, const std::vector<T>& values) {
    static_assert(std::is_trivially_copyable_v<T>);
    bytes.append(reinterpret_cast<const char*>(values.data()), values.size() * sizeof(T));
}

} // namespace

DeepBuffer deep_view(const Scene& scene, const Camera& camera, const DeepOptions& options,
                     const Job& job) {
    return deep_view(scene, scene.seen(), camera, options, job);
}

DeepBuffer deep_view(const Scene& scene, const Tracer& seen, const Camera& camera,
                     const DeepOptions& options, const Job& job) {
    require(options);
    DeepBuffer buffer = deep_buffer(seen, camera, options, job);
    const auto last = static_cast<float>(scene.model.faces.size()); // a face of the body
    const auto rename = [&](DeepSample& sample) {
        if (sample.face > last) sample.face = ground;
    };
    for (DeepSample& sample : buffer.samples) rename(sample);
    for (DeepBounce& bounce : buffer.bounces) rename(bounce.sample);
    return buffer;
}

namespace {

/// The number of a material among those known, to which it is added if it is new.
std::uint32_t number_of(const Material& material, std::vector<Material>& known) {
    const auto found = std::find(known.begin(), known.end(), material);
    const auto number = static_cast<std::uint32_t>(found - known.begin());
    if (found == known.end()) known.push_back(material);
    return number;
}

} // namespace

namespace {

/// The faces of a scene by part; adds their materials to those that are listed.
std::vector<ViewedFace> viewed_faces(const Scene& scene, std::vector<Material>& materials) {
    std::vector<ViewedFace> faces;
    for (std::size_t i = 0; i < scene.model.faces.size(); ++i) {
        const Face& face = scene.model.faces[i];
        faces.push_back({face.id, face.name, face.layer, number_of(scene.materials[i], materials)});
    }
    for (std::uint32_t number = 0; number < scene.model.parts.size(); ++number) {
        const Part& part = scene.model.parts[number];
        for (std::uint32_t i = 0; i < part.face_count; ++i)
            faces[part.first_face + i].part = number;
    }
    return faces;
}

} // namespace

ViewFacts view_facts(const Scene& scene, const NamedView& view) {
    const PictureOptions options = picture_options(scene);
    ViewFacts facts{.tool_version = version(),
                    .inputs = {},
                    .camera = view.camera,
                    .view = view.name,
                    .bounds = scene.tracer.bounds(),
                    .background = scene.background,
                    .faces = {},
                    .parts = {},
                    .materials = {},
                    .reflections = options.max_depth,
                    .min_weight = options.min_weight,
                    .views = {},
                    .own_views = {},
                    .remarks = {}};
    for (const auto& input : scene.inputs) facts.inputs.push_back(input.filename().string());
    facts.faces = viewed_faces(scene, facts.materials);
    for (const Part& part : scene.model.parts) facts.parts.push_back(part.name);
    facts.ground = scene.ground();
    if (scene.surroundings)
        facts.ground_material = number_of(scene.surroundings->materials.back(), facts.materials);
    const Framing framing{
        .width = view.camera.width, .height = view.camera.height, .ground = facts.ground};
    for (const std::string& name : view_names())
        facts.views.push_back({name, frame_view(name, facts.bounds, framing), 0});
    return facts;
}

std::string deep_bytes(const DeepBuffer& buffer) {
    const std::vector<std::uint32_t> sizes{static_cast<std::uint32_t>(buffer.width),
                                           static_cast<std::uint32_t>(buffer.height),
                                           static_cast<std::uint32_t>(buffer.rows.first),
                                           static_cast<std::uint32_t>(buffer.rows.step),
                                           static_cast<std::uint32_t>(buffer.samples.size()),
                                           static_cast<std::uint32_t>(buffer.bounces.size())};
    std::string bytes(magic);
    bytes.reserve(magic.size() + sizes.size() * sizeof(std::uint32_t) +
                  buffer.samples.size() * sizeof(DeepSample) +
                  buffer.bounces.size() * sizeof(DeepBounce));
    append(bytes, sizes);
    append(bytes, buffer.samples);
    append(bytes, buffer.bounces);
    return bytes;
}

} // namespace keiko
