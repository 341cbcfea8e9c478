#include "keiko/api/accept.h"

#include "keiko/base/error.h"
#include "keiko/base/output_file.h"
#include "keiko/base/text.h"
#include "keiko/cli/inspection_options.h"
#include "keiko/cli/outputs.h"
#include "keiko/cli/session.h"

#include <CLI/Validators.hpp>

#include <memory>

namespace keiko::cli {
namespace {

struct AcceptArguments {
    std::filesystem::path report, output;
    AcceptedNumbers numbers;
    AcceptanceNote note;
    DateOption today;
};

AcceptanceNote note_of(const AcceptArguments& arguments, const std::string& today) {
    AcceptanceNote note = arguments.note;
    note.when = today;
    if (note.who.empty()) note.who = login_name();
    return note;
}

void print_added(const AddedAcceptances& all, const std::filesystem::path& file) {
    TextLines lines;
    for (const Acceptance& entry : all.added)
        lines.line() << "accepted " << name_of(entry) << ": " << text_of(entry.note);
    for (const Acceptance& entry : all.replaced)
        lines.line() << "in place of " << name_of(entry) << ": " << text_of(entry.note);
    lines.line() << counted(all.entries.size(), "finding") << " accepted in " << file.string();
    print(lines.text());
}

int accept(const AcceptArguments& arguments) {
    if (arguments.numbers.items.empty() && arguments.numbers.findings.empty())
        throw Error("", "ITEM", "is missing: name a fault, or a --finding");
    const std::filesystem::path& file = arguments.output;
    require_distinct({&file, 1}, {&arguments.report, 1});
    require_place_for_file(file);
    const std::string today = arguments.today.date();
    const AcceptanceNote note = note_of(arguments, today);
    const AddedAcceptances all = accept_items(earlier_acceptances(file, today), file,
                                              arguments.report, arguments.numbers, note);
    write_text_file(file, acceptances_json(all.entries));
    print_added(all, file);
    return exit_pass;
}

} // namespace

void add_accept(CLI::App& app, Session& session) {
    auto arguments = std::make_shared<AcceptArguments>();
    CLI::App& command = *app.add_subcommand(
        "accept", "accept findings of a report, so that they have no part in later verdicts");
    command
        .add_option("REPORT", arguments->report,
                    "report.json of keiko inspect, or a file of keiko check --json")
        ->required();
    command
        .add_option("ITEM", arguments->numbers.items,
                    "numbers of faults, as report.html and report.json have them, with all of "
                    "their findings; of findings for a file of keiko check")
        ->check(CLI::PositiveNumber);
    command
        .add_option("--finding", arguments->numbers.findings,
                    "numbers of single findings, as the report lists them")
        ->check(CLI::PositiveNumber);
    command.add_option("--why", arguments->note.why, "reason")->required()->check(not_empty());
    command.add_option("--who", arguments->note.who, "who accepts [your login name]")
        ->check(not_empty());
    command
        .add_option("--until", arguments->note.until,
                    "last day on which it holds, as 2026-11-27 [no end]")
        ->check(not_empty());
    arguments->today.add_to(command);
    command
        .add_option("-o,--output", arguments->output,
                    "file of accepted findings (keiko-accepted/1) to add them to; made if missing")
        ->required();
    command.footer(
        "Exit codes: 0 accepted, 2 error.\n"
        "Example: keiko accept out/report.json 1 3 --why \"hidden by the trim\" --until "
        "2027-06-30 -o fender.accepted.json");
    session.add_command(command, [arguments](const Job&) { return accept(*arguments); });
}

} // namespace keiko::cli
