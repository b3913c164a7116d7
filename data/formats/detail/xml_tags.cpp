#include "xml_tags.hpp"

#include <algorithm>
#include <cstddef>

namespace meniscus::xml {
namespace {

constexpr std::string_view spaces = " \t\r\n";

void skip_spaces(std::string_view& text) {
    text.remove_prefix(std::min(text.find_first_not_of(spaces), text.size()));
}

/// name="value" from the front of a tag's inside; false where there is none.
bool take_attribute(std::string_view& inside, Tag& tag) {
    const std::size_t sign = inside.find('=');
    if (sign == std::string_view::npos)
        return false;
    const std::string_view name = inside.substr(0, inside.find_first_of(" \t\r\n="));
    inside.remove_prefix(sign + 1);
    skip_spaces(inside);
    if (inside.empty() || (inside.front() != '"' && inside.front() != '\''))
        return false;
    const std::size_t end = inside.find(inside.front(), 1);
    if (end == std::string_view::npos)
        return false;
    tag.attributes.emplace(name, inside.substr(1, end - 1));
    inside.remove_prefix(end + 1);
    skip_spaces(inside);
    return true;
}

/// The end of a tag that begins the text; '>' may stand in quotes.
std::size_t end_of_tag(std::string_view text) {
    char quote = 0;
    for (std::size_t i = 0; i < text.size(); ++i) {
        const char c = text[i];
        if (quote != 0)
            quote = c == quote ? static_cast<char>(0) : quote;
        else if (c == '"' || c == '\'')
            quote = c;
        else if (c == '>')
            return i;
    }
    return std::string_view::npos;
}

} // namespace

std::optional<Tag> take_tag(std::string_view& rest) {
    for (;;) {
        rest.remove_prefix(std::min(rest.find('<'), rest.size()));
        const bool is_comment = rest.substr(0, 4) == "<!--";
        const std::size_t end = is_comment ? rest.find("-->") : end_of_tag(rest);
        if (end == std::string_view::npos || rest.empty())
            return std::nullopt;
        std::string_view inside = rest.substr(1, end - 1);
        rest.remove_prefix(end + 1);
        if (is_comment || inside.empty() || inside.front() == '?' || inside.front() == '!')
            continue;
        Tag tag;
        tag.is_whole = inside.back() == '/';
        if (tag.is_whole)
            inside.remove_suffix(1);
        const std::size_t name_end = std::min(inside.find_first_of(spaces), inside.size());
        tag.name = inside.substr(0, name_end);
        inside.remove_prefix(name_end);
        skip_spaces(inside);
        while (!inside.empty())
            if (!take_attribute(inside, tag))
                return std::nullopt;
        tag.text_after = rest.substr(0, rest.find('<'));
        return tag;
    }
}

std::string attribute(const Tag& tag, const std::string& name) {
    const auto found = tag.attributes.find(name);
    return found == tag.attributes.end() ? std::string() : found->second;
}

} // namespace meniscus::xml
