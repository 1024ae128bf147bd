//! Whether the elements of a record are of the kinds that its type asks for (clause 6).
//!
//! Of clause 6 only 6.1 and 6.2 are public; the other forms are those of the examples in clause 5 and of the systems
//! that write such files (APT360, APT4 SSV3, CATIA). What is not known is not checked.

use super::element::{Element, ElementKind};
use super::event::{Event, Uninterpreted, Wanted};
use super::execution::State;
use super::record::Record;

/// The first elements that a type asks for, and what all others should be.
struct Shape {
    first: &'static [Wanted],
    /// How many of the first may be missing.
    optional: usize,
    rest: Rest,
}

#[derive(Clone, Copy, PartialEq, Eq)]
enum Rest {
    None,
    Any,
    Reals,
}

use Wanted::{Integer, Keyword, Literal, Real};

fn shape(kind: u16, subtype: Option<i64>) -> Option<Shape> {
    let shape = |first, optional, rest| Some(Shape { first, optional, rest });
    match (kind, subtype) {
        (1000, _) => shape(&[Integer, Literal, Literal], 1, Rest::None),
        (2000, _) => shape(&[Integer], 0, Rest::Any),
        (3000, _) => shape(&[Integer, Integer, Integer, Integer, Literal, Integer], 0, Rest::Reals),
        (4000 | 8000, _) => shape(&[Integer], 0, Rest::None),
        (5000, Some(1..=6 | 8)) => shape(&[Integer, Literal, Integer, Real, Real, Real], 0, Rest::Reals),
        (6000, Some(1)) => shape(&[Integer, Integer], 0, Rest::None),
        (6000, Some(3..=6)) => shape(&[Integer, Real], 0, Rest::Reals),
        (9000, Some(2 | 9)) => shape(&[Integer, Integer], 0, Rest::None),
        (9000, Some(1 | 10)) => shape(&[Integer, Real, Real, Real], 0, Rest::Reals),
        (5000 | 6000 | 7000 | 9000, _) => shape(&[Integer], 0, Rest::Any),
        (14000, _) => shape(&[], 0, Rest::None),
        (20000, _) => shape(&[Integer, Keyword], 0, Rest::Any),
        _ => None,
    }
}

/// A subtype that no table has.
fn is_unlisted(kind: u16, subtype: i64) -> bool {
    match kind {
        3000 => !(1..=5).contains(&subtype),
        4000 => !matches!(subtype, 1 | 2 | 3 | 5 | 6),
        5000 => !matches!(subtype, 1..=6 | 8),
        6000 => !(1..=9).contains(&subtype),
        7000 => !matches!(subtype, 1 | 2),
        8000 => !(1..=6).contains(&subtype),
        9000 => !(1..=10).contains(&subtype),
        _ => false,
    }
}

/// A subtype of which nothing is made.
fn is_idle(kind: u16, subtype: i64) -> bool {
    match kind {
        5000 => matches!(subtype, 1 | 2 | 8),
        6000 => matches!(subtype, 2 | 7..=9),
        9000 => matches!(subtype, 1 | 3..=8 | 10),
        _ => false,
    }
}

impl State<'_> {
    /// Notes what is wrong with the elements of a record.
    pub(super) fn check_shape(&mut self, index: usize, record: &Record) {
        let elements = self.tables.of(record);
        let subtype = elements.get(2).and_then(Element::whole);
        let Some(shape) = shape(record.kind, subtype) else {
            if record.kind >= 1000 && super::type_name(record.kind).is_some() {
                self.not_interpreted(Uninterpreted::Type(record.kind), index, None);
            }
            return;
        };
        let at = record.first as usize;
        let has_subtype = matches!(record.kind, 3000..=9000);
        if let Some(subtype) = subtype.filter(|_| has_subtype) {
            if is_unlisted(record.kind, subtype) {
                self.note(Event::UnlistedSubtype, index, Some(at + 2));
                return;
            }
            if is_idle(record.kind, subtype) {
                self.not_interpreted(Uninterpreted::Subtype(record.kind, subtype), index, Some(at + 2));
            }
        }
        if matches!(record.kind, 4000 | 7000 | 8000) {
            self.not_interpreted(Uninterpreted::Type(record.kind), index, None);
        }
        let printed = matches!((record.kind, subtype), (5000, _) | (6000, Some(6)));
        for (place, wanted) in shape.first.iter().enumerate() {
            match elements.get(place + 2) {
                Some(element) if self.check_element(index, at + place + 2, element, *wanted, printed) => {}
                // What stands behind it is out of its place, too.
                Some(_) => return,
                None if place + shape.optional >= shape.first.len() => break,
                None => {
                    self.note(Event::Missing { wanted: *wanted }, index, None);
                    return;
                }
            }
        }
        let known = shape.first.len() + 2;
        for (place, element) in elements.iter().enumerate().skip(known) {
            match shape.rest {
                Rest::Any => break,
                Rest::Reals if element.kind == ElementKind::Real => {}
                Rest::Reals if self.check_element(index, at + place, element, Real, printed) => {}
                Rest::Reals => return,
                Rest::None => {
                    self.note(Event::Extra, index, Some(at + place));
                    break;
                }
            }
        }
        if record.kind == 20000 {
            // The parameters of a command are real numbers: 6.2.2 prints FEDRAT,10.
            for (place, _) in
                elements.iter().enumerate().skip(4).filter(|(_, element)| element.kind == ElementKind::Integer)
            {
                self.note(Event::IntegerForReal { printed: false }, index, Some(at + place));
            }
        }
    }

    /// Notes what is wrong with an element; false where it is of another kind altogether.
    fn check_element(&mut self, record: usize, at: usize, element: &Element, wanted: Wanted, printed: bool) -> bool {
        let event = match (wanted, element.kind) {
            (_, ElementKind::Unreadable)
            | (Integer, ElementKind::Integer)
            | (Real, ElementKind::Real)
            | (Literal, ElementKind::Literal)
            | (Keyword, ElementKind::Keyword) => return true,
            (Real, ElementKind::Integer) => Event::IntegerForReal { printed },
            (Integer, ElementKind::Real) => Event::RealForInteger,
            _ => Event::Wrong { wanted },
        };
        let fits = !matches!(event, Event::Wrong { .. });
        self.note(event, record, Some(at));
        fits
    }
}
