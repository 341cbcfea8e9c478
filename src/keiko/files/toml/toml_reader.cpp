#include "keiko/files/toml/toml_reader.h"

#include "keiko/base/input_file.h"
#include "keiko/base/text.h"
#include "keiko/files/toml/toml_document.h"

#include <algorithm>

namespace keiko {

namespace {

struct OwnFormat {
    std::string_view name, use;
};

constexpr OwnFormat own_formats[] = {
    {"keiko-scene", "a scene: inspect, check, render and trace take it, as FILE.toml"},
    {"keiko-rig", "a rig: inspect, render and lines take it as their rig"},
    {"keiko-materials", "a file of materials: a scene names it"},
    {"keiko-voxels", "voxels: a [[volume]] of a scene names them"},
    {"keiko-preset", "a file of limits: inspect, check and lines take it as their preset"},
    {"keiko-fixture", "a fixture: regress takes the folder of its suite"},
    {"keiko-hits", "registered hits: place takes them instead of views"},
};

} // namespace

std::string use_of_format(std::string_view format) {
    const std::string_view name = format.substr(0, format.find('/'));
    for (const OwnFormat& own : own_formats)
        if (name == own.name) return std::string(own.use);
    return "";
}

TomlTable::TomlTable(std::shared_ptr<const TomlDocument> document, const TomlValue& value,
                     std::string name)
    : document_(std::move(document)), value_(&value), name_(std::move(name)) {}

TomlTable TomlTable::parse(std::string_view text, const std::string& source) {
    const auto document = std::make_shared<const TomlDocument>(parse_toml(text, source));
    return {document, document->root, ""};
}

TomlTable TomlTable::parse_alone(std::string_view text, const std::string& source) {
    TomlDocument parsed = parse_toml(text, source);
    parsed.may_name_files = false;
    const auto document = std::make_shared<const TomlDocument>(std::move(parsed));
    return {document, document->root, ""};
}

TomlTable TomlTable::read(const std::filesystem::path& path) {
    return parse(read_text_file(path), path.string());
}

const std::vector<TomlEntry>& TomlTable::entries() const {
    return std::get<std::vector<TomlEntry>>(value_->content);
}

const TomlEntry* TomlTable::find(std::string_view key) const {
    if (std::find(asked_.begin(), asked_.end(), key) == asked_.end()) asked_.emplace_back(key);
    for (const TomlEntry& entry : entries())
        if (entry.key == key) return &entry;
    return nullptr;
}

bool TomlTable::asked_for(const TomlEntry& entry) const {
    return std::find(asked_.begin(), asked_.end(), entry.key) != asked_.end();
}

bool TomlTable::has(std::string_view key) const {
    return find(key) != nullptr;
}

std::string_view TomlTable::kind(std::string_view key) const {
    const TomlEntry* entry = find(key);
    return entry ? entry->value.kind() : "";
}

void TomlTable::require_format(std::string_view expected) const {
    const std::string wanted = "format = \"" + std::string(expected) + "\"";
    const std::optional<std::string> given = text("format");
    if (!given) {
        refuse_misspelt();
        throw error("", "the file must begin with " + wanted);
    }
    if (*given == expected) return;
    const auto family = [](std::string_view format) { return format.substr(0, format.find('/')); };
    const std::string use = family(*given) == family(expected)
                                ? "a version that this program does not read"
                                : use_of_format(*given);
    throw error("format", "is '" + shortened(*given) + "'" + (use.empty() ? "" : ", " + use) +
                              "; expected " + wanted);
}

void TomlTable::not_yet(std::initializer_list<std::string_view> keys) const {
    for (const std::string_view key : keys)
        if (has(key)) throw error(key, "is not supported yet");
}

void TomlTable::finish() const {
    const TomlEntry* first = nullptr;
    for (const TomlEntry& entry : entries())
        if (!asked_for(entry) && (!first || entry.place < first->place)) first = &entry;
    if (first) throw unknown(*first, asked_);
}

void TomlTable::refuse_misspelt() const {
    std::vector<std::string> absent;
    for (const std::string& key : asked_)
        if (!has(key)) absent.push_back(key);
    for (const TomlEntry& entry : entries())
        if (!asked_for(entry) && !did_you_mean(entry.key, absent).empty())
            throw unknown(entry, absent);
}

Error TomlTable::unknown(const TomlEntry& entry, std::span<const std::string> known) const {
    return {document_->source.string(), entry.place.text(),
            "unknown key '" + shortened(path_of(entry.key)) + "'" + did_you_mean(entry.key, known)};
}

Error TomlTable::error(std::string_view key, const std::string& reason) const {
    const TomlEntry* entry = key.empty() ? nullptr : find(key);
    const TomlValue& at = entry ? entry->value : *value_;
    const std::string subject = key.empty() ? name_ : path_of(key);
    return {document_->source.string(), at.place.text(),
            subject.empty() ? reason : subject + ": " + reason};
}

std::string TomlTable::path_of(std::string_view key) const {
    return name_.empty() ? std::string(key) : name_ + "." + std::string(key);
}

void TomlTable::refuse_missing(std::string_view key) const {
    refuse_misspelt();
    throw error("", "'" + std::string(key) + "' is missing");
}

Error TomlTable::mismatch(std::string_view key, const std::string& wanted) const {
    return error(key, "must be " + wanted);
}

std::uint32_t TomlTable::line() const {
    return value_->place.line;
}

const std::filesystem::path& TomlTable::source() const {
    return document_->source;
}

bool TomlTable::may_name_files() const {
    return document_->may_name_files;
}

std::optional<std::filesystem::path> path_from(const TomlTable& table, std::string_view key) {
    const auto name = table.text(key);
    if (!name) return {};
    return readable_path(table, key, *name);
}

std::filesystem::path readable_path(const TomlTable& table, std::string_view key,
                                    const std::string& name) {
    if (!table.may_name_files()) throw table.error(key, "may not name a file here");
    auto path = (table.source().parent_path() / name).lexically_normal();
    try {
        require_readable_file(path);
    } catch (const Error& error) {
        throw table.error(key, shortened(error.what()));
    }
    return path;
}

Rgb color_of(const TomlTable& table) {
    return table.rgb("color", TomlLimits::light()).value_or(Rgb(1));
}

void require_light(const TomlTable& table, std::string_view key, const Rgb& light) {
    const double most = TomlLimits::light().high;
    if (light.r <= most && light.g <= most && light.b <= most) return;
    const bool colored = table.has("color");
    throw table.error(table.has(key) || !colored ? key : "color",
                      colored ? "is too bright, times the color" : "is too bright");
}

} // namespace keiko
