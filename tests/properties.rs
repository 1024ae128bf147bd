//! What holds for every text, every format and every span.

use nctape::convert::{Converted, Dialect, convert, from_decimal, to_decimal};
use nctape::format::value::Positive;
use nctape::format::{
    ArcCentre, ArcFeed, ArcParameters, CompensationVector, CurveKind, Detail, Dimensions, Dwell, DwellUnit, FeedCoding,
    FeedUnit, Itemized, ParabolaParameters, Places, Plane, SetPoint, SpindleCoding, TapeCode, TimeScale, explain,
};
use nctape::span::{Geometry, SpanKind};
use nctape::{Format, Standard, Tape};
use proptest::prelude::*;
use proptest::sample::select;
use proptest::test_runner::RngSeed;

/// Pieces of tapes and rubbish, in the mixture that a spoiled tape has.
fn text() -> impl Strategy<Value = String> {
    let piece = prop_oneof![
        8 => select(vec![
            "N001", "n2", ":010", "G00", "G01", "G02", "G03", "G06", "G17", "G18", "G19", "G90", "G91", "G92", "G93", "G95",
            "G04", "G05", "G33", "G81", "G37", "X+010000", "X010000", "Y-005000", "Y5", "Z+001000", "I+014142", "J-014142",
            "G40", "G41", "G42", "G34", "P+1000", "Q+0707", "Q-1000", "R+0707", "R+000500", "B+09000", "%12", "F99", "T0102",
            "K+000001", "I0", "J0", "F0300", "F0", "S615", "T01", "M02", "M03", "M30", "X99999999999999999999", "H1", "O1",
        ]).prop_map(str::to_owned),
        3 => select(vec!["\n", "\r\n", "\r", "*", "*\n", "(", ")", "%", "/", "\t", " ", ".", "+", "-"]).prop_map(str::to_owned),
        1 => "\\PC{0,6}",
        1 => any::<char>().prop_map(String::from),
    ];
    prop::collection::vec(piece, 0..80).prop_map(|pieces| pieces.concat())
}

fn format() -> impl Strategy<Value = Format> {
    let standard = select(vec![Standard::Iso2539, Standard::Iso1058, Standard::Rs274]);
    let detail = prop_oneof![
        4 => select(vec![
            "N3.G2.XD33.YD33.ZD33.ID33.JD33.F4.M2*", "N3G2X+33Y+33Z+33I+33J+33K+33F4S3T2M2*", "N3G2XL042YL042IL033JL042F4M2*",
            "N3.G2.X420.Y420.F2.M2*", "n3 g2 x+14 y+14 i+15 j+15 f21 m2*", "X99Y+99I99J99P+13Q+13R+13", "N3G2XL33YL33ZL33IL33JL33KL33PL13QL13RL13B+23F2S2T4M2*", "N3G2X+33Z+33R+33F3S3M2*", "X+09Y+90Z00I+90F9",
        ]).prop_map(str::to_owned),
        1 => "\\PC{0,40}",
        1 => "[NGXYZIJKFSTM.+DL*0-9 ]{0,40}",
    ];
    let classification =
        prop_oneof![Just(None), "[CPL][ATS][MI][RD]? ?[0-9]{3}".prop_map(Some), "\\PC{0,12}".prop_map(Some),];
    (standard, classification, detail, itemized()).prop_map(|(standard, classification, detail, itemized)| Format {
        standard,
        classification,
        detail,
        itemized,
    })
}

