// The estimators of coverage on small clouds: errors fall as they should, in the order known.
#include "coverage/coverage_estimators.hpp"
#include "table_rows.hpp"

#include <meniscus/data/text/errors.hpp>

namespace meniscus {
namespace {

const Table& small_table() {
    static const Table table = [] {
        EstimatorOptions options;
        options.samples = {30, 300, 20000}; // the last is more than any table of directions holds
        options.snapshots = {MENISCUS_SAMPLES "/droplet_iisph_06.vtkhdf",
                             MENISCUS_SAMPLES "/dam_dfsph_08.vtkhdf"};
        options.particles_per_snapshot = 40;
        options.ball_radius = 2.5;
        options.disc_radius = 5;
        options.saddle_width = 7;
        options.threads = 1;
        options.timing = {1, no_time};
        return coverage_estimators(options);
    }();
    return table;
}

const char* const cases[] = {"snapshots", "ball", "saddle", "disc"};
const char* const samplers[] = {
    "random, drawn each time", "random table", "blue noise", "Halton 2-3", "outward",
    "outward, verified"};

double error_of(const std::string& name, const std::string& estimator, std::size_t row,
                const std::string& key) {
    const auto rows = rows_with(small_table(), {{"case", name}, {"estimator", estimator}});
    return figure_in(small_table(), rows.at(row), key);
}

TEST(CoverageEstimators, FillTheWholeTable) {
    expect_whole(small_table());
    for (const char* const name : cases) {
        const bool is_cloud = name != std::string("snapshots");
        EXPECT_EQ(rows_with(small_table(), {{"case", name}}).size(), is_cloud ? 21U : 19U);
    }
}

TEST(CoverageEstimators, ErrWithSamplesLess) {
    for (const char* const name : cases)
        for (const char* const estimator : samplers) {
            SCOPED_TRACE(std::string(name) + ", " + estimator);
            EXPECT_LT(error_of(name, estimator, 1, "lambda"),
                      error_of(name, estimator, 0, "lambda") / 1.5);
            EXPECT_LT(error_of(name, estimator, 2, "lambda"),
                      error_of(name, estimator, 1, "lambda") / 1.5);
            EXPECT_LE(error_of(name, estimator, 2, "lost"), error_of(name, estimator, 0, "lost"));
            if (name == std::string("snapshots"))
                continue;
            for (const char* const key : {"raw_normal", "normal"})
                EXPECT_LT(error_of(name, estimator, 1, key), error_of(name, estimator, 0, key));
        }
}

TEST(CoverageEstimators, ErrNotWhereCoverageIsExact) {
    for (const char* const name : cases) {
        EXPECT_EQ(error_of(name, "exact coverage", 0, "lambda"), 0);
        EXPECT_EQ(error_of(name, "exact coverage", 0, "lost"), 0);
    }
    EXPECT_LT(error_of("ball", "exact coverage", 0, "normal"), 4);
    EXPECT_LT(error_of("ball", "exact coverage", 0, "curvature"), 0.05);
}

TEST(CoverageEstimators, AreEachBetterThanTheOneBefore) {
    for (const char* const name : cases)
        for (const std::size_t row : {0, 1}) {
            SCOPED_TRACE(name);
            const double halton = error_of(name, "Halton 2-3", row, "lambda");
            EXPECT_LT(halton, error_of(name, "random table", row, "lambda"));
            EXPECT_LT(halton, error_of(name, "random, drawn each time", row, "lambda"));
            EXPECT_LT(error_of(name, "outward", row, "lambda"), halton);
        }
}

TEST(CoverageEstimators, LoseNothingWhereVerified) {
    for (const char* const name : cases)
        for (const std::size_t row : {0, 1, 2})
            EXPECT_EQ(error_of(name, "outward, verified", row, "lost"), 0);
    EXPECT_GT(error_of("ball", "random table", 0, "lost"), 0);
}

TEST(CoverageEstimators, KnowTheColorField) {
    for (const char* const name : {"ball", "saddle", "disc"}) {
        SCOPED_TRACE(name);
        for (const char* const field : {"color field, Laplacian", "color field, divergence"}) {
            EXPECT_LT(error_of(name, field, 0, "normal"), 15);
            EXPECT_GT(error_of(name, field, 0, "normal"),
                      error_of(name, "exact coverage", 0, "normal"));
        }
        EXPECT_LT(error_of(name, "color field, divergence", 0, "curvature"),
                  error_of(name, "color field, Laplacian", 0, "curvature"));
    }
}

TEST(CoverageEstimators, KnowNoNormalsOfSnapshots) {
    for (const auto& row : rows_with(small_table(), {{"case", "snapshots"}}))
        for (const char* const key : {"raw_normal", "normal", "curvature"})
            EXPECT_TRUE(is_empty_in(small_table(), row, key));
}

} // namespace
} // namespace meniscus
