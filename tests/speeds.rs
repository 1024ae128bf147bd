//! Feed and spindle speed codes: every entry of the tables printed in the two standards, read and written.

use nctape::format::{ArcFeed, FeedCoding};
use nctape::speed::{BadCode, Code, Coding, NoCode, Speed, arithmetic, geometric, reciprocal};
use nctape::{Format, Standard, Tape};
use std::collections::BTreeMap;

/// ISO 2539 A.2.2 and ISO 1058 A.1.1, which print the same: a speed and its codes of three, four and five digits.
const ARITHMETIC: [(f64, &str, &str, &str); 8] = [
    (1728.0, "717", "7173", "71728"),
    (150.3, "615", "6150", "61503"),
    (15.25, "515", "5153", "51525"),
    (7.826, "478", "4783", "47826"),
    (0.1537, "315", "3154", "31537"),
    (0.01268, "213", "2127", "21268"),
    (0.008759, "188", "1876", "18759"),
    (0.0004624, "046", "0462", "04624"),
];

/// What the digits of those codes say.
const SAID: [[f64; 3]; 8] = [
    [1700.0, 1730.0, 1728.0],
    [150.0, 150.0, 150.3],
    [15.0, 15.3, 15.25],
    [7.8, 7.83, 7.826],
    [0.15, 0.154, 0.1537],
    [0.013, 0.0127, 0.01268],
    [0.0088, 0.00876, 0.008759],
    [0.00046, 0.000462, 0.0004624],
];

/// ISO 1058 A.2.1, codes 01 to 98.
const GEOMETRIC: [f64; 98] = [
    1.12, 1.25, 1.40, 1.60, 1.80, 2.00, 2.24, 2.50, 2.80, 3.15, 3.55, 4.00, 4.50, 5.00, 5.60, 6.30, 7.10, 8.00, 9.00,
    10.0, 11.2, 12.5, 14.0, 16.0, 18.0, 20.0, 22.4, 25.0, 28.0, 31.5, 35.5, 40.0, 45.0, 50.0, 56.0, 63.0, 71.0, 80.0,
    90.0, 100.0, 112.0, 125.0, 140.0, 160.0, 180.0, 200.0, 224.0, 250.0, 280.0, 315.0, 355.0, 400.0, 450.0, 500.0,
    560.0, 630.0, 710.0, 800.0, 900.0, 1000.0, 1120.0, 1250.0, 1400.0, 1600.0, 1800.0, 2000.0, 2240.0, 2500.0, 2800.0,
    3150.0, 3550.0, 4000.0, 4500.0, 5000.0, 5600.0, 6300.0, 7100.0, 8000.0, 9000.0, 10000.0, 11200.0, 12500.0, 14000.0,
    16000.0, 18000.0, 20000.0, 22400.0, 25000.0, 28000.0, 31500.0, 35500.0, 40000.0, 45000.0, 50000.0, 56000.0,
    63000.0, 71000.0, 80000.0,
];

/// Lengths of the blocks of annex E's circular tape in millimetres, worked out by hand from its departures, and its F
/// at 300 mm/min.
const ANNEX_E: [(f64, i64); 11] = [
    (10.0, 30),
    (7.071_068, 42),
    (18.284, 16),
    (22.426_599, 13),
    (15.7078, 19),
    (15.7080, 19),
    (15.7078, 19),
    (11.716, 25),
    (28.284, 10),
    (70.0, 4),
    (12.247_449, 24),
];

fn code(text: &str) -> Code {
    Code { number: text.parse().unwrap(), digits: text.len() as u16 }
}

fn coding(method: FeedCoding, digits: u16) -> Coding<'static> {
    Coding { method, feed: true, digits, places: 0, shift: 0, scale: 1.0, table: None }
}

