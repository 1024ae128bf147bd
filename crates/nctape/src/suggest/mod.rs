//! A format for a listing that came without one.
//!
//! Digits, signs, tabs and the letters in use are read off the text; where the decimal sign is understood, the unit and
//! what a function means to the control are not on the tape and are assumed. Candidates are ranked by what they leave
//! wrong.

mod detail;
mod mode;
mod survey;

use crate::diagnostic::Severity;
use crate::format::{ArcCentre, ArcFeed, Dimensions, FeedCoding, Format, Itemized, Standard, System, TapeCode};
use crate::order::order_by_key;
use crate::tape::Tape;
use detail::SignMark;
use survey::Survey;

/// A format that fits a listing, and what it rests on.
#[derive(Clone, Debug)]
pub struct Suggestion {
    /// The format.
    pub format: Format,
    /// What the listing itself says.
    pub sure: Vec<String>,
    /// What it does not say, and was assumed.
    pub assumed: Vec<String>,
    /// Errors that remain under the format.
    pub errors: usize,
}

/// The most suggestions that are given: more than a person compares.
const MOST: usize = 4;

/// How much of a listing is tried under each candidate, in blocks. What a control wants shows in the first hundreds; a
/// longer listing is surveyed whole, but only its beginning is executed a dozen times.
const BLOCKS_TRIED: usize = 500;

/// Suggests formats for a listing, best first. A listing without a word gives none, and neither does one of today's
/// G-code, whose dimension words have decimal points: no format of a tape fits it.
pub fn suggest(source: &str) -> Vec<Suggestion> {
    let survey = Survey::of(source);
    if survey.letters.is_empty() || survey.decimal_signs {
        return Vec::new();
    }
    let tried = survey.beginning(source, BLOCKS_TRIED);
    let mut ranked: Vec<(usize, usize, Format)> = Vec::new();
    for format in candidates(&survey) {
        let tape = Tape::new(tried, &format);
        let (errors, warnings) = (tape.count(Severity::Error), tape.count(Severity::Warning));
        if !ranked.iter().any(|(.., other)| *other == format) {
            ranked.push((errors, warnings, format));
        }
    }
    // Stable: candidates that leave as much wrong stay in the order of what is likely.
    order_by_key(&mut ranked, |(errors, warnings, _)| (*errors, *warnings));
    let full = |format: Format| {
        let errors = Tape::new(source, &format).count(Severity::Error);
        let (sure, assumed) = grounds(&survey, &format, errors);
        Suggestion { format, sure, assumed, errors }
    };
    ranked.into_iter().take(MOST).map(|(.., format)| full(format)).collect()
}

/// Formats worth trying, the likeliest first.
fn candidates(survey: &Survey) -> Vec<Format> {
    let standards: &[Standard] = if survey.lower_case {
        &[Standard::Rs274]
    } else if survey.contours {
        &[Standard::Iso2539]
    } else {
        &[Standard::Iso2539, Standard::Iso1058]
    };
    let readings: &[ArcCentre] = match (survey.parameters, survey.unsigned_parameters()) {
        (false, _) => &[ArcCentre::AsDimensions],
        (true, false) => &[ArcCentre::AsDimensions, ArcCentre::FromStart, ArcCentre::ToStart, ArcCentre::Absolute],
        // Where the dimension words have signs and the parameters have none, the control finds the quadrant itself.
        (true, true) => &[
            ArcCentre::Quadrant,
            ArcCentre::AsDimensions,
            ArcCentre::FromStart,
            ArcCentre::ToStart,
            ArcCentre::Absolute,
        ],
    };
    let mut formats = Vec::new();
    for mark in mode::likely(survey) {
        for &standard in standards {
            for &reading in readings {
                formats.push(format(survey, standard, mark, reading));
            }
        }
    }
    formats
}

fn format(survey: &Survey, standard: Standard, mark: SignMark, reading: ArcCentre) -> Format {
    let reciprocal = survey.feed_in_every_cut;
    let incremental = mark == SignMark::Incremental;
    Format {
        standard,
        classification: detail::classification(survey, standard),
        detail: detail::detail(survey, standard, mark),
        itemized: Itemized {
            code: (standard == Standard::Rs274).then_some(TapeCode::Eia),
            dimensions: (incremental && standard == Standard::Rs274).then_some(Dimensions::Incremental),
            arc_centre: Some(reading).filter(|reading| *reading != ArcCentre::AsDimensions),
            feed: (reciprocal && standard != Standard::Iso1058).then_some(FeedCoding::TimeReciprocal),
            arc_feed: (reciprocal && survey.contours).then_some(ArcFeed::Time),
            program_number_digits: survey.program_number_digits,
            ..Itemized::default()
        },
    }
}

/// What the suggestion rests on, in sentences.
fn grounds(survey: &Survey, format: &Format, errors: usize) -> (Vec<String>, Vec<String>) {
    let mut sure = Vec::new();
    let mut assumed = Vec::new();
    let letters: String = survey.letters.iter().map(|seen| char::from(seen.address)).collect();
    match survey.system {
        System::Tab => {
            sure.push(format!(
                "The blocks have up to {} columns, told apart by tabs, and no addresses.",
                letters.len()
            ));
            assumed.push(format!("The columns are {letters}, in the order of the standard."));
            let empty = survey.letters.iter().enumerate().filter(|(_, seen)| seen.count == 0);
            assumed.extend(empty.map(|(column, seen)| {
                format!(
                    "Column {} is empty in every block: that it is {} and how many digits it has are assumed.",
                    column + 1,
                    char::from(seen.address)
                )
            }));
        }
        _ => sure.push(format!("The addresses in use: {letters}.")),
    }
    if survey.system == System::TabAndAddress {
        sure.push("Words are preceded by tabs.".to_owned());
    }
    for seen in survey.letters.iter().filter(|seen| seen.is_dimension() && seen.count > 0) {
        let sign = if seen.signed == 0 { "never with a sign" } else { "with a sign" };
        let digits = match seen.shortest == seen.longest {
            true => format!("{} digits", seen.longest),
            false => format!("{} to {} digits", seen.shortest, seen.longest),
        };
        sure.push(format!("{} has {digits}, {sign}.", char::from(seen.address)));
    }
    if survey.shortens() {
        let which = if survey.leading_zeros_omitted() { "Leading" } else { "Trailing" };
        assumed.push(format!("{which} zeros are left out: the digits of one word differ in number."));
    }
    if survey.selects_dimensions {
        sure.push("G90 or G91 selects absolute or incremental dimensions.".to_owned());
    } else if survey.signed() {
        assumed.push(mode::reason(survey, format).to_owned());
    }
    assumed.push(
        "Where the decimal sign is understood is not on the tape: the places before and behind it are assumed."
            .to_owned(),
    );
    assumed.push(match format.standard {
        Standard::Rs274 => "Lengths are in inches.".to_owned(),
        _ => "Lengths are in millimetres.".to_owned(),
    });
    if format.itemized.feed == Some(FeedCoding::TimeReciprocal) {
        assumed.push("F is the reciprocal of time: every block that cuts has its own.".to_owned());
    }
    if let Some(reading) = format.itemized.arc_centre {
        let why = if errors == 0 { ": so the arcs end on their circles" } else { "" };
        assumed.push(format!("I, J and K are {}{why}.", reading.title()));
    }
    (sure, assumed)
}
