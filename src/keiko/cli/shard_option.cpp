#include "keiko/cli/shard_option.h"

#include "keiko/base/text.h"
#include "keiko/cli/outputs.h"
#include "keiko/cli/session.h"

#include <algorithm>
#include <array>
#include <cstdlib>

namespace keiko::cli {
namespace {

namespace fs = std::filesystem;

/// Options on which no result depends, or that are among other settings of a run over parts.
constexpr std::array<std::string_view, 13> no_settings{
    "--help",           "--threads",       "--quiet",       "--verbose", "--output",
    "--shard",          "--cache",         "--cache-limit", "--unit",    "--axes",
    "--import-timeout", "--import-memory", "MODEL"};

Environment environment() {
    return [](const char* name) -> const char* { return std::getenv(name); };
}

} // namespace

CLI::Option* ShardOption::add_to(CLI::App& command, const std::string& text,
                                 std::initializer_list<const char*> others) {
    CLI::Option* option = command.add_option("--shard", text_, text)->check(not_empty());
    for (const char* other : others) option->excludes(command.get_option(other));
    return option;
}

Shard ShardOption::shard() const {
    return shard_of(text_, environment());
}

Job ShardOption::job(const Job& job) const {
    Job own = job;
    if (own.threads == 0 && text_.starts_with("auto")) own.threads = array_threads(environment());
    return own;
}

PartsOptions parts_options(const CLI::App& command, const ShardOption& shard,
                           std::span<const fs::path> models, const fs::path& output) {
    PartsOptions options{.command = command.get_name(),
                         .models = {models.begin(), models.end()},
                         .output = output,
                         .shard = shard.shard()};
    for (const CLI::Option* option : command.get_options()) {
        const std::string name = option->get_name();
        if (std::find(no_settings.begin(), no_settings.end(), name) != no_settings.end()) continue;
        for (const std::string& value : option->results()) {
            options.settings += name + "=" + value + "\n";
            std::error_code ignored; // of a value that is no path
            if (fs::is_regular_file(value, ignored)) options.files.emplace_back(value);
        }
    }
    return options;
}

int tell_parts(const PartsRun& run, const fs::path& place) {
    TextLines lines;
    for (const PartOutcome& part : run.parts)
        lines.line() << name_of(part.state) << " " << part.name
                     << (part.summary.empty() ? "" : ": ") << part.summary;
    lines.line() << summary_of(run) << "; see " << place.string();
    print(lines.text());
    if (run.state() == PartState::error) return exit_error;
    return run.state() == PartState::pass ? exit_pass : exit_findings;
}

PartState part_state(Verdict verdict) {
    switch (verdict) {
        case Verdict::pass:
            return PartState::pass;
        case Verdict::undecided:
            return PartState::undecided;
        case Verdict::fail:
            break;
    }
    return PartState::fail;
}

} // namespace keiko::cli