#[test]
fn arithmetic_codes_of_the_printed_tables() {
    for ((speed, three, four, five), said) in ARITHMETIC.into_iter().zip(SAID) {
        for (written, said) in [three, four, five].into_iter().zip(said) {
            assert_eq!(arithmetic::decode(code(written)), Ok(said), "{written}");
            let encoded = arithmetic::encode(speed, written.len() as u16).unwrap();
            assert_eq!(encoded.to_string(), written, "{speed}");
        }
    }
}

#[test]
fn arithmetic_codes_are_rounded_half_up_and_carry() {
    for (speed, digits, written) in [
        (15.25, 4, "5153"),
        (15.35, 4, "5154"),
        (99.6, 3, "610"),
        (99.4, 3, "599"),
        (999.5, 4, "7100"),
        (0.9999, 3, "410"),
        (0.0, 3, "000"),
        (0.0, 5, "00000"),
        (0.0001, 3, "010"),
        (0.000_099_6, 3, "010"),
        (990_000.0, 3, "999"),
    ] {
        assert_eq!(arithmetic::encode(speed, digits).unwrap().to_string(), written, "{speed}");
    }
    assert_eq!(arithmetic::encode(0.000_099, 3), Err(NoCode::Below(0.0001)));
    assert_eq!(arithmetic::encode(996_000.0, 3), Err(NoCode::Above(990_000.0)));
    assert_eq!(arithmetic::encode(5.0, 6), Err(NoCode::Digits));
    assert_eq!(arithmetic::decode(code("605")), Err(BadCode::SecondDigitZero));
    assert_eq!(arithmetic::decode(code("600")), Err(BadCode::SecondDigitZero));
    assert_eq!(arithmetic::decode(code("50")), Err(BadCode::Digits));
}

/// Every code that says a speed is the code of that speed, and no code is nearer to a speed than the one it gets.
#[test]
fn arithmetic_codes_go_there_and_back() {
    for digits in 3..=5 {
        for number in 0..10_i64.pow(u32::from(digits)) {
            let code = Code { number, digits };
            if let Ok(speed) = arithmetic::decode(code) {
                assert_eq!(arithmetic::encode(speed, digits), Ok(code), "{code} says {speed}");
            }
        }
    }
}

#[test]
fn geometric_codes_of_the_printed_table() {
    for (number, speed) in (1..).zip(GEOMETRIC) {
        assert_eq!(geometric::decode(number, 0), Ok(Speed::Is(speed)), "{number:02}");
        assert_eq!(geometric::encode(speed, 0), Ok(Code { number, digits: 2 }), "{speed}");
    }
    assert_eq!(geometric::decode(0, 0), Ok(Speed::Is(0.0)), "stop");
    assert_eq!(geometric::encode(0.0, 0), Ok(code("00")));
    assert_eq!(geometric::decode(99, 0), Ok(Speed::Rapid));
    assert_eq!(geometric::decode(100, 0), Err(BadCode::Digits));
}

/// ISO 1058 A.2.3: the decimal sign moved left.
#[test]
fn the_geometric_table_may_be_moved() {
    for (shift, tenth) in [(1, 10.0), (2, 100.0), (3, 1000.0)] {
        for (number, speed) in (1..).zip(GEOMETRIC) {
            let Ok(Speed::Is(moved)) = geometric::decode(number, shift) else { panic!("{number}") };
            let wanted = speed / tenth;
            assert!((moved - wanted).abs() <= 1e-12 * wanted, "{number}: {moved}, {wanted}");
            assert_eq!(geometric::encode(moved, shift), Ok(Code { number, digits: 2 }));
        }
    }
    assert_eq!(geometric::decode(50, 1), Ok(Speed::Is(31.5)));
}

