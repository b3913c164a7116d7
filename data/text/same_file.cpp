#include "same_file.hpp"

#include "errors.hpp"

namespace meniscus {

namespace fs = std::filesystem;

bool is_same_file(const fs::path& one, const fs::path& other) {
    if (one.empty() || other.empty())
        return false;
    std::error_code error;
    const bool is_same = fs::equivalent(one, other, error);
    if (!error) // one of them is there at least
        return is_same;
    const fs::path first = fs::weakly_canonical(fs::absolute(one), error);
    if (error)
        return false; // cannot be looked at, and so not written either
    const fs::path second = fs::weakly_canonical(fs::absolute(other), error);
    return !error && first == second;
}

void check_is_not_an_input(const fs::path& output, const std::vector<fs::path>& inputs) {
    for (const fs::path& input : inputs)
        if (is_same_file(output, input))
            throw InputError("output " + output.string() + " would overwrite the input " +
                             (output == input ? "of that name" : input.string()) +
                             "; choose another name with -o");
}

} // namespace meniscus
