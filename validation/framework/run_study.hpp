// Runs a study: those of its runs that are missing, and keeps what each has measured.
#pragma once

#include "study.hpp"

#include <string>
#include <vector>

namespace meniscus {

struct StudyOptions {
    std::filesystem::path work; ///< folder of the runs; exists
    std::string size;           ///< "small" or "paper"
    int threads = 0;            ///< 0: all cores
    bool keep_frames = false;   ///< else what a run wrote is removed once it is measured
    std::function<bool()> stop = [] { return false; };
    /// Called before each run that is not there yet, with its number from 1 on.
    std::function<void(const StudyRun&, std::size_t number, std::size_t all)> on_run;
    /// Draws a frame as a picture (work/RUN.png); nothing is drawn without it.
    std::function<void(const std::filesystem::path& frame, const std::filesystem::path& picture,
                       const std::string& title)>
        draw;
};

/// Where the picture of a run lies, if one was drawn.
std::filesystem::path picture_file(const StudyRun& run, const std::filesystem::path& work);

/// The result. A run that the work folder holds, made from the same settings by the same version of
/// the program, is taken as it is. Throws Stopped, InputError and FailureError.
Json run_study(const Study& study, const StudyPlan& plan, const StudyOptions& options);

/// Where two results of a plan differ by more than it allows, each in a line; empty where they
/// agree. Figures that one lacks, and failures, count as differences.
std::vector<std::string> differences(const Json& result, const Json& committed,
                                     const StudyPlan& plan);

} // namespace meniscus
