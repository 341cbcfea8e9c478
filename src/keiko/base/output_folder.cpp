#include "keiko/base/output_folder.h"

#include "keiko/base/error.h"
#include "keiko/base/input_file.h"
#include "keiko/base/output_file.h"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <system_error>
#include <thread>
#include <vector>

namespace keiko {
namespace fs = std::filesystem;
namespace {

/// Taken for granted of what is no number.
bool is_running(const std::string& pid) {
    const bool number = !pid.empty() && std::all_of(pid.begin(), pid.end(),
                                                    [](char c) { return c >= '0' && c <= '9'; });
    if (!number) return true;
    return kill(static_cast<pid_t>(std::strtol(pid.c_str(), nullptr, 10)), 0) == 0 ||
           errno == EPERM;
}

/// Whether it is named as write_atomically and write_folder_atomically name what is not finished,
/// ".name.PID.tmp" and perhaps an ending, by a process that is gone.
bool is_leftover(const fs::path& path) {
    const std::string name = path.filename().string();
    const std::size_t end = name.find(".tmp");
    if (!name.starts_with(".") || end == std::string::npos || end == 0) return false;
    const std::size_t dot = name.rfind('.', end - 1);
    const bool whole = end + 4 == name.size() || name[end + 4] == '.';
    if (!whole || dot == 0) return false;
    return !is_running(name.substr(dot + 1, end - dot - 1));
}

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
        if (is_leftover(path)) fs::remove_all(path, ignored);
        if (path.filename().string().starts_with(".") && path.extension() == ".before" &&
            fs::is_directory(path, ignored))
            restore(path);
    }
}

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

/// Whether the lock is had before the time is over.
bool locks_within(int descriptor, int kind, std::chrono::milliseconds time) {
    const auto end = std::chrono::steady_clock::now() + time;
    while (flock(descriptor, kind | LOCK_NB) != 0) {
        if (std::chrono::steady_clock::now() >= end) return false;
        std::this_thread::sleep_for(std::chrono::milliseconds(20));
    }
    return true;
}

} // namespace

FolderLock::FolderLock(const fs::path& folder) {
    std::error_code code;
    fs::create_directories(folder, code);
    if (code) throw Error(folder.string(), "", "cannot make the folder: " + code.message());
    descriptor_ = open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    if (descriptor_ < 0)
        throw Error(folder.string(), "", std::string("cannot read: ") + std::strerror(errno));
    const bool locked = locks_within(descriptor_, LOCK_EX, std::chrono::seconds(1));
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
    const fs::path temporary = target.parent_path() / ("." + target.filename().string() + "." +
                                                       std::to_string(getpid()) + ".tmp");
    std::error_code ignored;
    try {
        fs::remove_all(temporary);
        fs::create_directories(temporary);
        for (const auto& [name, bytes] : content) write_text_file(temporary / name, bytes);
        put_in_place(temporary, target);
        sync_to_disk(target.parent_path());
    } catch (const fs::filesystem_error& error) {
        fs::remove_all(temporary, ignored);
        throw Error(target.string(), "", "cannot write: " + error.code().message());
    } catch (...) {
        fs::remove_all(temporary, ignored);
        throw;
    }
    fs::remove_all(temporary, ignored);
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

} // namespace keiko
