#include "usage.hpp"

#include <meniscus/data/text/errors.hpp>
#include <meniscus/data/text/spelling.hpp>
#include <meniscus/data/text/text.hpp>

#include <algorithm>
#include <fmt/format.h>
#include <memory>
#include <sstream>

namespace meniscus {
namespace {

constexpr std::size_t columns = 100;
constexpr std::size_t left_column = 30; ///< of names and types

std::string plain_type(const std::string& type) {
    if (type == "FLOAT")
        return "NUMBER";
    return type == "INT" || type == "UINT" ? "COUNT" : type;
}

/// A row of two columns; a left one that is too long has a line of its own.
std::string row(const std::string& left, const std::string& right) {
    const std::string start = "  " + left;
    const bool fits = start.size() + 1 < left_column;
    return (fits ? fmt::format("{:<{}}", start, left_column)
                 : start + '\n' + std::string(left_column, ' ')) +
           wrapped(right, left_column, columns) + '\n';
}

std::vector<std::string> names_of(const std::vector<CLI::Option*>& options) {
    std::vector<std::string> names;
    for (const CLI::Option* option : options)
        names.push_back(option->get_name(false, true));
    return names;
}

std::string joined(const std::vector<std::string>& words, const char* between) {
    std::string text;
    for (const std::string& word : words)
        text += (text.empty() ? "" : between) + word;
    return text;
}

class HelpFormat : public CLI::Formatter {
public:
    std::string make_option(const CLI::Option* option, bool is_positional) const override {
        const std::string type = type_text(*option);
        std::string left = make_option_name(option, is_positional);
        if (!is_positional && !type.empty())
            left += " " + type;
        if (option->get_expected_max() == CLI::detail::expected_max_vector_size)
            left += "...";
        return row(left, make_option_desc(option));
    }

    std::string make_option_desc(const CLI::Option* option) const override {
        std::string text = option->get_description();
        const std::string usual = option->get_default_str();
        if (!usual.empty())
            text += fmt::format(" (default: {})", usual);
        if (option->get_required() && !option->get_positional())
            text += " (required)";
        if (!option->get_needs().empty())
            text += fmt::format(" (with {})", other_names(option->get_needs()));
        if (!option->get_excludes().empty())
            text += fmt::format(" (not with {})", other_names(option->get_excludes()));
        return text;
    }

    std::string make_subcommand(const CLI::App* verb) const override {
        return row(verb->get_name(), verb->get_description());
    }

    /// Of a group of options.
    std::string make_expanded(const CLI::App* group) const override {
        std::string text = '\n' + group->get_group() + ":\n";
        for (const CLI::Option* option : group->get_options({}))
            if (option != group->get_help_ptr()) // which is that of the verb
                text += make_option(option, false);
        return text;
    }

