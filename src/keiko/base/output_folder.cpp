#include "keiko/base/output_folder.h"

#include "keiko/base/error.h"
#include "keiko/base/input_file.h"
#include "keiko/base/new_file.h"
#include "keiko/base/output_file.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <cstdio>
#include <cstring>
#include <deque>
#include <system_error>
#include <thread>
#include <vector>

namespace keiko {
namespace fs = std::filesystem;
namespace {

/// ".name.before": the folder `name` while another takes its place.
fs::path set_aside(const fs::path& target) {
    return target.parent_path() / ("." + target.filename().string() + ".before");
}

/// Puts back what was set aside by a writer that was killed before it put the new one in place.
void restore(const fs::path& aside) {
    const std::string name = aside.filename().string();
    const fs::path target = aside.parent_path() / name.substr(1, name.rfind('.') - 1);
    std::error_code ignored; // what is missing shows when it is read
    if (fs::exists(target, ignored))
        fs::remove_all(aside, ignored);
    else
        fs::rename(aside, target, ignored);
}

void clear_after_killed_writers(const fs::path& folder) {
    std::error_code ignored; // what cannot be removed shows when it is written
    std::vector<fs::path> paths;
    for (const fs::directory_entry& entry : fs::directory_iterator(folder, ignored))
        paths.push_back(entry.path());
    for (const fs::path& path : paths) {
        const std::string name = path.filename().string();
        if (is_abandoned(name)) fs::remove_all(path, ignored);
        if (name.starts_with(".") && path.extension() == ".before" &&
            fs::is_directory(fs::symlink_status(path, ignored)))
            restore(path);
    }
}

/// New folder beside the place that it is meant for. What stands at its path in the end, the new
/// folder or the old one, is removed.
class FreshFolder {
public:
    explicit FreshFolder(const fs::path& target)
        : target_(target), path_(target.parent_path() / temporary_name()) {
        std::error_code code;
        fs::create_directories(target.parent_path(), code);
        if (mkdir(path_.c_str(), 0777) != 0) throw_system_error(target, "cannot write");
        folder_.reset(open(path_.c_str(), O_RDONLY | O_DIRECTORY | O_NOFOLLOW | O_CLOEXEC));
        if (!folder_.open()) throw_system_error(target, "cannot write");
    }
    ~FreshFolder() {
        std::error_code ignored;
        fs::remove_all(path_, ignored);
    }
    FreshFolder(const FreshFolder&) = delete;
    FreshFolder& operator=(const FreshFolder&) = delete;

    const fs::path& path() const { return path_; }
    void write(const std::string& name, std::string_view bytes) const {
        try {
            TemporaryFile file(name, public_file, folder_.number());
            file.write(bytes);
            file.finish();
            file.put_in_place();
        } catch (const Error& error) {
            throw Error((target_ / name).string(), error.where(), error.reason());
        }
    }
    /// Waits until the names of its files are on the disk.
    void finish() const { fsync(folder_.number()); }

private:
    fs::path target_, path_;
    Descriptor folder_;
};

/// Puts `fresh` where `target` is. File systems that cannot exchange two names see no folder there
/// for a moment; whoever locks next mends that.
void put_in_place(const fs::path& fresh, const fs::path& target) {
    if (!fs::exists(target)) {
        fs::rename(fresh, target);
        return;
    }
    if (renameat2(AT_FDCWD, fresh.c_str(), AT_FDCWD, target.c_str(), RENAME_EXCHANGE) == 0) return;
    const fs::path aside = set_aside(target);
    fs::rename(target, aside);
    std::error_code code;
    fs::rename(fresh, target, code);
    if (code) {
        fs::rename(aside, target);
        throw fs::filesystem_error("rename", fresh, target, code);
    }
    fs::remove_all(aside);
}

/// True if the lock is had before the time is over.
bool locks_within(int descriptor, int kind, std::chrono::milliseconds time) {
    const auto end = std::chrono::steady_clock::now() + time;
    while (flock(descriptor, kind | LOCK_NB) != 0) {
        if (std::chrono::steady_clock::now() >= end) return false;
        std::this_thread::sleep_for(std::chrono::milliseconds(20));
    }
    return true;
}

} // namespace

FolderLock::FolderLock(const fs::path& folder, std::chrono::milliseconds patience) {
    std::error_code code;
    fs::create_directories(folder, code);
    if (code) throw Error(folder.string(), "", "cannot make the folder: " + code.message());
    descriptor_ = open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    if (descriptor_ < 0)
        throw Error(folder.string(), "", std::string("cannot read: ") + std::strerror(errno));
    const bool locked = locks_within(descriptor_, LOCK_EX, patience);
    if (!locked || access(folder.c_str(), W_OK | X_OK) != 0) {
        close(descriptor_);
        throw Error(folder.string(), "",
                    locked ? "no permission to write in the folder"
                           : "another process is writing to this folder");
    }
    clear_after_killed_writers(folder);
}

FolderLock::~FolderLock() {
    close(descriptor_);
}

FolderReadLock::FolderReadLock(const fs::path& folder)
    : descriptor_(open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC)) {
    if (descriptor_ < 0 || locks_within(descriptor_, LOCK_SH, std::chrono::seconds(10))) return;
    close(descriptor_);
    throw Error(folder.string(), "", "another process is writing to this folder");
}

