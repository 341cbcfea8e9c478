#pragma once

#include <filesystem>
#include <string>

namespace keiko::cli {

/// Page that leads a browser to an address: a file of the user alone, for as long as this lives.
/// The address thus stands in no list of processes.
class AddressPage {
public:
    /// Writes the file into the user's folder of the session, or the system's for such files.
    /// Throws Error if that takes none.
    explicit AddressPage(const std::string& address);
    ~AddressPage();
    AddressPage(const AddressPage&) = delete;
    AddressPage& operator=(const AddressPage&) = delete;

    /// Shows the page in the user's browser, by xdg-open. False without such a program.
    bool show() const;

private:
    std::filesystem::path file_;
};

} // namespace keiko::cli