    std::string make_description(const CLI::App* app) const override {
        return wrapped(app->get_description(), 0, columns) + "\n\n";
    }

private:
    static std::string other_names(const std::set<CLI::Option*>& options) {
        std::vector<std::string> names = names_of({options.begin(), options.end()});
        std::sort(names.begin(), names.end());
        return joined(names, ", ");
    }
};

const CLI::App* verb_named(const CLI::App& command, const std::string& name) {
    for (const CLI::App* verb : verbs_of(command))
        if (verb->get_name() == name)
            return verb;
    return nullptr;
}

/// Options of a verb, its groups included, with their dashes.
std::vector<std::string> option_names(const CLI::App& verb) {
    std::vector<std::string> names;
    for (const CLI::Option* option : verb.get_options({}))
        for (const std::string& name : option->get_lnames())
            names.push_back("--" + name);
    for (const CLI::App* group :
         verb.get_subcommands([](const CLI::App* one) { return one->get_name().empty(); }))
        for (const std::string& name : option_names(*group))
            names.push_back(name);
    return names;
}

/// The first of the words that is an option of no name that the verb has.
std::string unknown_option(const std::vector<std::string>& words,
                           const std::vector<std::string>& known) {
    for (const std::string& word : words) {
        const std::string name = word.substr(0, word.find('='));
        if (name.rfind("--", 0) == 0 && name.size() > 2 &&
            std::find(known.begin(), known.end(), name) == known.end())
            return name;
    }
    return {};
}

} // namespace

std::vector<const CLI::App*> verbs_of(const CLI::App& command) {
    return command.get_subcommands([](const CLI::App* verb) { return !verb->get_name().empty(); });
}

std::vector<std::string> verb_names(const CLI::App& command) {
    std::vector<std::string> names;
    for (const CLI::App* verb : verbs_of(command))
        names.push_back(verb->get_name());
    return names;
}

std::string wrapped(const std::string& text, std::size_t indent, std::size_t width) {
    std::istringstream words(text);
    std::string lines;
    std::size_t column = indent;
    for (std::string word; words >> word;) {
        if (column > indent && column + 1 + word.size() > width) {
            lines += '\n' + std::string(indent, ' ');
            column = indent;
        }
        if (column > indent) {
            lines += ' ';
            ++column;
        }
        lines += word;
        column += word.size();
    }
    return lines;
}

void set_help_format(CLI::App& command) {
    command.formatter(std::make_shared<HelpFormat>());
    command.get_formatter()->label("Positionals", "Arguments");
    command.get_formatter()->label("SUBCOMMAND", "VERB");
}

void add_examples(CLI::App& verb,
                  const std::vector<std::pair<std::string, std::string>>& examples) {
    std::string text = "Examples:";
    for (const auto& [line, meaning] : examples)
        text += fmt::format("\n  {}\n      {}", line, wrapped(meaning, 6, columns));
    verb.footer(text);
}

std::vector<std::string> choices_of(const CLI::Option& option) {
    const std::string type = option.get_type_name();
    const std::size_t begin = type.find(":{");
    if (begin == std::string::npos || type.back() != '}')
        return {};
    std::vector<std::string> choices;
    std::istringstream words(type.substr(begin + 2, type.size() - begin - 3));
    for (std::string word; std::getline(words, word, ',');)
        choices.push_back(word);
    return choices;
}

std::string type_text(const CLI::Option& option) {
    if (option.get_items_expected_max() == 0 || option.get_type_size() == 0)
        return {};
    if (const auto choices = choices_of(option); !choices.empty())
        return joined(choices, "|");
    const std::string type = option.get_type_name();
    return plain_type(type.substr(0, type.find(':')));
}

std::string usage_error(const CLI::App& command, const CLI::ParseError& error,
                        const std::vector<std::string>& words) {
    const CLI::App* verb = nullptr;
    for (const std::string& word : words)
        if (verb == nullptr)
            verb = verb_named(command, word);
    std::string text = error.what();
    text = text.substr(0, text.find('\n'));
    std::string meant;
    if (dynamic_cast<const CLI::ExtrasError*>(&error) != nullptr) {
        if (verb != nullptr) {
            const auto known = option_names(*verb);
            const std::string wrong = unknown_option(words, known);
            if (!wrong.empty())
                text = fmt::format("{} has no option {}", verb->get_name(), quoted_text(wrong));
            meant = wrong.empty() ? "" : likely_spelling(wrong, known);
        } else if (!words.empty() && words[0].rfind('-', 0) != 0) {
            text = fmt::format("there is no verb {}", quoted_text(words[0]));
            meant = likely_spelling(words[0], verb_names(command));
        }
    }
    return fmt::format("{}{} (see meniscus{}{} --help)", text,
                       meant.empty() ? "" : fmt::format("; did you mean '{}'?", meant),
                       verb == nullptr ? "" : " ", verb == nullptr ? "" : verb->get_name());
}

std::string help_text(const CLI::App& command, const std::string& verb) {
    const CLI::App* meant = verb.empty() ? &command : verb_named(command, verb);
    if (meant == nullptr) {
        const std::string nearest = likely_spelling(verb, verb_names(command));
        throw InputError(
            fmt::format("there is no verb {}{} (see meniscus --help)", quoted_text(verb),
                        nearest.empty() ? "" : fmt::format("; did you mean '{}'?", nearest)));
    }
    return command.get_formatter()->make_help(
        meant, verb.empty() ? command.get_name() : command.get_name() + " " + verb,
        CLI::AppFormatMode::Normal);
}

void add_help(CLI::App& command) {
    auto name = std::make_shared<std::string>();
    auto* verb = command.add_subcommand("help", "Print the help of a verb, or this one");
    verb->add_option("VERB", *name, "Verb to explain");
    verb->callback([&command, name] { print_text(help_text(command, *name)); });
}

} // namespace meniscus
