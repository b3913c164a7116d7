// What reading and writing VTKHDF files share: HDF5 identifiers that close themselves, HDF5's
// types, and the names of the format. For the sources of data/ only.
#pragma once

#include <hdf5.h>

#include <algorithm>
#include <cstdint>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

namespace meniscus {

inline constexpr std::string_view format_version = "1";
inline constexpr std::string_view grid_type = "UnstructuredGrid";
inline constexpr std::uint8_t vertex_cell = 1;
inline constexpr std::uint8_t poly_vertex_cell = 2;

using Dimensions = std::vector<hsize_t>;

/// An HDF5 identifier that closes itself. Negative where HDF5 failed.
class Handle {
public:
    Handle(hid_t made, herr_t (*closing)(hid_t)) : id(made), close(closing) {}
    Handle(Handle&& other) noexcept : id(std::exchange(other.id, -1)), close(other.close) {}
    Handle(const Handle&) = delete;
    Handle& operator=(const Handle&) = delete;
    Handle& operator=(Handle&&) = delete;
    ~Handle() {
        if (id >= 0)
            close(id);
    }

    // Used wherever HDF5 wants an identifier.
    operator hid_t() const { return id; }

private:
    hid_t id;
    herr_t (*close)(hid_t);
};

/// What HDF5 calls for each error: keeps in mind whether memory was wanting (hdf5_memory.hpp).
herr_t note_want_of_memory(hid_t stack, void* nothing);

/// HDF5 prints its errors to the terminal unless told not to; ours say it in one line.
class QuietErrors {
public:
    QuietErrors() {
        H5Eget_auto2(H5E_DEFAULT, &function, &data);
        H5Eset_auto2(H5E_DEFAULT, note_want_of_memory, nullptr);
    }
    QuietErrors(const QuietErrors&) = delete;
    QuietErrors& operator=(const QuietErrors&) = delete;
    ~QuietErrors() { H5Eset_auto2(H5E_DEFAULT, function, data); }

private:
    H5E_auto2_t function = nullptr;
    void* data = nullptr;
};

/// The HDF5 type of a C++ number. Files are little endian, as is every machine we build for.
template <class Number>
hid_t number_type() {
    if constexpr (std::is_floating_point_v<Number>)
        return sizeof(Number) == 4 ? H5T_IEEE_F32LE : H5T_IEEE_F64LE;
    else if constexpr (sizeof(Number) == 1)
        return std::is_signed_v<Number> ? H5T_STD_I8LE : H5T_STD_U8LE;
    else if constexpr (sizeof(Number) == 2)
        return std::is_signed_v<Number> ? H5T_STD_I16LE : H5T_STD_U16LE;
    else if constexpr (sizeof(Number) == 4)
        return std::is_signed_v<Number> ? H5T_STD_I32LE : H5T_STD_U32LE;
    else
        return std::is_signed_v<Number> ? H5T_STD_I64LE : H5T_STD_U64LE;
}

inline Handle text_type(std::size_t size, H5T_cset_t characters) {
    Handle type(H5Tcopy(H5T_C_S1), H5Tclose);
    H5Tset_size(type, std::max<std::size_t>(size, 1));
    H5Tset_strpad(type, H5T_STR_NULLPAD);
    H5Tset_cset(type, characters);
    return type;
}

} // namespace meniscus