fn itemized() -> impl Strategy<Value = Itemized> {
    fn some<T: Copy + std::fmt::Debug + 'static>(
        choices: &'static [(T, &str, &str)],
    ) -> impl Strategy<Value = Option<T>> {
        prop::option::of(select(choices).prop_map(|choice| choice.0))
    }
    let first = (
        some(TapeCode::ALL),
        some(Dimensions::ALL),
        some(Plane::ALL),
        some(ArcParameters::ALL),
        some(ArcCentre::ALL),
        some(FeedCoding::ALL),
        some(ArcFeed::ALL),
        some(ParabolaParameters::ALL),
    );
    let second = (prop::option::of(any::<bool>()), prop::option::of(any::<bool>()), prop::option::of(any::<bool>()));
    let positive = || prop::option::of(select(vec![1e-9, 0.5, 10.0, 300.0, 1e12]).prop_map(Positive));
    let digits = || prop::option::of(0_u8..10);
    let dwell = (select(vec!['F', 'X', 'P', 'Z', 'H']), select(vec![DwellUnit::Seconds, DwellUnit::Revolutions]));
    let third = (
        (some(CompensationVector::ALL), some(SpindleCoding::ALL), some(FeedUnit::ALL)),
        (positive(), positive(), positive(), positive()),
        (digits(), digits(), digits(), prop::option::of(select(vec![TimeScale(1), TimeScale(10)]))),
        prop::option::of(dwell.prop_map(|(address, unit)| Dwell { address, unit })),
        prop::option::of(prop::collection::vec(-1e6..1e6, 0..5).prop_map(SetPoint::InOrder)),
    );
    (first, second, third).prop_map(|(first, (helix, full_circle, compensation), third)| {
        let (choices, sizes, counts, dwell, set_point) = third;
        let (compensation_vector, spindle, feed_unit) = choices;
        let (cutter_radius, maximum_feed, rapid, reader_speed) = sizes;
        let (decimal_shift, compensation_digits, program_number_digits, time_scale) = counts;
        let (code, dimensions, plane, arc_parameters, arc_centre, feed, arc_feed, parabola_parameters) = first;
        Itemized {
            code,
            dimensions,
            plane,
            arc_parameters,
            arc_centre,
            feed,
            arc_feed,
            parabola_parameters,
            helix,
            full_circle,
            compensation,
            compensation_vector,
            spindle,
            feed_unit,
            cutter_radius,
            maximum_feed,
            rapid,
            reader_speed,
            decimal_shift,
            compensation_digits,
            program_number_digits,
            time_scale,
            dwell,
            set_point,
            curves: Some([("G05".to_owned(), CurveKind::Cubic)].into()),
            ..Itemized::default()
        }
    })
}

