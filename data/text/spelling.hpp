// What a misspelt word was meant to be.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace meniscus {

/// How many edits (a letter put in, left out or replaced, two neighbors exchanged) make one word of
/// the other.
std::size_t edits_between(const std::string& a, const std::string& b);

/// Which of the words, of which there is at least one, takes the fewest edits to make of the
/// misspelt one; the first of several.
const std::string& nearest_spelling(const std::string& misspelt,
                                    const std::vector<std::string>& words);

/// The same, or an empty text where none is near: at most a third of its letters are edited.
std::string likely_spelling(const std::string& misspelt, const std::vector<std::string>& words);

} // namespace meniscus
