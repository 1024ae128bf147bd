//! What was noted of the records: of their elements, and while they were carried out.

use super::words::Key;
use std::ops::Range;

/// What an element should be.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Wanted {
    Integer,
    Real,
    Literal,
    Keyword,
}

impl Wanted {
    pub(crate) fn name(self) -> &'static str {
        match self {
            Wanted::Integer => "an integer number",
            Wanted::Real => "a real number",
            Wanted::Literal => "a literal",
            Wanted::Keyword => "a keyword",
        }
    }
}

/// What is kept and not made anything of.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Uninterpreted {
    /// All records of a type.
    Type(u16),
    /// All records of a subtype of a type.
    Subtype(u16, i64),
    /// A command.
    Command(Key),
}

/// What was noted.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum Event {
    /// An integer where a real belongs; it is in a record whose form the standard prints.
    IntegerForReal {
        printed: bool,
    },
    /// A real where an integer belongs.
    RealForInteger,
    /// An element of another kind than the wanted one; none is there at all; one more than there should be.
    Wrong {
        wanted: Wanted,
    },
    Missing {
        wanted: Wanted,
    },
    Extra,
    /// The coordinates make no whole number of points.
    IncompletePoint {
        values: usize,
        size: usize,
    },
    UnlistedSubtype,
    NotInterpreted(Uninterpreted),
    UnlistedCode {
        code: i64,
    },
    SplitCode {
        word: Key,
        other: Key,
    },
    /// A motion begins from where the tool stands, which nothing has said; it is by differences, or along an arc.
    UnknownStart {
        needed: bool,
    },
    /// So many motions without a feed; with the spindle off.
    NoFeed {
        count: usize,
    },
    SpindleOff {
        count: usize,
    },
    IdleRapid,
    StrayContinuation,
    IdleSurface,
    /// The distances of the ends from the centre, the radius of the circle and the cutter's diameter.
    OffTheCircle {
        start: f64,
        end: f64,
        radius: f64,
        cutter: Option<f64>,
    },
    /// The only point says nothing of the direction, and the axis says more than half a turn; degrees.
    DoubtfulDirection {
        degrees: f64,
    },
    TiltedCircle,
    ToolWithSpindle,
    CompensationOnArc,
    CycleWithoutDepth,
    NoEnd,
    BehindEnd,
    LateMachin,
    /// Another unit than the one before, or one behind the first motion.
    ChangedUnit,
    AssumedUnit,
    /// A place that is too far away to be computed with.
    TooFar,
}

/// An event, its record, and its element in the table of all where it is about one.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Noted {
    pub event: Event,
    pub record: usize,
    pub element: Option<usize>,
}

impl Noted {
    /// Its place in the stream.
    pub(crate) fn range(&self, tables: &super::record::Tables) -> Range<usize> {
        match self.element {
            Some(element) => tables.elements[element].range(),
            None => tables.records[self.record].range(),
        }
    }
}
