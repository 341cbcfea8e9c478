#include "keiko/report/record_files.h"

#include "keiko/base/error.h"
#include "keiko/base/sha256.h"
#include "keiko/film/image_file.h"
#include "keiko/report/json/json_parts.h"

namespace keiko {
namespace {

const std::string metrics_file = "metrics.json", manifest_file = "manifest.json",
                  rig_file = "rig.toml";
constexpr const char* metrics_format = "keiko-metrics/1";
constexpr const char* manifest_format = "keiko-manifest/1";

std::string file_of(const std::string& view, const std::string& layer) {
    return view + "." + layer + ".exr";
}

/// JSON on one line, so that version control shows which metric changed.
std::string line_of(const Json& json) {
    return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

Json metric_json(const Metric& metric) {
    Json json = {
        {"check", metric.check}, {"name", metric.name}, {"quantity", name_of(metric.quantity)}};
    if (const double* real = std::get_if<double>(&metric.value))
        json["value"] = real_json(*real);
    else
        json["word"] = std::get<std::string>(metric.value);
    return json;
}

Metric metric_from(const Json& json) {
    Metric metric{json.at("check"), json.at("name"),
                  quantity_by_name(json.at("quantity").get<std::string>()), 0.0};
    if (json.contains("word"))
        metric.value = json.at("word").get<std::string>();
    else
        metric.value = real_from(json.at("value"));
    return metric;
}

std::string lines_of(const Json& array) {
    std::string text = "[";
    for (const Json& element : array)
        text += (text.size() > 1 ? ",\n  " : "\n  ") + line_of(element);
    return text + "\n ]";
}

std::string metrics_text(const FixtureRecord& record) {
    Json metrics = Json::array(), pictures = Json::array(), eyes = Json::array();
    for (const Metric& metric : record.metrics) metrics.push_back(metric_json(metric));
    for (const FixturePicture& picture : record.pictures) {
        Json layers = Json::array();
        for (const auto& [name, layer] : layers_of(picture.film)) layers.push_back(name);
        pictures.push_back({{"view", picture.view}, {"layers", layers}});
    }
    for (const FixtureEye& eye : record.setup.eyes)
        eyes.push_back(
            {{"asked", eye.asked}, {"view", eye.view}, {"camera", camera_json(eye.camera)}});
    return std::string("{\n \"format\": \"") + metrics_format +
           "\",\n \"metrics\": " + lines_of(metrics) + ",\n \"pictures\": " + lines_of(pictures) +
           (eyes.empty() ? "" : ",\n \"eyes\": " + lines_of(eyes)) + "\n}\n";
}

Json change_json(const BaselineChange& change) {
    return {{"date", change.date},
            {"by", change.by},
            {"reason", change.reason},
            {"tool", change.tool},
            {"changed", change.changed}};
}

BaselineChange change_from(const Json& json) {
    return {json.at("date"), json.at("by"), json.at("reason"), json.at("tool"),
            json.at("changed").get<std::vector<std::string>>()};
}

std::vector<BaselineChange> changes_from(const Json& manifest) {
    std::vector<BaselineChange> changes;
    for (const Json& change : manifest.at("changes")) changes.push_back(change_from(change));
    return changes;
}

std::string manifest_text(const KeptRecord& kept, const FolderContent& files) {
    Json json = {{"format", manifest_format}};
    if (!kept.key.empty()) json["key"] = kept.key;
    json["files"] = Json::object();
    for (const auto& [name, bytes] : files) json["files"][name] = sha256_hex(bytes);
    json["changes"] = Json::array();
    for (const BaselineChange& change : kept.changes)
        json["changes"].push_back(change_json(change));
    return text_of(json);
}

const std::string& content_of(const FolderContent& files, const std::string& name) {
    const auto found = files.find(name);
    if (found == files.end()) throw Error("", shortened(name), "is missing");
    return found->second;
}

Json parsed(const FolderContent& files, const std::string& name, const char* format) {
    Json json = Json::parse(content_of(files, name));
    if (json.at("format") != format)
        throw Error("", name, std::string("is not of the format ") + format);
    return json;
}

void require_unharmed(const FolderContent& files, const Json& manifest) {
    for (const auto& [name, hash] : manifest.at("files").items())
        if (sha256_hex(content_of(files, name)) != hash.get<std::string>())
            throw Error("", name, "is not what " + manifest_file + " says: damaged or edited");
    for (const auto& [name, bytes] : files)
        if (name != manifest_file && !manifest.at("files").contains(name))
            throw Error("", name, "is not in " + manifest_file);
}

FixturePicture picture_from(const FolderContent& files, const Json& json) {
    FixturePicture picture{json.at("view"), {}};
    std::map<std::string, NamedImage> layers;
    for (const std::string layer : json.at("layers")) {
        const std::string name = file_of(picture.view, layer);
        layers[layer] = decode_exr(content_of(files, name), name);
    }
    picture.film = film_of(layers);
    return picture;
}

KeptRecord parsed_record(const FolderContent& files) {
    const Json manifest = parsed(files, manifest_file, manifest_format);
    require_unharmed(files, manifest);
    KeptRecord kept;
    kept.key = manifest.value("key", "");
    kept.changes = changes_from(manifest);
    const Json metrics = parsed(files, metrics_file, metrics_format);
    for (const Json& metric : metrics.at("metrics"))
        kept.record.metrics.push_back(metric_from(metric));
    for (const Json& picture : metrics.at("pictures"))
        kept.record.pictures.push_back(picture_from(files, picture));
    for (const Json& eye : metrics.value("eyes", Json::array()))
        kept.record.setup.eyes.push_back(
            {eye.at("asked"), eye.at("view"), camera_from(eye.at("camera"))});
    if (files.count(rig_file) != 0) kept.record.setup.placed_rig = files.at(rig_file);
    return kept;
}

} // namespace

FolderContent files_of(const KeptRecord& kept) {
    FolderContent files{{metrics_file, metrics_text(kept.record)}};
    for (const FixturePicture& picture : kept.record.pictures)
        for (const auto& [layer, image] : layers_of(picture.film))
            files[file_of(picture.view, layer)] = encode_exr(image);
    if (!kept.record.setup.placed_rig.empty()) files[rig_file] = kept.record.setup.placed_rig;
    files[manifest_file] = manifest_text(kept, files);
    return files;
}

KeptRecord record_of(const FolderContent& files, const std::string& folder) {
    try {
        return parsed_record(files);
    } catch (const Cancelled&) {
        throw;
    } catch (const Error& error) {
        throw Error(folder, error.where(), error.reason());
    } catch (const std::exception& error) { // thrown by the JSON library
        throw Error(folder, "", "cannot be read: " + shortened(error.what()));
    }
}

std::vector<BaselineChange> changes_in(const FolderContent& files) {
    try {
        return changes_from(parsed(files, manifest_file, manifest_format));
    } catch (const std::exception&) { // ours, and those of the JSON library
        return {};
    }
}

} // namespace keiko
