// How the command explains itself: its help, and what it answers to words that it does not know.
#pragma once

#include "command_line.hpp"

#include <string>
#include <vector>

namespace meniscus {

/// The verbs of the command, in the order of its help.
std::vector<const CLI::App*> verbs_of(const CLI::App& command);
std::vector<std::string> verb_names(const CLI::App& command);

/// Text in lines of at most `width` characters, each but the first after `indent` spaces.
std::string wrapped(const std::string& text, std::size_t indent, std::size_t width);

/// Gives the command and its verbs a help that is wrapped to 100 columns, with types that can be
/// read. To be called before verbs are added, which inherit it.
void set_help_format(CLI::App& command);

/// Adds lines to the end of a verb's help: each a command, and what it does.
void add_examples(CLI::App& verb, const std::vector<std::pair<std::string, std::string>>& examples);

/// What an option takes, in a word or two ("NUMBER", "exact|monte-carlo"); empty for a flag.
std::string type_text(const CLI::Option& option);

/// The words that an option takes, where these are all there are.
std::vector<std::string> choices_of(const CLI::Option& option);

/// One line for an error of parsing: what is wrong, what was perhaps meant, and whose help tells
/// more. `words`: those of the command line, its first one left out.
std::string usage_error(const CLI::App& command, const CLI::ParseError& error,
                        const std::vector<std::string>& words);

/// The help of the verb of that name, or of the whole command where it is empty. Throws InputError,
/// with the nearest one, where there is no such verb.
std::string help_text(const CLI::App& command, const std::string& verb);

/// Adds the verb that prints help_text().
void add_help(CLI::App& command);

} // namespace meniscus
