// HDF5 files that want values of other files to be read for theirs: external storage, virtual
// datasets and links. Whoever sends such a file would get what its reader may see.
#include "hdf5_folder.hpp"

#include <meniscus/data/formats/vtkhdf.hpp>

#include <sys/stat.h>

namespace meniscus {
namespace {

constexpr const char* secret = "/VTKHDF/PointData/secret";

class OtherFiles : public Hdf5Folder {
protected:
    OtherFiles() : Hdf5Folder("state.hdf5") {}

    void SetUp() override {
        Hdf5Folder::SetUp();
        Snapshot snapshot;
        snapshot.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
        set_array(snapshot, {"secret", 1, std::vector<double>{1, 2, 3, 4}});
        write_vtkhdf(snapshot, other);
        write_vtkhdf(snapshot, file);
        remove(secret);
    }

    /// A dataset of four numbers in place of the array, as `set` changes its creation.
    void make_dataset(const std::function<void(hid_t creation)>& set) const {
        edit([&](hid_t opened) {
            const hsize_t count = 4;
            const hid_t space = H5Screate_simple(1, &count, nullptr);
            const hid_t creation = H5Pcreate(H5P_DATASET_CREATE);
            set(creation);
            const hid_t dataset = H5Dcreate2(opened, secret, H5T_IEEE_F64LE, space, H5P_DEFAULT,
                                             creation, H5P_DEFAULT);
            EXPECT_GE(dataset, 0);
            H5Dclose(dataset);
            H5Pclose(creation);
            H5Sclose(space);
        });
    }

    const std::filesystem::path other = folder / "other.hdf5";
};

TEST_F(OtherFiles, ExternalStorageIsRefused) {
    for (const char* name : {"other.hdf5", "/etc/passwd", "/proc/self/environ"}) {
        make_dataset([&](hid_t creation) { H5Pset_external(creation, name, 0, 32); });
        expect_mentions(reading_error(), {"state.hdf5", secret, "another file", "h5repack"});
        remove(secret);
    }
}

TEST_F(OtherFiles, ExternalStorageInAPipeIsNotWaitedFor) {
    const std::filesystem::path pipe = folder / "pipe";
    ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
    make_dataset([&](hid_t creation) { H5Pset_external(creation, pipe.c_str(), 0, 32); });
    expect_mentions(reading_error(), {"state.hdf5", secret, "another file"});
}

TEST_F(OtherFiles, VirtualDatasetsAreRefused) {
    make_dataset([&](hid_t creation) {
        const hsize_t count = 4;
        const hid_t space = H5Screate_simple(1, &count, nullptr);
        H5Pset_virtual(creation, space, other.c_str(), secret, space);
        H5Sclose(space);
    });
    expect_mentions(reading_error(), {"state.hdf5", secret, "another file"});
}

TEST_F(OtherFiles, LinksThatLeadOutAreRefused) {
    edit([&](hid_t opened) {
        H5Lcreate_external(other.c_str(), secret, opened, secret, H5P_DEFAULT, H5P_DEFAULT);
    });
    expect_mentions(reading_error(), {"state.hdf5", secret, "link to another file"});
}

TEST_F(OtherFiles, GroupsBehindLinksThatLeadOutAreRefused) {
    remove("/VTKHDF/PointData");
    edit([&](hid_t opened) {
        H5Lcreate_external(other.c_str(), "/VTKHDF/PointData", opened, "/VTKHDF/PointData",
                           H5P_DEFAULT, H5P_DEFAULT);
    });
    expect_mentions(reading_error(), {"state.hdf5", "/VTKHDF/PointData", "link to another file"});
}

TEST_F(OtherFiles, LinksInsideThatLeadOutInTheEndAreRefused) {
    edit([&](hid_t opened) {
        H5Lcreate_external(other.c_str(), secret, opened, "/outside", H5P_DEFAULT, H5P_DEFAULT);
        H5Lcreate_soft("/outside", opened, secret, H5P_DEFAULT, H5P_DEFAULT);
    });
    expect_mentions(reading_error(), {"state.hdf5", secret, "damaged"});
}

TEST_F(OtherFiles, LinksInsideAreFollowed) {
    edit([&](hid_t opened) {
        H5Lcreate_soft("/VTKHDF/Points", opened, secret, H5P_DEFAULT, H5P_DEFAULT);
    });
    const Snapshot snapshot = read_snapshot(file);
    ASSERT_NE(find_array(snapshot, "secret"), nullptr);
    EXPECT_EQ(find_array(snapshot, "secret")->components, 3);
}

/// GADGET's, H5Part's and PySPH's, whose readers share the way in.
TEST_F(OtherFiles, AreRefusedInEveryFormat) {
    const auto link_in = [&](const char* group, const char* name) {
        const hid_t made = H5Fcreate(file.c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, H5P_DEFAULT);
        const hid_t creation = H5Pcreate(H5P_LINK_CREATE);
        H5Pset_create_intermediate_group(creation, 1);
        H5Lcreate_external(other.c_str(), "/VTKHDF/Points", made,
                           (std::string(group) + "/" + name).c_str(), creation, H5P_DEFAULT);
        H5Lcreate_hard(made, "/", made, "/solver_data", creation, H5P_DEFAULT);
        H5Pclose(creation);
        H5Fclose(made);
        return reading_error();
    };
    expect_mentions(link_in("/PartType0", "Coordinates"), {"Coordinates", "another file"});
    expect_mentions(link_in("/Step#0", "x"), {"Step#0/x", "another file"});
    expect_mentions(link_in("/particles/fluid/arrays", "x"), {"arrays/x", "another file"});
}

TEST_F(OtherFiles, ManyArraysAreRefusedAtOnce) {
    edit([&](hid_t opened) {
        const hid_t space = H5Screate(H5S_SCALAR);
        const hid_t first = H5Dcreate2(opened, "/VTKHDF/PointData/0", H5T_IEEE_F64LE, space,
                                       H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT);
        for (int i = 1; i < 1001; ++i)
            H5Lcreate_hard(opened, "/VTKHDF/PointData/0", opened,
                           ("/VTKHDF/PointData/" + std::to_string(i)).c_str(), H5P_DEFAULT,
                           H5P_DEFAULT);
        H5Dclose(first);
        H5Sclose(space);
    });
    expect_mentions(reading_error(), {"state.hdf5", "at most 1000 arrays", "1001"});
}

TEST_F(OtherFiles, CountsAreWholeNumbers) {
    replace<double>("/VTKHDF/NumberOfPoints", H5T_IEEE_F64LE, {1}, {4.5});
    expect_mentions(reading_error(), {"state.hdf5", "NumberOfPoints", "whole numbers"});
}

} // namespace
} // namespace meniscus
