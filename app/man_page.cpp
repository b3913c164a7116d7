// meniscus man: the manual page, written from the command's own definition.
#include "usage.hpp"

#include <meniscus/runtime/version.hpp>

#include <fmt/format.h>
#include <sstream>

namespace meniscus {
namespace {

/// Text as troff takes it: no line begins with a control character, and dashes are those of
/// options.
std::string troff(const std::string& text) {
    std::string plain;
    for (const char c : text) {
        if (c == '\\')
            plain += "\\e";
        else if (c == '-')
            plain += "\\-";
        else if ((c == '.' || c == '\'') && (plain.empty() || plain.back() == '\n'))
            plain += std::string("\\&") + c;
        else
            plain += c;
    }
    return plain;
}

std::string option_entry(const CLI::App& verb, const CLI::Option& option) {
    const bool is_positional = option.get_positional();
    const std::string type = type_text(option);
    const auto& format = dynamic_cast<const CLI::Formatter&>(*verb.get_formatter());
    return fmt::format(".TP\n.B {}{}\n{}\n",
                       troff(is_positional ? option.get_name(true) : option.get_name(false, true)),
                       is_positional || type.empty() ? "" : " \\fI" + troff(type) + "\\fR",
                       troff(format.make_option_desc(&option)));
}

void add_options(const CLI::App& verb, std::string& page) {
    for (const CLI::Option* option : verb.get_options({}))
        if (option != verb.get_help_ptr())
            page += option_entry(verb, *option);
    for (const CLI::App* group :
         verb.get_subcommands([](const CLI::App* one) { return one->get_name().empty(); }))
        add_options(*group, page);
}

std::string verb_section(const CLI::App& verb) {
    std::string page =
        fmt::format(".SS meniscus {}\n{}\n", troff(verb.get_name()), troff(verb.get_description()));
    add_options(verb, page);
    if (!verb.get_footer().empty())
        page += ".PP\n.nf\n" + troff(verb.get_footer()) + "\n.fi\n";
    return page;
}

std::string man_page(const CLI::App& command) {
    std::string page = fmt::format(".TH MENISCUS 1 \"\" \"meniscus {}\" \"User Commands\"\n"
                                   ".SH NAME\nmeniscus \\- find the free surface of SPH fluids\n"
                                   ".SH SYNOPSIS\n.B meniscus\n.I VERB\n[\\fIOPTIONS\\fR]\n"
                                   ".SH DESCRIPTION\n{}\n.SH VERBS\n",
                                   program_version, troff(command.get_description()));
    for (const CLI::App* verb :
         command.get_subcommands([](const CLI::App* one) { return !one->get_name().empty(); }))
        page += verb_section(*verb);
    return page + ".SH EXIT STATUS\n"
                  "0 success, 1 a limit asked for is exceeded, 2 bad input or usage, 3 failure "
                  "while running, 130 interrupted\n";
}

} // namespace

void add_man(CLI::App& command) {
    auto* verb = command.add_subcommand("man", "Print the manual page, in troff");
    add_examples(*verb, {{"meniscus man | man -l -", "reads it"}});
    verb->callback([&command] { print_text(man_page(command)); });
}

} // namespace meniscus
