// What the tests of files share: a folder that is empty at the start of each test and gone at its
// end, and files made of given bytes.
#pragma once

#include "expected_errors.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <string_view>
#include <unistd.h>

namespace meniscus {

class TestFolder : public ::testing::Test {
protected:
    void SetUp() override { std::filesystem::create_directories(folder); }
    void TearDown() override { std::filesystem::remove_all(folder); }

    std::filesystem::path write(const std::string& name, std::string_view bytes) const {
        std::ofstream(folder / name, std::ios::binary) << bytes;
        return folder / name;
    }

    static std::string bytes_of(const std::filesystem::path& file) {
        std::ifstream stream(file, std::ios::binary);
        return {std::istreambuf_iterator<char>(stream), {}};
    }

    // Tests run at the same time, each in a process of its own.
    const std::filesystem::path folder =
        std::filesystem::temp_directory_path() / ("meniscus_test_" + std::to_string(getpid()));
};

} // namespace meniscus
