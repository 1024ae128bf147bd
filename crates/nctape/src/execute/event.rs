//! What executing noted: facts with their figures, no words.

use super::circle::ArcFault;
use super::parabola::ParabolaFault;

/// Something that executing could not do as written, or that is worth knowing.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Event {
    /// The block where it stands.
    pub block: usize,
    pub kind: EventKind,
}

/// A span of several blocks.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Several {
    /// An arc in two blocks.
    Arc,
    /// A parabola in two blocks.
    Parabola,
    /// A cubic in three blocks.
    Curve,
}

/// What was noted.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum EventKind {
    /// Motion before any interpolation code. `lost`: a preparatory function before it was reported, and may have been it.
    NoInterpolation { lost: bool },
    /// Cutting motion with no feed, or feed zero.
    NoFeed,
    /// Time-reciprocal coding: cutting motion without an F of its own.
    NoOwnFeed,
    /// Time-reciprocal coding: a number so small that the next one is more than a quarter faster, by `step`.
    CoarseReciprocal { word: usize, feed: f64, step: f64 },
    /// Time-reciprocal coding: a parabola.
    ReciprocalParabola,
    /// Time-reciprocal coding: an arc, while it is not stated how its feed is read.
    ArcFeedNotStated { by_radians: f64, by_time: f64 },
    /// More axes move, a bit each in the order of the control, than the control moves at once.
    TooManyAxes { moving: u32, allowed: u8, positioning: bool },
    /// The third axis moves in an arc block, or has a parameter there.
    OutOfPlane { word: usize },
    /// The third axis moves between the points of an arc in two blocks.
    ThirdAxisMoves,
    /// An arc that cannot be computed.
    Arc(ArcFault),
    /// An arc that ends where it starts, while it is not stated what that means.
    FullCircle,
    /// A span of several blocks lacks its last ones.
    Unfinished(Several),
    /// Three points of an arc coincide or lie on a line.
    OnALine,
    /// A three-point arc runs the other way than its G code says.
    OtherWay { clockwise: bool },
    /// A parabola that cannot be computed.
    Parabola(ParabolaFault),
    /// The intermediate point of a parabola is far from opposite the middle of the chord.
    Skewed,
    /// The tangents of a parabola by its slopes meet beside the ends, so that it turns back on its way.
    TurnsBack,
    /// Interpolation parameters where none are used.
    IdleParameter { word: usize, code: u8 },
    /// A motion block whose dimension words move nothing.
    NoMotion,
    /// A position beyond what can be counted.
    Overflow { word: usize },
    /// A dimension word takes its axis to `at`, beyond its travel.
    OutOfTravel { word: usize, at: f64, travel: (f64, f64) },
    /// A symbolic feed or spindle speed code that has no value.
    Unlisted { word: usize },
    /// An arithmetic code whose second digit is zero though not all are.
    SecondDigitZero { word: usize },
    /// The feed is above the greatest one of the machine: by its F word, or by the length and time of the block.
    TooFast { word: Option<usize>, feed: f64 },
    /// Cutting motion under the geometric code 00, which is stop.
    StopFeed,
    /// The geometric code 99, which is rapid traverse, as a spindle speed.
    RapidSpeed { word: usize },
    /// A miscellaneous function starts the spindle before any S word.
    SpindleWithoutSpeed { word: usize },
    /// A thread has no lead along an axis that moves: the one that moves most.
    NoLead { axis: usize },
    /// A thread block gives a lead along an axis that does not move.
    IdleLead { word: usize, axis: usize },
    /// P, Q and R are no unit vector.
    VectorLength { length: f64 },
    /// The vector in force is not normal to the start of a span, or not tangent where that is declared; `other`: it is
    /// what the other kind would be.
    VectorAside { tangential: bool, other: bool },
    /// P, Q and R are axes of the format, yet form a unit vector under G41 or G42.
    VectorAsAxes,
    /// P, Q and R are the centre of an arc, for which I, J and K are.
    CentreInVector { own_reading: bool },
    /// A motion that could not be drawn at all, because no word of it could be read: the time of the tape is not known.
    LeftOut,
    /// A preparatory function whose effect is not computed.
    NotCarriedOut(u8),
}
