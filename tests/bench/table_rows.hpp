// Looking things up in the tables of a comparison.
#pragma once

#include "support/table.hpp"

#include <functional>
#include <gtest/gtest.h>

namespace meniscus {

/// The text or the figure of a row.
inline const std::string& text_in(const Table& table, const std::vector<Cell>& row,
                                  const std::string& key) {
    return std::get<std::string>(row[table.column(key)]);
}
inline double figure_in(const Table& table, const std::vector<Cell>& row, const std::string& key) {
    return std::get<double>(row[table.column(key)]);
}
inline bool is_empty_in(const Table& table, const std::vector<Cell>& row, const std::string& key) {
    return std::holds_alternative<std::monostate>(row[table.column(key)]);
}

/// The rows with these texts, in their order.
using Texts = std::vector<std::pair<std::string, std::string>>;
inline std::vector<std::vector<Cell>> rows_with(const Table& table, const Texts& texts) {
    std::vector<std::vector<Cell>> found;
    for (const auto& row : table.rows) {
        bool has_all = true;
        for (const auto& [key, text] : texts)
            has_all = has_all && text_in(table, row, key) == text;
        if (has_all)
            found.push_back(row);
    }
    return found;
}

/// Each row is as long as the table is wide, and has its times.
inline void expect_whole(const Table& table) {
    ASSERT_FALSE(table.rows.empty());
    for (const auto& row : table.rows) {
        ASSERT_EQ(row.size(), table.columns.size());
        EXPECT_TRUE(std::holds_alternative<RepeatedTime>(row[table.column("time")]));
        EXPECT_TRUE(std::holds_alternative<RepeatedTime>(row[table.column("time_parallel")]));
    }
}

/// As short as it can be: tests ask for no time.
inline constexpr double no_time = 1e-6;

} // namespace meniscus