#[test]
fn a_speed_between_two_geometric_codes_gets_the_one_nearer_in_ratio() {
    for speed in (10..900_000).map(|tenths| f64::from(tenths) / 10.0) {
        let ratio = |entry: &f64| f64::max(speed / entry, entry / speed);
        let best = GEOMETRIC.iter().map(ratio).fold(f64::INFINITY, f64::min);
        match geometric::encode(speed, 0) {
            Ok(code) => {
                let given = ratio(&GEOMETRIC[code.number as usize - 1]);
                assert!(given <= best * (1.0 + 1e-12), "{speed}: {code}");
                // Half the widest step of the table, 1,40 to 1,60: the root of 8/7.
                assert!(given <= 1.0691, "{speed}: {code} is {given} off");
            }
            Err(NoCode::Below(least)) => assert!(least == 1.12 && speed < 1.06, "{speed}"),
            Err(other) => assert!(other == NoCode::Above(80_000.0) && speed > 84_000.0, "{speed}: {other:?}"),
        }
    }
}

/// Annex E: F is 300 mm/min over the length, and never more.
#[test]
fn reciprocal_codes_of_the_printed_tape() {
    for (length, wanted) in ANNEX_E {
        let code = reciprocal::encode(300.0 / length, 1.0, 4, 0).unwrap();
        assert_eq!((code.number, code.digits), (wanted, 4), "{length}");
        // RS-274's feed rate number, with one decimal: ten times the rate.
        let ten = reciprocal::encode(300.0 / length, 10.0, 4, 0).unwrap();
        assert_eq!(ten.number, (3000.0 / length).floor() as i64);
    }
    // 900 mm/min over 180 mm, from the Mechanical Engineers' Handbook.
    assert_eq!(reciprocal::encode(900.0 / 180.0, 10.0, 4, 0).unwrap().to_string(), "0050");
}

#[test]
fn the_feed_on_an_arc_is_counted_against_its_radius_or_its_length() {
    let length = 20.0 * std::f64::consts::FRAC_PI_4;
    let by_radians = 300.0 / reciprocal::base(length, Some(20.0), ArcFeed::Radians);
    let by_time = 300.0 / reciprocal::base(length, Some(20.0), ArcFeed::Time);
    let number = |rate| reciprocal::encode(rate, 1.0, 4, 0).unwrap().number;
    assert_eq!((number(by_radians), number(by_time)), (15, 19));
    assert_eq!(reciprocal::base(length, None, ArcFeed::Radians), length, "on a line there is one reading");
}

#[test]
fn no_reciprocal_code_is_faster_than_was_asked_for() {
    for (scale, number) in [1.0, 10.0].into_iter().flat_map(|scale| (1..=9999_i64).map(move |n| (scale, n))) {
        let of = Coding { scale, ..coding(FeedCoding::TimeReciprocal, 4) };
        let Ok(Speed::Is(rate)) = of.decode(Code { number, digits: 4 }) else { panic!("{number}") };
        assert_eq!(of.encode(rate).unwrap().number, number, "there and back");
        let between = rate * (1.0 + 0.5 / number as f64);
        assert_eq!(of.encode(between).unwrap().number, number, "the code below");
    }
    let of = coding(FeedCoding::TimeReciprocal, 4);
    assert_eq!(of.encode(0.99), Err(NoCode::Below(1.0)));
    assert_eq!(of.encode(10_000.0), Err(NoCode::Above(9999.0)));
}

#[test]
fn direct_codes_are_rounded_half_up_and_keep_to_their_digits() {
    let of = |digits, places| Coding { places, ..coding(FeedCoding::Direct, digits) };
    // The parabolic tape of annex E, and EIA's f41: four digits before the decimal sign and one behind it.
    assert_eq!(of(4, 0).encode(300.0).unwrap().to_string(), "0300");
    assert_eq!(of(5, 1).encode(41.25).unwrap().to_string(), "00413");
    assert_eq!(of(5, 1).encode(9999.94).unwrap().to_string(), "99999");
    assert_eq!(of(4, 0).encode(9999.5), Err(NoCode::Above(9999.0)));
    assert_eq!(of(4, 0).encode(0.5).unwrap().number, 1);
    assert_eq!(of(4, 0).encode(0.49), Err(NoCode::Below(1.0)));
    assert_eq!(of(5, 2).encode(0.05).unwrap().number, 5);
    assert_eq!(of(5, 2).encode(0.995).unwrap().number, 100);
    assert_eq!(of(4, 0).encode(0.0).unwrap().number, 0);
    for number in 1..=9999 {
        let code = Code { number, digits: 4 };
        let Ok(Speed::Is(speed)) = of(4, 1).decode(code) else { panic!("{number}") };
        assert_eq!(of(4, 1).encode(speed), Ok(code), "there and back");
    }
}

