// XML as far as VTK's files need it: one tag after another with its attributes, and the text
// between them.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>

namespace meniscus::xml {

struct Tag {
    std::string name; ///< with a slash in front where it closes an element
    std::map<std::string, std::string> attributes;
    bool is_whole = false;       ///< "<Piece/>": the element ends with it
    std::string_view text_after; ///< up to the next tag
};

/// Takes the next tag that is no comment and no declaration, and the text behind it, from the front
/// of `rest`; nothing where there is none, or one that makes no sense.
std::optional<Tag> take_tag(std::string_view& rest);

/// The attribute, or an empty text.
std::string attribute(const Tag& tag, const std::string& name);

} // namespace meniscus::xml
