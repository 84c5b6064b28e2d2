//! The threads of a campaign: those of one call, which end with it. A process that is forked later has none of
//! them, and needs none.

use std::hint::black_box;
use std::num::NonZero;
use std::thread::available_parallelism;

use rayon::{ThreadPool, ThreadPoolBuilder};

use crate::limits::THREADS;

/// Stack of each thread: that of a main thread.
const STACK: usize = 8 << 20;

/// Memory in bytes that the work needs beside the stacks: for rows and designs, and for the scenario of each thread.
const WORK: usize = 32 << 20;
const SCENARIO: usize = 1 << 20;

/// Address space in bytes that the allocator of glibc takes for each thread, where there is as much.
const ARENA: usize = 64 << 20;

/// The result of `work`, whose scenarios run on all cores: on fewer threads where the system gives fewer, and
/// without another one on this thread alone.
pub fn threaded<T: Send>(work: impl FnOnce() -> T + Send) -> T {
    if rayon::current_thread_index().is_some() {
        return work();
    }
    let mut count = wanted();
    while count > 1 {
        if let Some(pool) = pool_of(count) {
            return pool.install(work);
        }
        count /= 2;
    }
    // From here on this thread is a pool of one.
    let _alone = ThreadPoolBuilder::new().num_threads(1).use_current_thread().build();
    work()
}

/// A pool, where there is memory for all that its threads take and for the work: a thread that starts without memory ends the
/// process. The memory of the work stays set aside while the stacks are taken.
fn pool_of(count: usize) -> Option<ThreadPool> {
    let work = WORK + count * SCENARIO;
    let all = set_aside(work + count * (STACK + ARENA))?;
    drop(all);
    let aside = set_aside(work)?;
    let pool = ThreadPoolBuilder::new().num_threads(count).stack_size(STACK).build().ok();
    drop(aside);
    pool
}

/// Address space of so many bytes; `black_box` keeps the compiler from leaving out what nothing reads.
fn set_aside(bytes: usize) -> Option<Vec<u8>> {
    let mut aside = Vec::new();
    aside.try_reserve_exact(bytes).ok()?;
    Some(black_box(aside))
}

/// One thread a core, unless the user wants another number.
fn wanted() -> usize {
    let given = std::env::var("RAYON_NUM_THREADS").ok();
    let given = given.and_then(|text| text.parse().ok()).filter(|count| *count > 0);
    given.unwrap_or_else(|| available_parallelism().map_or(1, NonZero::get)).min(THREADS.size())
}

#[cfg(test)]
mod tests {
    use super::*;
    use rayon::prelude::*;

    #[test]
    fn work_within_work_takes_the_threads_that_are_there() {
        let both = threaded(|| {
            let outer = rayon::current_num_threads();
            threaded(|| (outer, rayon::current_num_threads(), (0..100u64).into_par_iter().sum()))
        });
        assert_eq!((both.0, both.2), (both.1, 4950u64));
    }
}
