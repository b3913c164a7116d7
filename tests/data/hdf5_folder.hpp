// A folder with an HDF5 file in it that tests change as another program or a slip would.
#pragma once

#include "test_folder.hpp"

#include <meniscus/data/formats/snapshot_files.hpp>
#include <meniscus/data/text/errors.hpp>

#include <hdf5.h>

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace meniscus {

class Hdf5Folder : public TestFolder {
protected:
    explicit Hdf5Folder(const char* name) : file(folder / name) {}

    std::string reading_error() const {
        return error_of<InputError>([&] { read_snapshot(file); });
    }

    /// Changes the file with HDF5 itself, as another program or a slip would.
    void edit(const std::function<void(hid_t)>& change) const {
        const hid_t opened = H5Fopen(file.c_str(), H5F_ACC_RDWR, H5P_DEFAULT);
        ASSERT_GE(opened, 0);
        change(opened);
        ASSERT_GE(H5Fclose(opened), 0);
    }

    /// Puts a dataset of the given numbers in place of what has that path, if anything has.
    template <class Number>
    void replace(const char* path, hid_t type, std::vector<hsize_t> dimensions,
                 std::vector<Number> values) const {
        edit([&](hid_t opened) {
            if (H5Lexists(opened, path, H5P_DEFAULT) > 0)
                H5Ldelete(opened, path, H5P_DEFAULT);
            const hid_t space =
                H5Screate_simple(static_cast<int>(dimensions.size()), dimensions.data(), nullptr);
            const hid_t dataset =
                H5Dcreate2(opened, path, type, space, H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT);
            ASSERT_GE(dataset, 0);
            if (!values.empty())
                H5Dwrite(dataset, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data());
            H5Dclose(dataset);
            H5Sclose(space);
        });
    }

    void remove(const char* path) const {
        edit([&](hid_t opened) { H5Ldelete(opened, path, H5P_DEFAULT); });
    }

    const std::filesystem::path file;
};

} // namespace meniscus
