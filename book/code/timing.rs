//! Time and error of one call, as a line of a chart's CSV.

use std::hint::black_box;
use std::time::Instant;

/// Prints a line: the time of one call, the root mean square error of `runs`.
pub fn report(
    method: &str,
    setting: &str,
    exact: f64,
    runs: u64,
    find: &dyn Fn(u64) -> f64,
) {
    let square = |seed| (find(seed) / exact - 1.0).powi(2);
    let error = ((0..runs).map(square).sum::<f64>() / runs as f64).sqrt();
    let milliseconds = milliseconds(&|| black_box(find(0)));
    // An error of nothing has no logarithm: it stands as half a rounding.
    let error = error.max(1e-16);
    println!("{method},{setting},{milliseconds:.3e},{error:.3e},closed form");
}

/// The time of one call: the best of five rounds of at least 10 ms.
pub fn milliseconds(find: &dyn Fn() -> f64) -> f64 {
    let round = |calls: u32| {
        let start = Instant::now();
        (0..calls).for_each(|_| {
            black_box(find());
        });
        1e3 * start.elapsed().as_secs_f64()
    };
    let mut calls = 1;
    while round(calls) < 10.0 {
        calls *= 2;
    }
    (0..5).map(|_| round(calls) / f64::from(calls)).fold(f64::INFINITY, f64::min)
}

/// CPU time of this thread so far, in milliseconds; 0 where the system does not tell (it
/// does on Linux).
pub fn cpu_milliseconds() -> f64 {
    let told =
        std::fs::read_to_string("/proc/thread-self/schedstat").unwrap_or_default();
    let nanoseconds =
        told.split_whitespace().next().and_then(|t| t.parse::<f64>().ok());
    1e-6 * nanoseconds.unwrap_or(0.0)
}

/// CPU time of all threads so far, in milliseconds, as the kernel counts it; 0 where it does
/// not tell (Linux does).
pub fn cpu_milliseconds_of_all() -> f64 {
    let Ok(tasks) = std::fs::read_dir("/proc/self/task") else { return 0.0 };
    let spent = |task: std::io::Result<std::fs::DirEntry>| {
        let file = task.ok()?.path().join("schedstat");
        let text = std::fs::read_to_string(file).ok()?;
        text.split_whitespace().next()?.parse::<f64>().ok()
    };
    1e-6 * tasks.filter_map(spent).sum::<f64>()
}
