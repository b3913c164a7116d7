#include "vtkhdf.hpp"

#include "detail/large_dataset.hpp"
#include "packed_datasets.hpp"

#include <meniscus/data/hdf5/descriptor_driver.hpp>
#include <meniscus/data/hdf5/hdf5_handles.hpp>
#include <meniscus/data/hdf5/hdf5_memory.hpp>
#include <meniscus/data/hdf5/hdf5_turn.hpp>
#include <meniscus/data/hdf5/packed_chunk.hpp>
#include <meniscus/data/text/errors.hpp>
#include <meniscus/data/text/files.hpp>

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <functional>
#include <limits>
#include <map>
#include <memory>
#include <mutex>
#include <new>
#include <optional>
#include <stdexcept>
#include <string>
#include <unistd.h>

namespace meniscus {
namespace {

namespace fs = std::filesystem;

/// The identifier of something that is made in memory, where only memory can be missing.
Handle made(hid_t id, herr_t (*closing)(hid_t)) {
    if (id < 0)
        throw std::bad_alloc();
    return {id, closing};
}

void require(herr_t result) {
    if (result < 0)
        throw std::bad_alloc();
}

/// A property list under which nothing stores its time of creation: the same snapshot gives the
/// same bytes.
Handle timeless(hid_t list_class) {
    Handle list = made(H5Pcreate(list_class), H5Pclose);
    require(H5Pset_obj_track_times(list, false));
    return list;
}

Handle make_group(hid_t parent, const char* name) {
    const Handle creation = timeless(H5P_GROUP_CREATE);
    // All names in the group's header, which has a checksum, however many they are.
    require(H5Pset_link_phase_change(creation, 65535, 65534));
    return made(H5Gcreate2(parent, name, H5P_DEFAULT, creation, H5P_DEFAULT), H5Gclose);
}

/// Who is inside HDF5 gives its turn to others while it makes what it is to write.
using Turn = std::unique_lock<FairLock>;

/// The turn of others, until this ends, be it by an exception.
class OthersTurn {
public:
    explicit OthersTurn(Turn& turn) : turn(turn) { turn.unlock(); }
    OthersTurn(const OthersTurn&) = delete;
    OthersTurn& operator=(const OthersTurn&) = delete;
    ~OthersTurn() { turn.lock(); }

private:
    Turn& turn;
};

/// The other way about, within it.
class OwnTurn {
public:
    explicit OwnTurn(Turn& turn) : turn(turn) { turn.lock(); }
    OwnTurn(const OwnTurn&) = delete;
    OwnTurn& operator=(const OwnTurn&) = delete;
    ~OwnTurn() { turn.unlock(); }

private:
    Turn& turn;
};

/// Chunks that were made before, or nullptr.
using Packed = const PackedDatasets*;

/// A dataset without values yet.
Handle make_dataset(hid_t group, const std::string& name, const Dimensions& dimensions,
                    hid_t stored_type, std::uint64_t rows_of_chunk) {
    const Handle space =
        made(H5Screate_simple(static_cast<int>(dimensions.size()), dimensions.data(), nullptr),
             H5Sclose);
    const Handle creation = timeless(H5P_DATASET_CREATE);
    if (rows_of_chunk > 0) {
        Dimensions chunk = dimensions;
        chunk[0] = rows_of_chunk;
        require(H5Pset_chunk(creation, static_cast<int>(chunk.size()), chunk.data()));
        require(H5Pset_shuffle(creation));
        require(H5Pset_deflate(creation, compression_level));
    }
    return made(
        H5Dcreate2(group, name.c_str(), stored_type, space, H5P_DEFAULT, creation, H5P_DEFAULT),
        H5Dclose);
}

void write_chunks(hid_t dataset, const LargeDataset& source, Packed packed, Turn& turn) {
    const auto write = [&](std::uint64_t chunk, const std::string& bytes) {
        const hsize_t place[] = {chunk * rows_a_chunk(source), 0};
        require(H5Dwrite_chunk(dataset, H5P_DEFAULT, 0, place, bytes.size(), bytes.data()));
    };
    const std::uint64_t chunks = chunk_count(source);
    if (packed != nullptr && packed->has(source.path)) {
        for (std::uint64_t chunk = 0; chunk < chunks; ++chunk)
            write(chunk, packed->chunk(source.path, chunk));
        return;
    }
    const OthersTurn others(turn);
    for_chunks(source, 0, chunks, [&](std::uint64_t chunk, const std::string& bytes) {
        const OwnTurn own(turn);
        write(chunk, bytes);
    });
}

Dimensions dimensions_of(const LargeDataset& dataset) {
    return dataset.components == 1
               ? Dimensions{dataset.rows}
               : Dimensions{dataset.rows, static_cast<hsize_t>(dataset.components)};
}

/// Writes numbers in rows.
void write_dataset(hid_t group, const std::string& name, hid_t type, const LargeDataset& source,
                   Packed packed, Turn& turn) {
    const Handle dataset =
        make_dataset(group, name, dimensions_of(source), type, rows_a_chunk(source));
    if (rows_a_chunk(source) > 0)
        write_chunks(dataset, source, packed, turn);
    else if (source.rows > 0)
        require(
            H5Dwrite(dataset, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, source.fetch(0, source.rows)));
}

/// Numbers in memory, `components` a row.
template <class Number>
LargeDataset in_memory(const Number* numbers, std::uint64_t rows, int components) {
    LargeDataset dataset{{}, rows, components, sizeof(Number), rows, {}};
    const std::uint64_t row = static_cast<std::uint64_t>(components);
    dataset.fetch = [numbers, row](std::uint64_t first, std::uint64_t /*count*/) {
        return numbers + first * row;
    };
    return dataset;
}

template <class Number>
void write_numbers(hid_t group, const std::string& name, const std::vector<Number>& values,
                   Turn& turn) {
    write_dataset(group, name, number_type<Number>(), in_memory(values.data(), values.size(), 1),
                  nullptr, turn);
}

void write_text(hid_t group, const std::string& name, std::string_view text) {
    const Handle type = text_type(text.size(), H5T_CSET_UTF8);
    const std::string padded(text.empty() ? std::string_view("\0", 1) : text);
    const Handle dataset = make_dataset(group, name, {}, type, 0);
    require(H5Dwrite(dataset, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, padded.data()));
}

void write_attribute(hid_t group, const char* name, hid_t space, hid_t type, const void* value) {
    const Handle attribute =
        made(H5Acreate2(group, name, type, space, H5P_DEFAULT, H5P_DEFAULT), H5Aclose);
    require(H5Awrite(attribute, type, value));
}

/// Entries under the names that the file gives them, in their order. HDF5 takes '/' and a lone '.'
/// for paths; what would share a name after that is told apart by underscores.
template <class Entries, class Name>
auto by_stored_name(const Entries& entries, Name name_of) {
    std::map<std::string, const typename Entries::value_type*> stored;
    for (const auto& entry : entries) {
        std::string name = name_of(entry);
        std::replace_if(
            name.begin(), name.end(), [](char c) { return c == '/' || c == '\0'; }, '_');
        if (name.empty() || name == ".")
            name = "_";
        while (stored.count(name) > 0)
            name += '_';
        stored[name] = &entry;
    }
    return stored;
}

/// Numbers that are made as they are written.
template <class Number>
LargeDataset made_numbers(const char* path, std::uint64_t size, Number (*value)(std::uint64_t)) {
    LargeDataset dataset{path, size, 1, sizeof(Number), std::uint64_t{1} << 18, {}};
    dataset.fetch = [value, some = std::vector<Number>()](std::uint64_t first,
                                                          std::uint64_t count) mutable {
        some.resize(count);
        for (std::uint64_t i = 0; i < count; ++i)
            some[i] = value(first + i);
        return static_cast<const void*>(some.data());
    };
    return dataset;
}

/// What the writer takes a snapshot from: one in memory, or one that is fetched.
struct Given {
    const Snapshot& frame;
    std::uint64_t size;
    std::uint64_t at_once;
    /// Positions, and values of array `place`, from `first` on, until the next call.
    std::function<const void*(std::uint64_t first, std::uint64_t count)> positions;
    std::function<const void*(std::size_t place, std::uint64_t first, std::uint64_t count)> values;
};

/// Rounded as HDF5 does: to infinity beyond the range.
float as_float(double number) {
    constexpr double largest = std::numeric_limits<float>::max();
    if (std::abs(number) > largest)
        return number > 0 ? std::numeric_limits<float>::infinity()
                          : -std::numeric_limits<float>::infinity();
    return static_cast<float>(number);
}

LargeDataset points_of(const Given& given) {
    LargeDataset points{"Points", given.size, 3, sizeof(double), given.at_once, given.positions};
    if (given.frame.position_precision == Precision::float64)
        return points;
    points.number_size = sizeof(float);
    points.at_once = std::min(points.at_once, std::uint64_t{1} << 18);
    points.fetch = [fetch = given.positions,
                    some = std::vector<float>()](std::uint64_t first, std::uint64_t count) mutable {
        const auto* positions = static_cast<const double*>(fetch(first, count));
        some.resize(3 * count);
        std::transform(positions, positions + 3 * count, some.begin(), as_float);
        return static_cast<const void*>(some.data());
    };
    return points;
}

/// A dataset of the group VTKHDF, and how it is stored.
struct StoredDataset {
    LargeDataset rows;
    hid_t (*type)();
};

/// Those that grow with the number of particles and belong to no array: positions and cells, one
/// for each particle.
std::vector<StoredDataset> grid_datasets(const Given& given) {
    const auto itself = [](std::uint64_t i) { return static_cast<std::int64_t>(i); };
    const auto vertex = [](std::uint64_t /*i*/) { return vertex_cell; };
    return {
        {points_of(given), given.frame.position_precision == Precision::float32
                               ? number_type<float>
                               : number_type<double>},
        {made_numbers<std::int64_t>("Offsets", given.size + 1, itself), number_type<std::int64_t>},
        {made_numbers<std::int64_t>("Connectivity", given.size, itself), number_type<std::int64_t>},
        {made_numbers<std::uint8_t>("Types", given.size, vertex), number_type<std::uint8_t>}};
}

std::vector<StoredDataset> array_datasets(const Given& given) {
    const auto& all = given.frame.point_data;
    const auto arrays = by_stored_name(all, [](const PointArray& array) { return array.name; });
    std::vector<StoredDataset> datasets;
    for (const auto& [name, array] : arrays)
        std::visit(
            [&, name = name, array = array](const auto& values) {
                using Number = typename std::decay_t<decltype(values)>::value_type;
                const auto place = static_cast<std::size_t>(array - all.data());
                LargeDataset dataset{"PointData/" + name, given.size,    array->components,
                                     sizeof(Number),      given.at_once, {}};
                dataset.fetch = [fetch = given.values, place](std::uint64_t first,
                                                              std::uint64_t count) {
                    return fetch(place, first, count);
                };
                datasets.push_back({std::move(dataset), number_type<Number>});
            },
            array->values);
    return datasets;
}

void write_grid(hid_t group, const Given& given, Packed packed, Turn& turn) {
    for (const StoredDataset& dataset : grid_datasets(given))
        write_dataset(group, dataset.rows.path, dataset.type(), dataset.rows, packed, turn);
    for (const char* name : {"NumberOfPoints", "NumberOfCells", "NumberOfConnectivityIds"})
        write_numbers(group, name, std::vector<std::int64_t>{static_cast<std::int64_t>(given.size)},
                      turn);
}

void write_point_data(hid_t parent, const Given& given, Packed packed, Turn& turn) {
    const Handle group = make_group(parent, "PointData");
    for (const StoredDataset& dataset : array_datasets(given))
        write_dataset(group, dataset.rows.path.substr(std::string("PointData/").size()),
                      dataset.type(), dataset.rows, packed, turn);
}

void write_field_data(hid_t parent, const Snapshot& snapshot, Turn& turn) {
    const Handle group = make_group(parent, "FieldData");
    const std::pair<const char*, std::optional<double>> fields[] = {
        {"support_radius", snapshot.support_radius},
        {"particle_spacing", snapshot.particle_spacing},
        {"particle_volume", snapshot.particle_volume},
        {"time", snapshot.time}};
    for (const auto& [name, value] : fields)
        if (value)
            write_numbers(group, name, std::vector<double>{*value}, turn);
    write_numbers(group, "dimension", std::vector<std::int32_t>{snapshot.dimension}, turn);
}

void write_for_vtk(hid_t file, const Given& given, Packed packed, Turn& turn) {
    const Handle group = make_group(file, "VTKHDF");
    const std::int64_t version[] = {1, 0};
    const hsize_t two = 2;
    write_attribute(group, "Version", made(H5Screate_simple(1, &two, nullptr), H5Sclose),
                    number_type<std::int64_t>(), version);
    write_attribute(group, "Type", made(H5Screate(H5S_SCALAR), H5Sclose),
                    text_type(grid_type.size(), H5T_CSET_ASCII), grid_type.data());
    write_grid(group, given, packed, turn);
    write_point_data(group, given, packed, turn);
    make_group(group, "CellData");
    write_field_data(group, given.frame, turn);
}

void write_for_meniscus(hid_t file, const Snapshot& snapshot, Turn& turn) {
    const Handle group = make_group(file, "meniscus");
    write_text(group, "format_version", format_version);
    if (!snapshot.scene.empty())
        write_text(group, "scene", snapshot.scene);
    if (!snapshot.boundary.empty()) {
        write_dataset(group, "boundary", number_type<double>(),
                      in_memory(snapshot.boundary.data()->data(), snapshot.boundary.size(), 3),
                      nullptr, turn);
    }
    const Handle provenance = make_group(group, "provenance");
    const auto entries =
        by_stored_name(snapshot.provenance, [](const auto& entry) { return entry.first; });
    for (const auto& [name, entry] : entries)
        write_text(provenance, name, entry->second);
}

/// Fills a file with the snapshot. The bytes are those that HDF5 has flushed: closing the file
/// would change them once more.
void fill_file(int descriptor, const Given& given, Packed packed, FileBeingWritten& written) {
    Turn turn(hdf5_turn());
    start_hdf5();
    const QuietErrors quiet;
    const Handle access = made(H5Pcreate(H5P_FILE_ACCESS), H5Pclose);
    // Since 1.8 HDF5 keeps checksums of its own structures, so that damage is noticed.
    require(H5Pset_libver_bounds(access, H5F_LIBVER_V18, H5F_LIBVER_V18));
    const Handle file =
        create_on_descriptor(descriptor, written, timeless(H5P_FILE_CREATE), access);
    if (file < 0)
        throw std::bad_alloc();
    // Nothing reaches the file any more once this is left, be it by an exception.
    const std::unique_ptr<bool, void (*)(bool*)> finish(&written.is_finished,
                                                        [](bool* finished) { *finished = true; });
    write_for_vtk(file, given, packed, turn);
    write_for_meniscus(file, given.frame, turn);
    require(H5Fflush(file, H5F_SCOPE_LOCAL));
}

void write_given(const Given& given, Packed packed, const fs::path& file) {
    write_whole(file, [&](int descriptor) {
        FileBeingWritten written;
        bool has_memory = true;
        try {
            fill_file(descriptor, given, packed, written);
        } catch (const std::bad_alloc&) {
            has_memory = false;
        }
        // HDF5 does not always tell: it writes what it holds back while it closes a dataset.
        if (written.error != 0)
            fail_to_write(file, written.error);
        if (!has_memory)
            throw FailureError(file.string() + ": not enough memory to build the file of " +
                               std::to_string(given.size) + " particles");
        if (ftruncate(descriptor, static_cast<off_t>(written.bytes)) != 0)
            fail_to_write(file, errno);
    });
}

/// The place in memory of an array's values from a row on.
const void* values_at(const PointArray& array, std::uint64_t first) {
    return std::visit(
        [&](const auto& values) -> const void* {
            return values.data() + first * static_cast<std::uint64_t>(array.components);
        },
        array.values);
}

/// What could not be read back is refused before it is written.
void check_consistent(const Snapshot& snapshot) {
    const auto refuse_unless = [](bool fine, const std::string& what) {
        if (!fine)
            throw std::invalid_argument("snapshot to write: " + what);
    };
    for (const PointArray& array : snapshot.point_data) {
        const std::size_t count =
            std::visit([](const auto& values) { return values.size(); }, array.values);
        refuse_unless(array.components > 0 &&
                          count == snapshot.size() * static_cast<std::size_t>(array.components),
                      "point data '" + array.name + "' does not have the particles' length");
    }
    for (const auto& length :
         {snapshot.support_radius, snapshot.particle_spacing, snapshot.particle_volume}) {
        refuse_unless(!length || (std::isfinite(*length) && *length > 0),
                      "support radius, particle spacing and volume must be positive and finite");
    }
    refuse_unless(!snapshot.time || std::isfinite(*snapshot.time), "time must be finite");
    refuse_unless(snapshot.dimension == 2 || snapshot.dimension == 3, "dimension must be 2 or 3");
}

/// Rows of a snapshot that is in memory.
Given given_of(const Snapshot& snapshot) {
    return {snapshot, snapshot.size(), std::uint64_t{1} << 18,
            [&snapshot](std::uint64_t first, std::uint64_t /*count*/) -> const void* {
                return snapshot.positions.data() + first;
            },
            [&snapshot](std::size_t place, std::uint64_t first, std::uint64_t /*count*/) {
                return values_at(snapshot.point_data[place], first);
            }};
}

/// What was fetched last lives as long as what is returned.
Given given_of(const FetchedSnapshot& snapshot) {
    const auto positions = std::make_shared<Positions>();
    const auto some = std::make_shared<PointArray>();
    return {snapshot.frame, snapshot.size, snapshot.rows_at_once,
            [&snapshot, positions](std::uint64_t first, std::uint64_t count) -> const void* {
                *positions = snapshot.positions(first, count);
                return positions->data();
            },
            [&snapshot, some](std::size_t place, std::uint64_t first, std::uint64_t count) {
                some->values = snapshot.values(place, first, count);
                return values_at(*some, 0);
            }};
}

/// The chunks that begin in a rank's share of the rows, from the first up to the second.
std::pair<std::uint64_t, std::uint64_t> own_chunks(const LargeDataset& dataset,
                                                   const Ranks& ranks) {
    const std::uint64_t rows = rows_a_chunk(dataset);
    const auto begin_of = [&](int rank) {
        const std::uint64_t row = first_of_share(dataset.rows, rank, ranks.size());
        return (row + rows - 1) / rows;
    };
    return {begin_of(ranks.rank()), begin_of(ranks.rank() + 1)};
}

} // namespace

void write_vtkhdf(const Snapshot& snapshot, const fs::path& file) {
    check_consistent(snapshot);
    write_given(given_of(snapshot), nullptr, file);
}

void write_vtkhdf(const FetchedSnapshot& snapshot, const fs::path& file) {
    write_given(given_of(snapshot), nullptr, file);
}

PackedDatasets pack_vtkhdf(const FetchedSnapshot& snapshot, const fs::path& scratch, Ranks& ranks) {
    std::optional<PackedDatasets> packed;
    const Given given = given_of(snapshot);
    do_together(ranks, [&] {
        packed.emplace(scratch);
        for (const auto& all : {grid_datasets(given), array_datasets(given)})
            for (const StoredDataset& dataset : all) {
                if (rows_a_chunk(dataset.rows) == 0)
                    continue;
                const auto [first, end] = own_chunks(dataset.rows, ranks);
                for_chunks(dataset.rows, first, end,
                           [&](std::uint64_t chunk, const std::string& bytes) {
                               packed->add(dataset.rows.path, chunk, bytes);
                           });
            }
    });
    packed->gather_on_first(ranks);
    return std::move(*packed);
}

void write_vtkhdf(const FetchedSnapshot& snapshot, const PackedDatasets& packed,
                  const fs::path& file) {
    write_given(given_of(snapshot), &packed, file);
}

} // namespace meniscus
