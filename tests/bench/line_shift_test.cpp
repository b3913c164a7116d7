// The line's constant d: more of it finds more and misses less.
#include "table_rows.hpp"
#include "training/line_shift.hpp"

#include <meniscus/data/text/errors.hpp>

namespace meniscus {
namespace {

LineShiftOptions small_options() {
    LineShiftOptions options;
    options.double_droplet = MENISCUS_SAMPLES "/droplet_iisph_06.vtkhdf";
    options.published_model = MENISCUS_MODELS "/splishsplash_d12.json";
    options.paraboloid_width = 7;
    options.d = {0, 13, 28, 40};
    options.timing = {1, no_time};
    return options;
}

const Table& small_table() {
    static const Table table = line_shift(small_options());
    return table;
}

const char* const states[] = {"hyperbolic paraboloid", "double droplet"};
const char* const lines[] = {"published slope", "own slope"};

std::vector<double> figures(const std::string& state, const std::string& line,
                            const std::string& key) {
    std::vector<double> found;
    for (const auto& row : rows_with(small_table(), {{"state", state}, {"line", line}}))
        found.push_back(figure_in(small_table(), row, key));
    return found;
}

TEST(LineShift, HasTheConstantsAskedForAndEachLinesOwn) {
    expect_whole(small_table());
    for (const char* const state : states)
        for (const char* const line : lines)
            EXPECT_EQ(figures(state, line, "d").size(), 5U);
    EXPECT_EQ(figures("double droplet", "published slope", "d")[1], 12);
}

TEST(LineShift, FindsMoreAndMissesLess) {
    for (const char* const state : states)
        for (const char* const line : lines) {
            SCOPED_TRACE(std::string(state) + ", " + line);
            const auto rises = [&](const char* key) {
                const auto values = figures(state, line, key);
                EXPECT_TRUE(std::is_sorted(values.begin(), values.end())) << key;
                return values.back() - values.front();
            };
            const auto falls = [&](const char* key) {
                const auto values = figures(state, line, key);
                EXPECT_TRUE(std::is_sorted(values.rbegin(), values.rend())) << key;
                EXPECT_EQ(values.back(), 0) << key;
            };
            EXPECT_GT(rises("d"), 0);
            EXPECT_GT(rises("candidates"), 0);
            EXPECT_GT(rises("false_positives"), 0);
            falls("false_negatives");
            falls("false_negatives_plain");
            falls("missed_area");
        }
}

TEST(LineShift, CountsEachParticleOnce) {
    for (const char* const state : states)
        for (const char* const line : lines) {
            const auto candidates = figures(state, line, "candidates");
            const auto missed = figures(state, line, "false_negatives");
            const auto wrong = figures(state, line, "false_positives");
            for (std::size_t row = 0; row < candidates.size(); ++row) // surface particles
                EXPECT_EQ(candidates[row] + missed[row] - wrong[row],
                          candidates[0] + missed[0] - wrong[0]);
        }
}

TEST(LineShift, MissesTheNeckOfTheDropletAtThePapersThirteen) {
    EXPECT_GT(figures("double droplet", "published slope", "false_negatives")[2], 0);
    EXPECT_EQ(figures("double droplet", "published slope", "false_negatives")[3], 0);
    EXPECT_GT(figures("double droplet", "published slope", "missed_area")[0], 50);
}

TEST(LineShift, RefusesALineInTwoDimensions) {
    LineShiftOptions options = small_options();
    options.published_model = MENISCUS_MODELS "/surface_2d.json";
    EXPECT_THROW(line_shift(options), InputError);
}

} // namespace
} // namespace meniscus
