//! `cargo bench --bench flatten`: quarter arcs to chords, beside kurbo and lyon_geom. It prints the table that
//! `docs/performance.md` explains.

#[allow(dead_code)]
#[path = "../tape/measure.rs"]
mod measure;

use measure::{Contestant, TIMES_HEAD, TIMES_RULE, compete, grouped, shown};
use nctape::flatten::flatten_span;
use nctape::format::Plane;
use nctape::span::{Arc, Geometry, Span, SpanKind};
use std::f64::consts::{FRAC_PI_2, TAU};
use std::hint::black_box;
use std::time::Duration;

const ARCS: usize = 100_000;
const TOLERANCE: f64 = 0.01;

/// A quarter arc as all three are given it.
struct Quarter {
    centre: [f64; 2],
    radius: f64,
    start_angle: f64,
}

fn main() {
    // `cargo bench -- edit` asks for a part of the other bench.
    if std::env::args().skip(1).any(|argument| !argument.starts_with("--")) {
        return;
    }
    let quarters = quarters();
    let spans: Vec<Span> = quarters.iter().map(span).collect();
    let kurbo_arcs: Vec<kurbo::Arc> = quarters.iter().map(to_kurbo).collect();
    let lyon_arcs: Vec<lyon_geom::Arc<f64>> = quarters.iter().map(to_lyon).collect();

    let mut buffer = Vec::new();
    let mut contestants: [Contestant<'_>; 4] = [
        (
            "nctape: each point to a closure",
            Box::new(|| {
                let mut sum = Sum::default();
                for span in black_box(&spans) {
                    flatten_span(span, TOLERANCE, &mut |[x, y, z]| sum.add(x, y + z));
                }
                black_box(sum);
            }),
        ),
        (
            "nctape: into a buffer that is used again",
            Box::new(|| {
                for span in black_box(&spans) {
                    buffer.clear();
                    flatten_span(span, TOLERANCE, &mut |point| buffer.push(point));
                    black_box(&buffer);
                }
            }),
        ),
        (
            KURBO,
            Box::new(|| {
                let mut sum = Sum::default();
                for arc in black_box(&kurbo_arcs) {
                    by_kurbo(arc, &mut |x, y| sum.add(x, y));
                }
                black_box(sum);
            }),
        ),
        (
            LYON,
            Box::new(|| {
                let mut sum = Sum::default();
                for arc in black_box(&lyon_arcs) {
                    by_lyon(arc, &mut |x, y| sum.add(x, y));
                }
                black_box(sum);
            }),
        ),
    ];
    let times = compete(&mut contestants, Duration::from_secs(20));
    let names = contestants.map(|(name, _)| name);

    let points = |flatten: &ByIndex<'_>| worth(&quarters, flatten);
    let worths = [
        points(&|index, give| flatten_span(&spans[index], TOLERANCE, &mut |[x, y, _]| give(x, y))),
        points(&|index, give| flatten_span(&spans[index], TOLERANCE, &mut |[x, y, _]| give(x, y))),
        points(&|index, give| by_kurbo(&kurbo_arcs[index], &mut |x, y| give(x, y))),
        points(&|index, give| by_lyon(&lyon_arcs[index], &mut |x, y| give(x, y))),
    ];
    println!("\n{} quarter arcs of radius 1 to 100 at a tolerance of {TOLERANCE}.\n", grouped(ARCS));
    println!("| what | {TIMES_HEAD} | an arc | chords an arc | furthest off | beside nctape |");
    println!("| --- | {TIMES_RULE} | --: | --: | --: | --: |");
    let own = times[0].median().as_secs_f64();
    for ((name, times), (chords, off)) in names.iter().zip(&times).zip(worths) {
        let median = times.median();
        println!(
            "| {name} | {times} | {} | {chords:.1} | {off:.5} | {:.1} |",
            shown(median / ARCS as u32),
            median.as_secs_f64() / own
        );
    }
}

const KURBO: &str = "kurbo 0.13.1: Arc, append_iter, flatten";
const LYON: &str = "lyon_geom 1.0.20: Arc, for_each_flattened";

/// What is done with each point: enough that none is left out.
#[derive(Default)]
struct Sum(f64, f64);

