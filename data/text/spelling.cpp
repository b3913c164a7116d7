#include "spelling.hpp"

#include <algorithm>

namespace meniscus {

// Damerau's and Levenshtein's distance, in which no letter is edited twice.
std::size_t edits_between(const std::string& a, const std::string& b) {
    std::vector<std::vector<std::size_t>> edits(a.size() + 1,
                                                std::vector<std::size_t>(b.size() + 1));
    for (std::size_t i = 0; i <= a.size(); ++i)
        for (std::size_t j = 0; j <= b.size(); ++j) {
            if (i == 0 || j == 0) {
                edits[i][j] = i + j;
                continue;
            }
            edits[i][j] = std::min({edits[i - 1][j] + 1, edits[i][j - 1] + 1,
                                    edits[i - 1][j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1)});
            if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1])
                edits[i][j] = std::min(edits[i][j], edits[i - 2][j - 2] + 1);
        }
    return edits[a.size()][b.size()];
}

const std::string& nearest_spelling(const std::string& misspelt,
                                    const std::vector<std::string>& words) {
    const std::string start = misspelt.substr(0, 100); // longer ones resemble nothing
    return *std::min_element(words.begin(), words.end(), [&](const auto& a, const auto& b) {
        return edits_between(start, a) < edits_between(start, b);
    });
}

std::string likely_spelling(const std::string& misspelt, const std::vector<std::string>& words) {
    if (words.empty() || misspelt.size() > 100)
        return {};
    const std::string& nearest = nearest_spelling(misspelt, words);
    const std::size_t letters = std::max(misspelt.size(), nearest.size());
    return 3 * edits_between(misspelt, nearest) <= letters ? nearest : std::string();
}

} // namespace meniscus
