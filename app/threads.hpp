// What is settled about threads before any work: how they wait, how many there may be, and that the
// machine starts them. OpenMP itself settles none of it in a way that a user can live with.
#pragma once

#include <string>

namespace meniscus {

/// Has threads that wait for others sleep, unless the environment says how they are to wait
/// (OMP_WAIT_POLICY, GOMP_SPINCOUNT): on shared cores those that spin take the cores from those
/// that are waited for, and two threads take twenty times as long. libgomp looks at that once, when
/// it is loaded, so the program runs itself once more. `arguments`: those of main().
void wait_asleep(char** arguments);

/// Lowers what OMP_NUM_THREADS says to what --threads may, since far more crash in libgomp. Returns
/// a warning, or nothing.
std::string limit_threads();

/// Throws FailureError where so many threads, 0 for all, cannot be started: libgomp would end the
/// process with a status of its own.
void check_threads_start(int threads);

} // namespace meniscus