FolderReadLock::~FolderReadLock() {
    if (descriptor_ >= 0) close(descriptor_);
}

void write_folder_atomically(const fs::path& target, const FolderContent& content) {
    const FreshFolder fresh(target);
    for (const auto& [name, bytes] : content) fresh.write(name, bytes);
    fresh.finish();
    try {
        put_in_place(fresh.path(), target);
    } catch (const fs::filesystem_error& error) {
        throw Error(target.string(), "", "cannot write: " + error.code().message());
    }
    sync_to_disk(target.parent_path());
}

FolderContent read_folder(const fs::path& folder) {
    FolderContent content;
    std::error_code code;
    if (fs::status(folder, code).type() == fs::file_type::not_found) return content;
    if (code) throw Error(folder.string(), "", "cannot read the folder: " + code.message());
    try {
        for (const fs::directory_entry& entry : fs::directory_iterator(folder))
            if (entry.is_regular_file())
                content[entry.path().filename().string()] = read_file(entry.path());
    } catch (const fs::filesystem_error& error) {
        throw Error(folder.string(), "", "cannot read the folder: " + error.code().message());
    }
    return content;
}

namespace fs = std::filesystem;
namespace {

/// Folders that are gone again, where nothing was put into them.
class MadeFolders {
public:
    MadeFolders() = default;
    MadeFolders(const MadeFolders&) = delete;
    MadeFolders& operator=(const MadeFolders&) = delete;
    ~MadeFolders() {
        std::error_code ignored;
        for (auto folder = made_.rbegin(); folder != made_.rend(); ++folder)
            fs::remove(*folder, ignored);
    }

    /// Makes a folder and the parents that are missing.
    void make(const fs::path& folder) {
        std::error_code code;
        if (folder.empty() || fs::is_directory(folder, code)) return;
        make(folder.parent_path());
        if (fs::create_directory(folder, code)) made_.push_back(folder);
        if (code) throw Error(folder.string(), "", "cannot make the folder: " + code.message());
    }

private:
    std::vector<fs::path> made_;
};

} // namespace

void FileTransaction::add(fs::path path, std::string bytes) {
    files_.emplace_back(std::move(path), std::move(bytes));
}

void FileTransaction::add_folder(const fs::path& folder, FolderContent&& content) {
    folders_.push_back(folder);
    for (auto& [name, bytes] : content) add(folder / name, std::move(bytes));
}

void FileTransaction::write() const {
    MadeFolders made;
    for (const fs::path& folder : folders_) made.make(folder);
    std::deque<AtomicFile> pending;
    for (const auto& [path, bytes] : files_) pending.emplace_back(path).fill(bytes);
    for (AtomicFile& file : pending) file.put_in_place();
}

} // namespace keiko