impl Sum {
    fn add(&mut self, x: f64, y: f64) {
        self.0 += x;
        self.1 += y;
    }
}

fn by_kurbo(arc: &kurbo::Arc, give: &mut impl FnMut(f64, f64)) {
    let start = kurbo::PathEl::MoveTo(arc.center + kurbo::Vec2::from_angle(arc.start_angle) * arc.radii.x);
    let path = std::iter::once(start).chain(arc.append_iter(TOLERANCE));
    kurbo::flatten(path, TOLERANCE, |element| match element {
        kurbo::PathEl::MoveTo(point) | kurbo::PathEl::LineTo(point) => give(point.x, point.y),
        _ => {}
    });
}

fn by_lyon(arc: &lyon_geom::Arc<f64>, give: &mut impl FnMut(f64, f64)) {
    let from = arc.from();
    give(from.x, from.y);
    arc.for_each_flattened(TOLERANCE, &mut |line: &lyon_geom::LineSegment<f64>| give(line.to.x, line.to.y));
}

/// Radii from 1 to 100 and angles all round, the same in every run: the golden ratio and √2, modulo 1.
fn quarters() -> Vec<Quarter> {
    let part = |index: usize, step: f64| (index as f64 * step).fract();
    let quarter = |index: usize| Quarter {
        centre: [part(index, 0.754_877_666_246_692_8) * 500.0, part(index, 0.569_840_290_998_053_3) * 500.0],
        radius: 1.0 + 99.0 * part(index, 0.618_033_988_749_894_9),
        start_angle: TAU * part(index, 0.414_213_562_373_095),
    };
    (0..ARCS).map(quarter).collect()
}

fn span(quarter: &Quarter) -> Span {
    let &Quarter { centre, radius, start_angle } = quarter;
    let at = |angle: f64| {
        let (sine, cosine) = libm::sincos(angle);
        [centre[0] + radius * cosine, centre[1] + radius * sine, 0.0]
    };
    let arc = Arc { plane: Plane::Xy, centre, start_radius: radius, end_radius: radius, start_angle, sweep: FRAC_PI_2 };
    Span {
        kind: SpanKind::Arc,
        blocks: (0, 0),
        geometry: Geometry::Arc(arc),
        start: at(start_angle),
        end: at(start_angle + FRAC_PI_2),
        angular: false,
        length: radius * FRAC_PI_2,
        feed: None,
        seconds: None,
        substitute: false,
    }
}

fn to_kurbo(quarter: &Quarter) -> kurbo::Arc {
    let radii = (quarter.radius, quarter.radius);
    kurbo::Arc::new((quarter.centre[0], quarter.centre[1]), radii, quarter.start_angle, FRAC_PI_2, 0.0)
}

fn to_lyon(quarter: &Quarter) -> lyon_geom::Arc<f64> {
    lyon_geom::Arc {
        center: lyon_geom::point(quarter.centre[0], quarter.centre[1]),
        radii: lyon_geom::vector(quarter.radius, quarter.radius),
        start_angle: lyon_geom::Angle::radians(quarter.start_angle),
        sweep_angle: lyon_geom::Angle::radians(FRAC_PI_2),
        x_rotation: lyon_geom::Angle::zero(),
    }
}

/// Gives the points of an arc by its place in the list.
type ByIndex<'a> = dyn Fn(usize, &mut dyn FnMut(f64, f64)) + 'a;

/// Chords an arc, and how far the furthest place of a chord is from its circle.
fn worth(quarters: &[Quarter], flatten: &ByIndex<'_>) -> (f64, f64) {
    let (mut chords, mut furthest) = (0_usize, 0.0_f64);
    for (index, quarter) in quarters.iter().enumerate().step_by(100) {
        let mut before: Option<[f64; 2]> = None;
        flatten(index, &mut |x, y| {
            let off =
                |[x, y]: [f64; 2]| (libm::hypot(x - quarter.centre[0], y - quarter.centre[1]) - quarter.radius).abs();
            if let Some([x0, y0]) = before {
                chords += 1;
                furthest = furthest.max(off([(x + x0) / 2.0, (y + y0) / 2.0])).max(off([x, y]));
            }
            before = Some([x, y]);
        });
    }
    (chords as f64 / (quarters.len() / 100) as f64, furthest)
}