/// Source and text of a conversion are linked in order, and what is said of it is said inside the source.
fn is_linked(text: &str, converted: &Converted) -> Result<(), TestCaseError> {
    let mut end = 0;
    for (from, to) in &converted.map {
        prop_assert!(text.get(from.clone()).is_some() && converted.text.get(to.clone()).is_some());
        prop_assert!(to.start >= end || to.end == end, "{:?}", converted.map);
        end = to.end;
    }
    for found in &converted.diagnostics {
        prop_assert!(text.get(found.range.clone()).is_some(), "{} at {:?}", found.id, found.range);
    }
    prop_assert!(converted.diagnostics.windows(2).all(|pair| pair[0].range.start <= pair[1].range.start));
    Ok(())
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 2000, failure_persistence: None, rng_seed: RngSeed::Fixed(2539), ..ProptestConfig::default() })]

    #[test]
    fn any_text_under_any_format_gives_findings_inside_the_text(text in text(), format in format(), skip: bool) {
        let tape = Tape::with_skip(&text, &format, skip);
        for found in tape.diagnostics() {
            prop_assert!(text.get(found.range.clone()).is_some(), "{} at {:?}", found.id, found.range);
            prop_assert!(!found.message.is_empty() && found.count > 0);
            for related in &found.related {
                prop_assert!(text.get(related.range.clone()).is_some());
            }
            for edit in found.fixes.iter().flat_map(|fix| &fix.edits) {
                prop_assert!(text.get(edit.range.clone()).is_some());
            }
        }
        prop_assert!(tape.diagnostics().windows(2).all(|pair| pair[0].range.start <= pair[1].range.start));
        let explanation = explain(&format);
        for found in &explanation.diagnostics {
            let field = match found.path.as_str() {
                "classification" => format.classification.as_deref(),
                "detail" => Some(format.detail.as_str()),
                _ => None,
            };
            prop_assert!(field.is_none_or(|field| field == found.text), "{:?}", found);
            prop_assert!(found.text.get(found.diagnostic.range.clone()).is_some(), "{:?}", found);
        }
    }

    #[test]
    fn any_text_is_converted_to_lines_that_a_control_can_read(text in text(), format in format()) {
        let converted = to_decimal(&text, &format, Dialect::LinuxCnc);
        prop_assert!(converted.text.starts_with("%\n") && converted.text.ends_with("\n%\n"));
        for line in converted.text.lines() {
            // LinuxCNC reads up to 255 characters; a comment ends on its line and holds no other.
            prop_assert!(line.len() < 255, "{line}");
            let (open, close) = (line.matches('(').count(), line.matches(')').count());
            prop_assert!(open == close && open < 2, "{line}");
            let words = line.split('(').next().unwrap_or("");
            prop_assert!(!words.contains("NaN") && !words.contains("inf") && !words.contains('e'), "{line}");
        }
        is_linked(&text, &converted)?;
    }

    #[test]
    fn any_text_is_converted_to_blocks_of_any_format(text in text(), from in format(), to in format()) {
        for converted in [convert(&text, &from, &to), from_decimal(&text, &to)] {
            prop_assert!(converted.text.starts_with('%') && converted.text.ends_with('\n'));
            is_linked(&text, &converted)?;
            // What is written is in the language of the other format, as far as that has one.
            Tape::new(&converted.text, &to);
        }
    }

    #[test]
    fn the_path_of_the_cutter_is_finite(text in text(), format in format()) {
        if let Some(path) = Tape::new(&text, &format).offset(0.1) {
            prop_assert!(path.xyz.iter().all(|at| at.is_finite()));
        }
    }

    #[test]
    fn blocks_words_and_rows_follow_the_text_in_order(text in text(), format in format()) {
        let tape = Tape::new(&text, &format);
        let reading = tape.reading();
        prop_assert!(reading.blocks.windows(2).all(|pair| pair[0].range.end <= pair[1].range.start));
        for (index, block) in reading.blocks.iter().enumerate() {
            prop_assert_eq!(reading.block_at(block.range.start), Some(index));
            let words = reading.words(block);
            prop_assert!(words.windows(2).all(|pair| pair[0].range().end <= pair[1].range().start));
            for word in words {
                let range = reading.range(block, word);
                prop_assert!(range.end <= block.range.end && text.get(range).is_some());
            }
            prop_assert!(tape.rows_of(block).end <= tape.rows().bytes.len());
        }
        let rows = tape.rows();
        prop_assert_eq!(rows.bytes.len(), rows.offsets.len());
        prop_assert!(rows.offsets.windows(2).all(|pair| pair[0] < pair[1]));
    }

    #[test]
    fn spans_join_and_their_points_end_on_the_programmed_point(text in text(), format in format()) {
        let tape = Tape::new(&text, &format);
        let spans = tape.spans();
        // G92 moves the origin and no tool: only there do two spans not join.
        for index in 1..if text.contains("G92") { 1 } else { spans.list.len() } {
            prop_assert_eq!(spans.start(index), spans.end(index - 1));
        }
        for (index, span) in spans.list.iter().enumerate() {
            prop_assert!(span.length.is_finite() && span.length >= 0.0);
            prop_assert!(span.feed.is_none_or(f64::is_finite) && span.seconds.is_none_or(f64::is_finite));
            prop_assert!(spans.start(index) != spans.end(index) || span.kind == SpanKind::Dwell || matches!(span.geometry, Geometry::Arc(_) | Geometry::Curve { .. }), "moves nothing");
            prop_assert!(span.blocks.0 <= span.blocks.1 && span.blocks.1 < tape.reading().blocks.len());
        }
        let points = tape.points(0.1);
        for (index, span) in spans.list.iter().enumerate() {
            let own: Vec<usize> = (0..points.span.len()).filter(|&point| points.span[point] == index as u32).collect();
            let at = |point: usize| &points.xyz[3 * point..3 * point + 3];
            prop_assert_eq!(at(own[0]), &span.start[..]);
            prop_assert_eq!(at(own[own.len() - 1]), &span.end[..]);
        }
    }

    #[test]
    fn a_format_survives_being_written_and_read(format in format()) {
        let (read, problems) = Format::read(&format.write()).expect("a format");
        prop_assert_eq!(read, format);
        prop_assert!(problems.is_empty());
    }

    #[test]
    fn the_decimal_sign_moves_and_comes_back(format in format()) {
        let Some(now) = Places::of(&format) else { return Ok(()) };
        prop_assert!(now.least <= now.places && now.places <= now.greatest);
        let widths = |format: &Format| -> Vec<_> {
            Detail::read(&format.detail, format.standard).words.iter().map(|word| (word.width(), word.zeros)).collect()
        };
        for places in now.least..=now.greatest {
            let moved = format.with_places(places).expect("a place that is allowed");
            prop_assert_eq!(Places::of(&moved).map(|moved| moved.places), Some(places));
            prop_assert_eq!(widths(&moved), widths(&format));
            prop_assert_eq!(moved.with_places(now.places).map(|back| back.detail), Some(format.detail.clone()));
        }
    }
}
