#include "keiko/base/output_folder.h"

#include "keiko/base/error.h"
#include "keiko/base/input_file.h"
#include "keiko/base/output_file.h"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <system_error>
#include <vector>

namespace keiko {
namespace fs = std::filesystem;
namespace {

/// As write_atomically and write_folder_atomically name what is not finished: ".name.PID.tmp".
bool is_leftover(const fs::path& path) {
    const std::string name = path.filename().string();
    return name.starts_with(".") && name.find(".tmp") != std::string::npos;
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
        if (path.filename().string().starts_with(".") && path.extension() == ".before")
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
    fs::rename(fresh, target);
    fs::remove_all(aside);
}

} // namespace

FolderLock::FolderLock(const fs::path& folder) {
    std::error_code code;
    fs::create_directories(folder, code);
    if (code) throw Error(folder.string(), "", "cannot make the folder: " + code.message());
    descriptor_ = open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    if (descriptor_ < 0)
        throw Error(folder.string(), "", std::string("cannot read: ") + std::strerror(errno));
    const bool locked = flock(descriptor_, LOCK_EX | LOCK_NB) == 0;
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

void write_folder_atomically(const fs::path& target, const FolderContent& content) {
    const fs::path temporary = target.parent_path() / ("." + target.filename().string() + "." +
                                                       std::to_string(getpid()) + ".tmp");
    std::error_code ignored;
    try {
        fs::remove_all(temporary);
        fs::create_directories(temporary);
        for (const auto& [name, bytes] : content) write_text_file(temporary / name, bytes);
        put_in_place(temporary, target);
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
    if (!fs::exists(folder, code)) return content;
    for (const fs::directory_entry& entry : fs::directory_iterator(folder, code))
        if (entry.is_regular_file())
            content[entry.path().filename().string()] = read_file(entry.path());
    if (code) throw Error(folder.string(), "", "cannot read the folder: " + code.message());
    return content;
}

} // namespace keiko
