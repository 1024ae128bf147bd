//! Measures side by side: what is to be compared takes turns, so that whatever else the machine does falls on all alike.

use std::fmt;
use std::time::{Duration, Instant};

/// Something to be measured, by name.
pub type Contestant<'a> = (&'a str, Box<dyn FnMut() + 'a>);

/// What was measured of one contestant.
pub struct Times {
    sorted: Vec<Duration>,
}

impl Times {
    /// From measurements in any order; at least one.
    pub fn new(mut times: Vec<Duration>) -> Times {
        times.sort();
        Times { sorted: times }
    }

    /// Half of them were shorter.
    pub fn median(&self) -> Duration {
        self.sorted[self.sorted.len() / 2]
    }
}

/// `min | median | max | rounds`, as cells of a table.
impl fmt::Display for Times {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let (min, max) = (self.sorted[0], self.sorted[self.sorted.len() - 1]);
        write!(f, "{} | {} | {} | {}", shown(min), shown(self.median()), shown(max), self.sorted.len())
    }
}

/// The head of a table of [`Times`].
pub const TIMES_HEAD: &str = "min | median | max | rounds";
/// The line below it.
pub const TIMES_RULE: &str = "--: | --: | --: | --:";

/// Lets the contestants take turns until the time is up; five rounds at least, and one before that for warmth.
pub fn compete(contestants: &mut [Contestant<'_>], budget: Duration) -> Vec<Times> {
    contestants.iter_mut().for_each(|(_, run)| run());
    let mut times = vec![Vec::new(); contestants.len()];
    let start = Instant::now();
    while times[0].len() < 5 || (start.elapsed() < budget && times[0].len() < 500) {
        for ((_, run), times) in contestants.iter_mut().zip(&mut times) {
            times.push(once(run));
        }
    }
    times.into_iter().map(Times::new).collect()
}

/// How long it takes this time.
pub fn once(run: impl FnOnce()) -> Duration {
    let start = Instant::now();
    run();
    start.elapsed()
}

/// The median of a few runs, fewer of those that take long.
pub fn median(mut run: impl FnMut()) -> Duration {
    let first = once(&mut run);
    let more = if first > Duration::from_secs(1) { 0 } else { 6 };
    Times::new((0..more).map(|_| once(&mut run)).chain((more == 0).then_some(first)).collect()).median()
}

/// A time with three figures.
pub fn shown(time: Duration) -> String {
    let micros = time.as_secs_f64() * 1e6;
    let (value, unit) = match micros {
        ..1000.0 => (micros, "µs"),
        ..1e6 => (micros / 1e3, "ms"),
        _ => (micros / 1e6, "s"),
    };
    let places = if value < 10.0 {
        2
    } else if value < 100.0 {
        1
    } else {
        0
    };
    format!("{value:.places$} {unit}")
}

/// 100000 as 100 000.
pub fn grouped(count: usize) -> String {
    let digits = count.to_string();
    let groups: Vec<&str> =
        digits.as_bytes().rchunks(3).rev().filter_map(|group| std::str::from_utf8(group).ok()).collect();
    groups.join(" ")
}