#[test]
fn symbolic_codes_are_those_of_the_table() {
    let table: BTreeMap<String, f64> =
        [("1", 60.0), ("02", 120.0), ("3", 240.0), ("0", 0.0)].map(|(code, speed)| (code.to_owned(), speed)).into();
    let of = Coding { table: Some(&table), ..coding(FeedCoding::Symbolic, 1) };
    assert_eq!(of.decode(code("2")), Ok(Speed::Is(120.0)));
    assert_eq!(of.decode(code("7")), Err(BadCode::Unlisted));
    for (speed, wanted) in [(60.0, 1), (84.8, 1), (84.9, 2), (1000.0, 3), (0.0, 0)] {
        assert_eq!(of.encode(speed).unwrap().number, wanted, "{speed}");
    }
    assert_eq!(coding(FeedCoding::Symbolic, 1).encode(60.0), Err(NoCode::NoTable));
}

#[test]
fn nothing_is_a_speed_that_is_no_number_or_below_zero() {
    for method in [FeedCoding::TimeReciprocal, FeedCoding::Arithmetic, FeedCoding::Geometric, FeedCoding::Direct] {
        for speed in [f64::NAN, f64::INFINITY, -1.0] {
            assert_eq!(coding(method, 4).encode(speed), Err(NoCode::NotASpeed));
        }
        for speed in [f64::MIN_POSITIVE, 1e-300, 1e300, f64::MAX] {
            assert!(coding(method, 4).encode(speed).is_err(), "{method:?} {speed}");
        }
    }
}

/// Annex A gives rapid traverse the highest code: 99 of the table, and all nines of the arithmetic progression. The
/// highest number of the other methods is a feed. Of spindle speeds none is rapid traverse.
#[test]
fn the_highest_code_of_a_feed_is_rapid_traverse() {
    let run = |detail: &str, feed: &str, itemized: FeedCoding| {
        let mut format = Format::new(Standard::Iso2539, detail).classified("CAM 332");
        format.itemized.feed = Some(itemized);
        format.itemized.rapid = Some(nctape::format::value::Positive(6000.0));
        let text = format!("%\nN001 G01 X+001000 {feed}\nN002 M30\n");
        let tape = Tape::new(&text, &format);
        let span = &tape.spans().list[0];
        (span.kind.name(), span.feed, span.seconds, tape.totals().rapid)
    };
    let rapid = ("rapid", Some(6000.0), Some(0.1), 10.0);
    assert_eq!(run("N3G2X+42Y+32F2M2*", "F99", FeedCoding::Geometric), rapid);
    assert_eq!(run("N3G2X+42Y+32F3M2*", "F999", FeedCoding::Arithmetic), rapid);
    assert_eq!(run("N3G2X+42Y+32F5M2*", "F99999", FeedCoding::Arithmetic), rapid);
    assert_eq!(run("N3G2X+42Y+32F3M2*", "F998", FeedCoding::Arithmetic).0, "line");
    assert_eq!(run("N3G2X+42Y+32F3M2*", "F999", FeedCoding::Direct).1, Some(999.0));
    let (kind, _, seconds, _) = run("N3G2X+42Y+32F4M2*", "F9999", FeedCoding::TimeReciprocal);
    assert!(kind == "line" && (seconds.unwrap() - 60.0 / 9999.0).abs() < 1e-15);

    let feed = coding(FeedCoding::Arithmetic, 3);
    assert_eq!(feed.encode(990_000.0), Err(NoCode::Above(980_000.0)));
    assert_eq!(Coding { feed: false, ..feed }.decode(code("999")), Ok(Speed::Is(990_000.0)));
}
