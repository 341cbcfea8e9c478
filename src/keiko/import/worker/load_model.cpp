#include "keiko/import/worker/load_model.h"

#include "keiko/base/error.h"
#include "keiko/base/units.h"
#include "keiko/files/model/bezier_file.h"
#include "keiko/files/model/model_format.h"
#include "keiko/import/worker/axes_frame.h"
#include "keiko/import/worker/model_cache.h"

#include <unistd.h>

#include <algorithm>

namespace keiko {

std::uint64_t usual_memory_limit() {
    constexpr std::uint64_t most = 16ull << 30;
    const long pages = sysconf(_SC_PHYS_PAGES), size = sysconf(_SC_PAGESIZE);
    if (pages <= 0 || size <= 0) return most;
    return std::min(most, static_cast<std::uint64_t>(pages) * static_cast<std::uint64_t>(size));
}

namespace {

/// Keeps a model unless its file was touched while it was read. Throws Error when the file changed:
/// the model may be of neither content.
void keep_unless_touched(const std::filesystem::path& path, const ModelKey& key,
                         const ModelCache& cache, SurfaceModel& model) {
    const FileState now = file_state(path);
    if (now.sha256 != key.file.sha256)
        throw Error(path.string(), "", "the file changed while it was read");
    if (now.stamp == key.file.stamp) cache.keep(key, model);
}

/// From the cache, or else from the worker.
SurfaceModel import_cached(const std::filesystem::path& path, ModelFormat format,
                           const LoadOptions& options, const Job& job) {
    if (options.cache.empty()) return import_in_worker(path, format, options, job);
    const ModelCache cache(options.cache, options.cache_limit);
    const auto key = ModelCache::key(path, format, worker_path(options));
    if (!key) return import_in_worker(path, format, options, job);
    if (auto known = cache.find(*key)) return std::move(*known);
    SurfaceModel model = import_in_worker(path, format, options, job);
    keep_unless_touched(path, *key, cache, model);
    return model;
}

SurfaceModel read_model(const std::filesystem::path& path, ModelFormat format,
                        const LoadOptions& options, const Job& job) {
    switch (format) {
        case ModelFormat::bezier:
            return read_bezier_file(path);
        case ModelFormat::teapot:
            return read_teapot_file(path);
        default:
            return import_cached(path, format, options, job);
    }
}

/// Millimetres per unit of the file as it was read; a file without a unit was read as mm.
double unit_of(const SurfaceModel& model) {
    if (model.unit.empty()) return 1;
    const auto known = millimetres_per(model.unit);
    if (!known)
        throw Error(model.source, "", "its unit \"" + model.unit + "\" cannot be overridden");
    return *known;
}

void override_unit(SurfaceModel& model, const std::string& unit) {
    const auto wanted = millimetres_per(unit);
    if (!wanted) throw Error(model.source, "", "unknown length unit \"" + unit + "\"");
    if (const double factor = *wanted / unit_of(model); factor != 1) scale_lengths(model, factor);
    model.diagnostics.push_back({Severity::note, "",
                                 "read in " + unit + ", not in " +
                                     (model.unit.empty() ? "mm (it names no unit)" : model.unit)});
    model.unit = unit;
}

/// One of x, y, z, -x, -y, -z; of length 0 for any other word.
Vec3 axis_named(std::string_view word) {
    const bool other_end = word.starts_with('-');
    if (other_end) word.remove_prefix(1);
    Vec3 axis(0);
    if (word == "x" || word == "y" || word == "z") axis[word[0] - 'x'] = other_end ? -1 : 1;
    return axis;
}

/// Turns a model into the vehicle frame. Only placements change, by exact numbers. Throws Error as
/// axes_frame does.
void turn_axes(SurfaceModel& model, std::string_view axes) {
    try {
        const Affine frame = axes_frame(axes);
        for (Instance& instance : model.instances) instance.transform = frame * instance.transform;
    } catch (const Error& e) {
        throw Error(model.source, "", e.reason());
    }
    model.diagnostics.push_back(
        {Severity::note, "",
         "turned: its " + std::string(axes) + " point rearwards, to the right and up"});
}

} // namespace

Affine axes_frame(std::string_view axes) {
    Affine frame;
    std::string_view rest = axes;
    for (Vec3& row : frame.rows) {
        const auto end = std::min(rest.find(','), rest.size());
        row = axis_named(rest.substr(0, end));
        rest.remove_prefix(std::min(end + 1, rest.size()));
    }
    const bool three_words = rest.empty() && !axes.ends_with(',');
    if (!three_words || frame.determinant() == 0)
        throw Error("", "",
                    "axes " + in_quotes(std::string(axes)) +
                        ": not three words of x, y, z, -x, -y and -z with each letter once");
    if (frame.mirrored())
        throw Error("", "",
                    "axes " + in_quotes(std::string(axes)) +
                        ": would mirror the body; one of them points the other way");
    return frame;
}

SurfaceModel load_model(const std::filesystem::path& path, const LoadOptions& options,
                        const Job& job) {
    job.check();
    job.report("import", 0);
    const ModelFormat format = detect_model_format(path);
    SurfaceModel model = read_model(path, format, options, job);
    model.source = path.string();
    if (!model.faces.empty() && hull_bounds(model).size() == 0)
        throw Error(path.string(), "", "all its points are in one place: it is no surface");
    if (!options.unit.empty()) override_unit(model, options.unit);
    if (!options.axes.empty()) turn_axes(model, options.axes);
    job.report("import", 1);
    return model;
}

void scale_lengths(SurfaceModel& model, double factor) {
    for (Vec4& p : model.control_points) p = {p.x * factor, p.y * factor, p.z * factor, p.w};
    for (Edge& edge : model.edges) edge.tolerance *= factor;
    for (Face& face : model.faces) face.approximated *= factor;
    for (IrregularPatch& p : model.irregular_patches) p.center *= factor, p.radius *= factor;
    for (Repair& repair : model.repairs) repair.size *= factor;
    for (Instance& instance : model.instances) instance.transform.translation *= factor;
}

} // namespace keiko
