//! Corners: how two pieces of an offset meet.

use super::FaultKind;
use super::piece::{Course, Piece};

/// What lies between two pieces.
#[derive(Clone, Copy, Debug)]
pub(super) enum Joint {
    /// Nothing: the one ends where the other begins.
    Direct,
    /// An arc about the corner: from this angle of the offset, by this turn.
    Around { corner: [f64; 2], from: f64, turn: f64 },
    /// They do not meet.
    Fault(FaultKind),
}

/// Joins a piece with the one behind it; at an inside corner both are cut where they meet.
pub(super) fn join(before: &mut Piece, this: &mut Piece, left: f64, step: f64) -> Joint {
    let (a, b) = (before.tangents[1], this.tangents[0]);
    let (cross, dot) = (a[0] * b[1] - a[1] * b[0], a[0] * b[0] + a[1] * b[1]);
    let turn = libm::atan2(cross, dot);
    // The directions are off by the rounding of the points over the lengths that say them.
    let slack = crate::execute::circle::tolerance(step) * (1.0 / before.reach + 1.0 / this.reach);
    if turn.abs() <= slack {
        return Joint::Direct;
    }
    let inside = (turn > 0.0) == (left > 0.0) && turn.abs() < std::f64::consts::PI - slack;
    if !inside {
        // The offset stands a quarter turn to the left of the motion, in the direction of `left`'s sign.
        let from = libm::atan2(a[0], -a[1]);
        // A path that turns back on itself goes round on the outer side.
        let back = turn.abs() >= std::f64::consts::PI - slack;
        let turn = if back { -left.signum() * std::f64::consts::PI } else { turn };
        return Joint::Around { corner: before.end, from, turn };
    }
    if matches!(before.course, Course::Points(_)) || matches!(this.course, Course::Points(_)) {
        return Joint::Fault(FaultKind::NotWorkedOut);
    }
    const TRACE: f64 = 1e-9;
    let on = |share: f64| (-TRACE..=1.0 + TRACE).contains(&share);
    let shares = |point: [f64; 2]| (before.share_of(point), this.share_of(point));
    let met = meetings(&before.course, &this.course).into_iter().flatten().map(shares);
    // Of two, the one that comes last on the piece before: nearest to the corner.
    let met = met
        .filter(|(end, start)| on(*end) && on(*start))
        .reduce(|one, other| if other.0 > one.0 { other } else { one });
    match met {
        Some((end, start)) => {
            before.leave = end.min(1.0);
            this.enter = start.max(0.0);
            Joint::Direct
        }
        None => Joint::Fault(FaultKind::InsideCorner),
    }
}

/// A course as a whole line or circle: a point and a direction, or a centre and a radius.
enum Whole {
    Line([f64; 2], [f64; 2]),
    Circle([f64; 2], f64),
}

fn whole(course: &Course, end: usize) -> Option<Whole> {
    match course {
        Course::Line { from, to } => {
            super::piece::unit([to[0] - from[0], to[1] - from[1]]).map(|way| Whole::Line(*from, way))
        }
        Course::Arc { centre, radii, .. } => Some(Whole::Circle(*centre, radii[end])),
        Course::Points(_) => None,
    }
}

/// Where the lines or circles of two courses meet.
fn meetings(before: &Course, this: &Course) -> [Option<[f64; 2]>; 2] {
    match (whole(before, 1), whole(this, 0)) {
        (Some(Whole::Line(p, a)), Some(Whole::Line(q, b))) => {
            let cross = a[0] * b[1] - a[1] * b[0];
            let along = ((q[0] - p[0]) * b[1] - (q[1] - p[1]) * b[0]) / cross;
            [along.is_finite().then(|| [p[0] + along * a[0], p[1] + along * a[1]]), None]
        }
        (Some(Whole::Line(p, a)), Some(Whole::Circle(centre, radius)))
        | (Some(Whole::Circle(centre, radius)), Some(Whole::Line(p, a))) => {
            let to = [centre[0] - p[0], centre[1] - p[1]];
            let along = to[0] * a[0] + to[1] * a[1];
            let aside = to[0] * a[1] - to[1] * a[0];
            let half = radius * radius - aside * aside;
            let at = |along: f64| [p[0] + along * a[0], p[1] + along * a[1]];
            let half = (half >= 0.0).then(|| half.sqrt());
            [half.map(|half| at(along - half)), half.map(|half| at(along + half))]
        }
        (Some(Whole::Circle(c, r)), Some(Whole::Circle(d, s))) => {
            let way = [d[0] - c[0], d[1] - c[1]];
            let square = way[0] * way[0] + way[1] * way[1];
            // The chord of both circles stands at this share of the way from one centre to the other.
            let along = (square + r * r - s * s) / (2.0 * square);
            let half = r * r / square - along * along;
            let half = (square > 0.0 && half >= 0.0).then(|| half.sqrt());
            let at = |side: f64| [c[0] + along * way[0] - side * way[1], c[1] + along * way[1] + side * way[0]];
            [half.map(at), half.map(|half| at(-half))]
        }
        _ => [None, None],
    }
}
