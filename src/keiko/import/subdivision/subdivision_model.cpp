#include "keiko/import/subdivision/subdivision_model.h"

#include "keiko/base/error.h"
#include "keiko/import/subdivision/cage.h"
#include "keiko/import/subdivision/limit_patches.h"

#include <cstdio>

namespace keiko {
namespace {

using namespace subdivision;

std::uint32_t size32(const auto& list) {
    return static_cast<std::uint32_t>(list.size());
}

class ModelWriter {
public:
    ModelWriter(const Cage& cage, const LimitTable& table, const std::vector<CapError>& caps)
        : cage_(cage), table_(table), caps_(caps) {
        for (std::uint32_t f = 0; f < cage.faces.size(); ++f)
            for (std::uint32_t k = 0; k < base_faces(cage, cage.faces[f]); ++k)
                bases_.push_back({f, k});
    }

    SurfaceModel write() {
        reserve();
        for (const std::vector<LimitTable::Index>& indices : patches_by_face(table_)) {
            begin_face(table_.place(indices.front()).face);
            for (const LimitTable::Index index : indices)
                if (!table_.exact(index)) append_irregular(index);
            if (table_.triangular())
                append(triangle_patches(table_, indices));
            else
                for (const LimitTable::Index index : indices) append(quad_patches(table_, index));
        }
        return std::move(model_);
    }

private:
    struct Base {
        std::uint32_t face, corner; ///< of an n-gon
    };

    void reserve();
    void begin_face(std::uint32_t base);
    void append(const std::vector<LimitPatch>& patches);
    void append_irregular(LimitTable::Index cap);
    std::string name(const Base& base) const;

    const Cage& cage_;
    const LimitTable& table_;
    const std::vector<CapError>& caps_;
    std::vector<Base> bases_;
    SurfaceModel model_;
};

/// A list that grows by itself is there twice for a moment. Strips beside creases make it grow.
void ModelWriter::reserve() {
    constexpr std::size_t quad_points = 16, triangle_points = 25, thirds = 3;
    const std::size_t pieces = table_.patches().size() * (table_.triangular() ? thirds : 1);
    model_.patches.reserve(pieces);
    model_.control_points.reserve(pieces * (table_.triangular() ? triangle_points : quad_points));
}

void ModelWriter::begin_face(std::uint32_t base) {
    Face face;
    face.id = base + 1;
    face.name = name(bases_[base]);
    face.layer = cage_.names[cage_.faces[bases_[base].face].material];
    face.surface_kind = cage_.scheme == Scheme::loop ? "loop" : "catmull-clark";
    face.first_patch = size32(model_.patches);
    face.approximated = caps_[base].height;
    model_.faces.push_back(face);
}

std::string ModelWriter::name(const Base& base) const {
    const CageFace& face = cage_.faces[base.face];
    const std::string& group = cage_.names[face.group];
    std::string text = (group.empty() ? "f" : group + "-f") + std::to_string(base.face + 1);
    if (base_faces(cage_, face) > 1) text += "." + std::to_string(base.corner + 1);
    return text;
}

void ModelWriter::append(const std::vector<LimitPatch>& patches) {
    for (const LimitPatch& limit : patches) {
        Patch patch;
        patch.face = size32(model_.faces) - 1;
        patch.first_point = size32(model_.control_points);
        patch.degree_u = patch.degree_v = static_cast<std::uint16_t>(limit.degree);
        patch.map_u.begin = limit.box.lower.x, patch.map_u.end = limit.box.upper.x;
        patch.map_v.begin = limit.box.lower.y, patch.map_v.end = limit.box.upper.y;
        for (const Vec3& p : limit.points) {
            const Vec3 world = table_.center() + p;
            model_.control_points.emplace_back(world.x, world.y, world.z, 1);
        }
        model_.patches.push_back(patch);
        ++model_.faces.back().patch_count;
    }
}

void ModelWriter::append_irregular(LimitTable::Index cap) {
    const double far = table_.triangular() ? 0.5 : 1;
    const auto at = [&](double u, double v) { return table_.evaluate(cap, u, v).position; };
    const Vec3 middle = at(far / 2, far / 2);
    double radius = 0;
    for (const Vec2& corner : {Vec2(0, 0), Vec2(1, 0), Vec2(0, 1), Vec2(far, far)})
        radius = std::max(radius, (at(corner.x, corner.y) - middle).length());
    model_.irregular_patches.push_back(
        {size32(model_.faces) - 1, table_.center() + middle, radius});
}

/// mm, from corner to corner.
double widest_cap(const LimitTable& table) {
    double widest = 0;
    for (const LimitTable::Index index : table.caps())
        for (const Vec2& far : {Vec2(1, 0), Vec2(0, 1), Vec2(1, 1)}) {
            if (table.triangular() && far.x + far.y > 1) continue;
            const Vec3 from = table.evaluate(index, 0, 0).position;
            widest =
                std::max(widest, (table.evaluate(index, far.x, far.y).position - from).length());
        }
    return widest;
}

void append_remarks(const Cage& cage, const CapChoice& choice, SurfaceModel& model) {
    model.diagnostics = cage.diagnostics;
    CapError worst;
    for (const CapError& error : choice.errors) worst.extend(error);
    const double size = cage.size(), widest = widest_cap(*choice.table);
    if (!(widest > 0)) return;
    char text[200];
    std::snprintf(text, sizeof text,
                  "exact but for the last ring around irregular points, at most %.2g of the size "
                  "wide: there within %.2g of the size and %.2g rad",
                  widest / size, worst.height / size, worst.angle);
    model.diagnostics.push_back({Severity::note, "", text});
}

} // namespace

SurfaceModel read_subdivision_file(const std::filesystem::path& path, const Job& job) {
    const Cage cage = read_cage(path);
    try {
        const CapChoice choice = choose_caps(cage, job);
        SurfaceModel model = ModelWriter(cage, *choice.table, choice.errors).write();
        if (model.faces.empty()) throw Error("", "", "no face of the cage carries a surface");
        model.source = path.string();
        model.format = "OBJ";
        model.parts.push_back({path.stem().string(), 0, size32(model.faces)});
        model.instances.push_back({0, path.stem().string(), {}});
        append_remarks(cage, choice, model);
        return model;
    } catch (const Error& e) {
        throw Error(path.string(), "", e.reason());
    }
}

} // namespace keiko
