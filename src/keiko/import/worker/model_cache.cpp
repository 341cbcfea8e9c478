#include "keiko/import/worker/model_cache.h"

#include "keiko/base/error.h"
#include "keiko/base/input_file.h"
#include "keiko/base/new_file.h"
#include "keiko/base/output_target.h"
#include "keiko/base/sha256.h"
#include "keiko/files/model/model_serialization.h"

#include <dirent.h>
#include <sys/stat.h>

#include <algorithm>
#include <cerrno>
#include <memory>
#include <tuple>
#include <vector>

namespace keiko {

namespace fs = std::filesystem;
namespace {

constexpr mode_t private_folder = 0700, writable_by_others = S_IWGRP | S_IWOTH;

bool is_own(const struct stat& status) {
    return status.st_uid == geteuid() && (status.st_mode & writable_by_others) == 0;
}

void make_folder(const fs::path& folder) {
    std::error_code code;
    fs::create_directories(folder.parent_path(), code); // what is missing shows at the next step
    if (mkdir(folder.c_str(), private_folder) != 0 && errno != EEXIST)
        throw_system_error(folder, "cannot make the folder");
}

std::string read_all(const Descriptor& file, std::size_t size) {
    std::string content(size, '\0');
    std::size_t filled = 0;
    while (filled < size) {
        const ssize_t got = read(file.number(), content.data() + filled, size - filled);
        if (got < 0 && errno == EINTR) continue;
        if (got <= 0) break;
        filled += static_cast<std::size_t>(got);
    }
    content.resize(filled);
    return content;
}

/// Names of all that is in an open folder.
std::vector<std::string> names_in(const Descriptor& folder) {
    std::vector<std::string> names;
    const int listed = openat(folder.number(), ".", O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    const std::unique_ptr<DIR, int (*)(DIR*)> entries(listed < 0 ? nullptr : fdopendir(listed),
                                                      closedir);
    if (!entries) return names;
    while (const dirent* entry = readdir(entries.get())) names.emplace_back(entry->d_name);
    return names;
}

/// Entry of the folder, by when it was used.
struct UsedEntry {
    std::int64_t seconds, nanoseconds;
    std::string name;
    std::uint64_t size;
};

std::vector<UsedEntry> entries_by_use(const Descriptor& folder, const std::string& ending) {
    std::vector<UsedEntry> entries;
    for (std::string& name : names_in(folder)) {
        struct stat status {};
        if (!name.ends_with(ending) ||
            fstatat(folder.number(), name.c_str(), &status, AT_SYMLINK_NOFOLLOW) != 0 ||
            !S_ISREG(status.st_mode))
            continue;
        entries.push_back({status.st_mtim.tv_sec, status.st_mtim.tv_nsec, std::move(name),
                           static_cast<std::uint64_t>(status.st_size)});
    }
    std::sort(entries.begin(), entries.end(), [](const UsedEntry& a, const UsedEntry& b) {
        return std::tie(a.seconds, a.nanoseconds, a.name) <
               std::tie(b.seconds, b.nanoseconds, b.name);
    });
    return entries;
}

} // namespace

CacheFolder::CacheFolder(fs::path folder, std::string ending, std::uint64_t limit)
    : path_(folder.has_filename() ? std::move(folder) : folder.parent_path()),
      ending_(std::move(ending)),
      limit_(limit) {
    const fs::path behind = behind_links(path_);
    make_folder(behind);
    folder_.reset(open(behind.c_str(), O_RDONLY | O_DIRECTORY | O_NOFOLLOW | O_CLOEXEC));
    struct stat status {};
    if (!folder_.open() || fstat(folder_.number(), &status) != 0)
        throw_system_error(path_, "cannot make the folder");
    if (status.st_uid != geteuid()) fail("the folder belongs to another user");
    if (!is_own(status)) fail("others may write in the folder; chmod go-w ends that");
    if (faccessat(folder_.number(), ".", W_OK | X_OK, AT_EACCESS) != 0)
        fail("no permission to write in the folder");
}

void CacheFolder::fail(const std::string& reason) const {
    throw Error(path_.string(), "", reason);
}

std::optional<std::string> CacheFolder::read(const std::string& name) const {
    constexpr int flags = O_RDONLY | O_NOFOLLOW | O_NONBLOCK | O_NOCTTY | O_CLOEXEC;
    const Descriptor file(openat(folder_.number(), name.c_str(), flags));
    struct stat status {};
    if (!file.open() || fstat(file.number(), &status) != 0) return std::nullopt;
    if (!S_ISREG(status.st_mode) || !is_own(status)) return std::nullopt;
    futimens(file.number(), nullptr);
    return read_all(file, static_cast<std::size_t>(status.st_size));
}

void CacheFolder::write(const std::string& name,
                        const std::function<void(const TakeBytes& sink)>& content) const {
    TemporaryFile file(name, private_file, folder_.number());
    std::uint64_t size = 0;
    content([&](std::string_view piece) {
        size += piece.size();
        if (limit_ > 0 && size > limit_)
            fail("larger than the " + std::to_string(limit_) + " bytes that the folder may hold");
        file.write(piece);
    });
    file.finish();
    file.put_in_place();
    remove_least_recently_used(name);
}

void CacheFolder::remove_least_recently_used(const std::string& spared) const {
    for (const std::string& name : names_in(folder_))
        if (is_abandoned(name)) unlinkat(folder_.number(), name.c_str(), 0);
    if (limit_ == 0) return;
    const std::vector<UsedEntry> entries = entries_by_use(folder_, ending_);
    std::uint64_t total = 0;
    for (const UsedEntry& entry : entries) total += entry.size;
    for (const UsedEntry& entry : entries) {
        if (total <= limit_) return;
        if (entry.name == spared) continue;
        unlinkat(folder_.number(), entry.name.c_str(), 0);
        total -= entry.size;
    }
}

namespace {

/// Stamp of the file that a path leads to. Throws Error.
FileStamp file_stamp(const std::filesystem::path& file) {
    struct stat status {};
    if (stat(file.c_str(), &status) != 0) throw_system_error(file, "cannot read");
    return {status.st_dev, status.st_ino, static_cast<std::uint64_t>(status.st_size),
            status.st_ctim.tv_sec * 1'000'000'000 + status.st_ctim.tv_nsec};
}

constexpr const char* ending = ".keiko-model";

/// Tells one build of the reader from another.
std::string stamp(const fs::path& worker) {
    std::error_code code;
    const auto size = fs::file_size(worker, code);
    const auto time = fs::last_write_time(worker, code).time_since_epoch().count();
    return std::to_string(size) + " " + std::to_string(time);
}

/// First line of an entry, which binds it to its key.
std::string header(const ModelKey& key) {
    return "KEIKO-MC 1 " + key.text + "\n";
}

} // namespace

FileState file_state(const std::filesystem::path& file) {
    const FileStamp stamp = file_stamp(file);
    return {stamp, sha256_hex(read_file(file))};
}

ModelCache::ModelCache(fs::path folder, std::uint64_t limit)
    : folder_(std::move(folder), ending, limit) {}

std::optional<ModelKey> ModelCache::key(const fs::path& file, ModelFormat format,
                                        const fs::path& worker) {
    ModelKey key{"", {file_stamp(file), ""}};
    const std::string bytes = read_file(file);
    if (format == ModelFormat::step && bytes.find("DOCUMENT_FILE") != std::string::npos)
        return std::nullopt;
    key.file.sha256 = sha256_hex(bytes);
    std::string text;
    // The name of the file becomes that of a part without a name of its own.
    for (const std::string& part :
         {key.file.sha256, std::string(name_of(format)), file.stem().string(),
          std::string(KEIKO_READERS), std::to_string(model_serialization_version), stamp(worker)})
        text += part + "\n";
    key.text = sha256_hex(text);
    return key;
}

std::optional<SurfaceModel> ModelCache::find(const ModelKey& key) const {
    const std::optional<std::string> entry = folder_.read(key.text + ending);
    const std::string first_line = header(key);
    if (!entry || !entry->starts_with(first_line)) return std::nullopt;
    try {
        return deserialize(std::string_view(*entry).substr(first_line.size()), key.text);
    } catch (const Error&) {
        return std::nullopt;
    }
}

void ModelCache::keep(const ModelKey& key, SurfaceModel& model) const {
    try {
        folder_.write(key.text + ending, [&](const TakeBytes& sink) {
            sink(header(key));
            serialize(model, sink);
        });
    } catch (const Error& e) {
        model.diagnostics.push_back(
            {Severity::warning, "", std::string("not kept in the cache: ") + e.what()});
    }
}

} // namespace keiko
