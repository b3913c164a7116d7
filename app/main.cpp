// The `meniscus` command: a thin layer over the libraries, one file a verb. Every failure is one
// line on standard error and an exit status: 1 a limit asked for is exceeded, 2 bad input or usage,
// 3 failure while running, 130 interrupted.
#include "command_line.hpp"
#include "threads.hpp"
#include "unforeseen_end.hpp"
#include "usage.hpp"

#include <meniscus/app/ranks/ranks_of_program.hpp>
#include <meniscus/data/hdf5/hdf5_memory.hpp>
#include <meniscus/data/text/errors.hpp>
#include <meniscus/runtime/version.hpp>

#include <cstdio>
#include <new>
#include <string>

namespace {

/// Of several ranks only the first says what failed, and how the program ends.
int fail(int status, const std::string& message) {
    if (meniscus::is_other_rank())
        return 0;
    meniscus::print_error_line(message);
    return status;
}

/// Several processes share the files of these verbs.
bool shares_files(const std::string& verb) {
    return verb == "label" || verb == "classify" || verb == "train" || verb == "audit";
}

int run(CLI::App& command, int argument_count, char** arguments) {
    try {
        const std::string verb = argument_count > 1 ? arguments[1] : "";
        if (meniscus::ranks_of_program().size() > 1 && !shares_files(verb))
            return fail(2, verb + " works in one process; start it without mpirun");
        command.parse(argument_count, arguments);
        if (command.get_subcommands().empty())
            return fail(2, "a verb is missing (see meniscus --help)");
        if (std::fflush(stdout) != 0 || std::ferror(stdout) != 0)
            return fail(3, "standard output cannot be written to");
        return 0;
    } catch (const CLI::Success& request) { // --help, --version
        return command.exit(request);
    } catch (const CLI::ParseError& error) {
        return fail(
            2, meniscus::usage_error(command, error, {arguments + 1, arguments + argument_count}));
    } catch (const meniscus::LimitExceeded& error) {
        return fail(1, error.what());
    } catch (const meniscus::InputError& error) {
        return fail(2, error.what());
    } catch (const std::bad_alloc&) {
        return fail(3, "out of memory");
    } catch (const std::exception& error) {
        return fail(3, error.what());
    }
}

} // namespace

int main(int argument_count, char** arguments) {
    const meniscus::UnforeseenEnd end;
    try {
        meniscus::open_standard_streams();
        meniscus::leave_hdf5_as_it_is();
        meniscus::wait_asleep(arguments);
        meniscus::install_interrupt_handler();
        const std::string warning = meniscus::limit_threads();
        if (!warning.empty())
            meniscus::print_error_line(warning);
        CLI::App command(
            "Finds the free surface of SPH fluids: simulate scenes, label snapshots, train "
            "a line, export it, audit it.",
            "meniscus");
        command.set_version_flag("-V,--version",
                                 std::string("meniscus ") + meniscus::program_version);
        // run() notices that there is none; the parser names a wrong one.
        command.require_subcommand(0, 1);
        meniscus::set_help_format(command);
        meniscus::add_simulate(command);
        meniscus::add_label(command);
        meniscus::add_train(command);
        meniscus::add_calibrate(command);
        meniscus::add_export(command);
        meniscus::add_audit(command);
        meniscus::add_classify(command);
        meniscus::add_demo(command);
        meniscus::add_picture(command);
        meniscus::add_plot(command);
        meniscus::add_inspect(command);
        meniscus::add_models(command);
        meniscus::add_man(command);
        meniscus::add_completion(command);
        meniscus::add_help(command);
#if MENISCUS_HAS_BENCH
        meniscus::add_bench(command);
        meniscus::add_study(command);
#endif
        for (CLI::App* verb : command.get_subcommands({}))
            verb->group("Verbs");
        const int status = run(command, argument_count, arguments);
        meniscus::end_ranks();
        return status;
    } catch (const std::exception& error) { // what run() itself cannot report
        std::fprintf(stderr, "meniscus: %s\n", error.what());
        return 3;
    }
}
