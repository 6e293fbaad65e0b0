// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <omp.h>

namespace anvil {

/// Threads the next parallel loop will use.
inline int thread_count() { return omp_get_max_threads(); }
inline void set_thread_count(int threads) { omp_set_num_threads(threads); }

/// Calls work(item, thread) for each item 0 .. count-1, spread over the threads; `thread` numbers the one that works,
/// to pick its scratch memory. The work must not throw and must write only to what belongs to its item: then the result
/// has the same bits for any number of threads. Whatever is summed over items is kept per item and added in order
/// afterwards. Fewer items than `least_shared` are all done by the calling thread: waking others costs some
/// microseconds.
template <class Work>
void for_each_parallel(int count, Work&& work, int least_shared = 2) {
  if (count < least_shared || omp_get_max_threads() == 1) {
    for (int item = 0; item < count; ++item) work(item, 0);
    return;
  }
#pragma omp parallel
  {
    const int thread = omp_get_thread_num();
#pragma omp for schedule(static)
    for (int item = 0; item < count; ++item) work(item, thread);
  }
}

}  // namespace anvil
