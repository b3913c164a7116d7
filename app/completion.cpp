// meniscus completion: what a shell completes, written from the command's own definition.
#include "usage.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <memory>

namespace meniscus {
namespace {

struct CompletedOption {
    std::vector<std::string> names; ///< with their dashes
    std::vector<std::string> words; ///< that it takes, where these are all there are
    bool takes_value = false;
    std::string meaning;
};

/// All options of a verb, those of its groups too.
void add_options(const CLI::App& verb, std::vector<CompletedOption>& options) {
    const bool is_group = verb.get_name().empty();
    for (const CLI::Option* option : verb.get_options({})) {
        if (is_group && option == verb.get_help_ptr()) // which is that of the verb
            continue;
        CompletedOption one;
        for (const std::string& name : option->get_snames())
            one.names.push_back("-" + name);
        for (const std::string& name : option->get_lnames())
            one.names.push_back("--" + name);
        one.words = choices_of(*option);
        one.takes_value = !type_text(*option).empty();
        one.meaning = option->get_description();
        if (!one.names.empty())
            options.push_back(one);
    }
    for (const CLI::App* group :
         verb.get_subcommands([](const CLI::App* one) { return one->get_name().empty(); }))
        add_options(*group, options);
}

template <class Words>
std::string joined(const Words& words, const char* between = " ") {
    std::string text;
    for (const std::string& word : words)
        text += (text.empty() ? "" : between) + word;
    return text;
}

std::string bash_case(const CLI::App& verb) {
    std::vector<CompletedOption> options;
    add_options(verb, options);
    std::string names;
    std::string values;
    for (const CompletedOption& option : options) {
        names += (names.empty() ? "" : " ") + joined(option.names);
        if (!option.words.empty())
            values += fmt::format("            {}) words='{}' ;;\n", joined(option.names, "|"),
                                  joined(option.words));
    }
    return fmt::format("        {})\n            options='{}'\n            case $before in\n{}"
                       "            esac ;;\n",
                       verb.get_name(), names, values);
}

std::string bash_completion(const CLI::App& command) {
    std::string cases;
    for (const CLI::App* verb : verbs_of(command))
        cases += bash_case(*verb);
    return fmt::format(R"(# Completion of meniscus in bash; written by `meniscus completion bash`.
_meniscus() {{
    local word=${{COMP_WORDS[COMP_CWORD]}} before=${{COMP_WORDS[COMP_CWORD-1]}}
    local verbs='{0}' options='' words=''
    if [ "$COMP_CWORD" -eq 1 ]; then
        COMPREPLY=($(compgen -W "$verbs --help --version" -- "$word"))
        return
    fi
    case ${{COMP_WORDS[1]}} in
        help) words=$verbs ;;
{1}    esac
    if [ -n "$words" ]; then
        COMPREPLY=($(compgen -W "$words" -- "$word"))
    elif [ "${{word:0:1}}" = - ]; then
        COMPREPLY=($(compgen -W "$options" -- "$word"))
    else
        COMPREPLY=($(compgen -f -- "$word"))
    fi
}}
complete -o filenames -F _meniscus meniscus
)",
                       joined(verb_names(command)), cases);
}

/// A text between single quotes of zsh's _arguments, in which brackets and colons have a meaning.
std::string zsh_text(const std::string& text) {
    std::string plain;
    for (const char c : text) {
        if (c == '[' || c == ']' || c == ':')
            plain += '\\';
        plain += c == '\'' ? std::string("'\\''") : std::string(1, c);
    }
    return plain;
}

std::string zsh_case(const CLI::App& verb) {
    std::vector<CompletedOption> options;
    add_options(verb, options);
    std::string lines;
    for (const CompletedOption& option : options) {
        std::string value;
        if (!option.words.empty())
            value = ":value:(" + joined(option.words) + ")";
        else if (option.takes_value)
            value = ":value:_files";
        for (const std::string& name : option.names)
            lines += fmt::format(" \\\n                '{}[{}]{}'", name, zsh_text(option.meaning),
                                 value);
    }
    return fmt::format(
        "        {})\n            _arguments{} \\\n                '*:file:_files' ;;\n",
        verb.get_name(), lines);
}

std::string zsh_completion(const CLI::App& command) {
    std::string verbs;
    std::string cases;
    for (const CLI::App* verb : verbs_of(command)) {
        verbs +=
            fmt::format("        '{}:{}'\n", verb->get_name(), zsh_text(verb->get_description()));
        if (verb->get_name() != "help")
            cases += zsh_case(*verb);
    }
    return fmt::format(R"(#compdef meniscus
# Completion of meniscus in zsh; written by `meniscus completion zsh`.
_meniscus() {{
    local -a verbs=(
{0}    )
    if (( CURRENT == 2 )); then
        _describe verb verbs
        return
    fi
    local verb=$words[2]
    shift words
    (( CURRENT-- ))
    case $verb in
        help) _describe verb verbs ;;
{1}    esac
}}
_meniscus "$@"
)",
                       verbs, cases);
}

} // namespace

void add_completion(CLI::App& command) {
    auto shell = std::make_shared<std::string>();
    auto* verb =
        command.add_subcommand("completion", "Print what a shell needs to complete the command");
    verb->add_option("SHELL", *shell, "bash or zsh")
        ->required()
        ->check(CLI::IsMember({"bash", "zsh"}));
    add_examples(*verb, {{"source <(meniscus completion bash)", "completion in this shell"}});
    verb->callback([&command, shell] {
        print_text(*shell == "bash" ? bash_completion(command) : zsh_completion(command));
    });
}

} // namespace meniscus
