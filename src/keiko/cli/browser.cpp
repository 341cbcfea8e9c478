#include "keiko/cli/browser.h"

#include "keiko/base/new_file.h"

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdlib>
#include <system_error>
#include <thread>

namespace keiko::cli {
namespace {

std::filesystem::path folder_of_session() {
    const char* folder = std::getenv("XDG_RUNTIME_DIR");
    std::error_code none;
    if (folder && std::filesystem::is_directory(folder, none)) return folder;
    return std::filesystem::temp_directory_path();
}

} // namespace

AddressPage::AddressPage(const std::string& address)
    : file_(folder_of_session() / (temporary_name() + ".html")) {
    const Descriptor file = create_file(file_, private_file);
    write_all(file,
              "<!DOCTYPE html><meta charset=\"utf-8\"><title>Keiko</title>"
              "<meta http-equiv=\"refresh\" content=\"0;url=" +
                  address + "\">\n",
              file_);
}

AddressPage::~AddressPage() {
    std::error_code none;
    std::filesystem::remove(file_, none);
}

bool AddressPage::show() const {
    std::string program = "xdg-open", page = file_.string();
    char* arguments[] = {program.data(), page.data(), nullptr};
    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    // Browsers are talkative, and this terminal is not theirs.
    for (const int stream : {STDOUT_FILENO, STDERR_FILENO})
        posix_spawn_file_actions_addopen(&actions, stream, "/dev/null", O_WRONLY, 0);
    pid_t child = 0;
    const int error = posix_spawnp(&child, program.c_str(), &actions, nullptr, arguments, environ);
    posix_spawn_file_actions_destroy(&actions);
    if (error != 0) return false;
    std::thread([child] { waitpid(child, nullptr, 0); }).detach();
    return true;
}

} // namespace keiko::cli
