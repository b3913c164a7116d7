// The record of a run: a text file beside its frames that lists the files which the run has written
// and no others, each with its size and SHA-256. It tells a frame that is the run's own from a file
// that somebody gave the same kind of name, and a whole frame from a damaged one. Who has it open
// holds a lock, so that no second run of that name works in the folder; a lock ends with its
// process.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace meniscus {

/// A file of the run, in the folder of the record.
struct RecordedFile {
    std::string name;
    std::uintmax_t bytes = 0;
    std::string hash; ///< SHA-256, or `unsettled` or `lost`; no blanks
};

/// In place of a hash: the file changes as the run goes on, or was being written when it ended.
inline constexpr const char* unsettled = "-";
/// In place of a hash: the run went on although the file was missing or damaged.
inline constexpr const char* lost = "lost";

class RunRecord {
public:
    /// Opens the record, empty where there is none yet, and locks it for as long as this lives.
    /// Throws FailureError where another run holds it, InputError where it cannot be opened or is
    /// no record.
    explicit RunRecord(std::filesystem::path its_file);
    RunRecord(const RunRecord&) = delete;
    RunRecord& operator=(const RunRecord&) = delete;
    /// Removes what is still empty.
    ~RunRecord();

    [[nodiscard]] const std::vector<RecordedFile>& files() const { return recorded; }

    /// nullptr where it is not listed.
    [[nodiscard]] const RecordedFile* find(const std::string& name) const;

    /// Lists a file or, where it is listed, changes what is said of it; on disk when it returns.
    /// Throws FailureError where the record cannot be written.
    void set(const RecordedFile& file);

    /// Lists nothing any more.
    void clear();

private:
    std::filesystem::path file;
    int descriptor;
    std::vector<RecordedFile> recorded;

    void write();
};

/// What is wrong with a file that a run wrote, as in "has 5 bytes, was written with 8"; empty where
/// it is as it was written, or was lost before.
std::string damage_of(const std::filesystem::path& file, const RecordedFile* recorded);

/// Whether a file under a listed name is whole and yet not what the run wrote: somebody put his own
/// in its place.
bool is_replaced(const std::filesystem::path& file, const RecordedFile& recorded);

} // namespace meniscus
