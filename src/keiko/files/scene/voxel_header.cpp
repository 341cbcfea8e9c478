#include "keiko/files/scene/voxel_header.h"

#include "keiko/base/input_file.h"
#include "keiko/files/toml/toml_reader.h"

namespace keiko {
namespace {

constexpr double most_nodes = 2048;                   ///< along an axis
constexpr double most_in_all = 1024. * 1024. * 1024.; ///< nodes: 8 GB with what is made of them

void take_raw(const TomlTable& table, VoxelFiles& voxels) {
    const auto nodes =
        table.required("nodes", table.numbers("nodes", 3, {.low = 2, .high = most_nodes}));
    for (std::size_t axis = 0; axis < 3; ++axis) {
        voxels.nodes[axis] = static_cast<int>(nodes[axis]);
        if (nodes[axis] != voxels.nodes[axis]) throw table.error("nodes", "must be whole numbers");
    }
    if (nodes[0] * nodes[1] * nodes[2] > most_in_all)
        throw table.error("nodes", "are more than 1024^3 in all");
    voxels.type = static_cast<VoxelFiles::Type>(
        table.required("type", table.choice("type", {"uint8", "uint16", "float32"})));
    voxels.channels = table.choice("channels", {"grey", "rgb"}) == 1 ? 3 : 1;
    voxels.big_endian = table.choice("byte_order", {"little", "big"}) == 1;
}

void take_slices(const TomlTable& table, VoxelFiles& voxels) {
    for (const std::string_view key : {"nodes", "type", "channels", "byte_order"})
        if (table.has(key)) throw table.error(key, "belongs to raw files: slices state their own");
    const auto names = table.required("slices", table.texts("slices"));
    if (names.size() < 2 || static_cast<double>(names.size()) > most_nodes)
        throw table.error("slices", "must be 2 to 2048 pictures");
    for (const std::string& name : names)
        voxels.slices.push_back(readable_path(table, "slices", name));
}

} // namespace

VoxelFiles parse_voxel_header(std::string_view text, const std::string& source) {
    const TomlTable table = TomlTable::parse(text, source);
    table.require_format("keiko-voxels/1");
    VoxelFiles voxels;
    voxels.header = source;
    if (const auto raw = path_from(table, "raw")) {
        if (table.has("slices")) throw table.error("slices", "give either raw or slices, not both");
        voxels.raw = *raw;
        take_raw(table, voxels);
    } else {
        take_slices(table, voxels);
    }
    voxels.origin = table.vector("origin").value_or(voxels.origin);
    const auto spacing =
        table.required("spacing", table.numbers("spacing", 3, TomlLimits::length()));
    voxels.spacing = Vec3(spacing[0], spacing[1], spacing[2]);
    table.finish();
    return voxels;
}

VoxelFiles read_voxel_header(const std::filesystem::path& path) {
    return parse_voxel_header(read_text_file(path), path.string());
}

} // namespace keiko
