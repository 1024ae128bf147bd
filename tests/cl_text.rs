//! CL text turned into the reference language: real files beside what another program made of them, and what holds for
//! every text.

use nctape::Severity;
use nctape::cldata::apt::{is_cl_text, translate};
use nctape::cldata::{Cldata, Options};
use proptest::prelude::*;
use proptest::sample::select;
use proptest::test_runner::RngSeed;

/// Two files as a CAM system wrote them, and the same in the reference language, not written by this crate.
const PAIRS: [(&str, &str); 2] = [
    (include_str!("cldata/creopost/bohren_1.ncl"), include_str!("cldata/creopost/bohren_1.cld")),
    (include_str!("cldata/creopost/profilfraesen_2.ncl"), include_str!("cldata/creopost/profilfraesen_2.cld")),
];

#[test]
fn real_files_become_what_another_program_made_of_them() {
    for (cl_text, records) in PAIRS {
        assert!(is_cl_text(cl_text));
        let found = translate(cl_text);
        assert_eq!(found.faults, []);
        assert_eq!(found.text, records);
    }
}

#[test]
fn what_comes_out_is_read_without_an_error() {
    for (cl_text, _) in PAIRS {
        let cldata = Cldata::new(&translate(cl_text).text, &Options::default());
        let errors: Vec<_> = cldata.diagnostics().iter().filter(|found| found.severity == Severity::Error).collect();
        assert!(errors.is_empty(), "{errors:?}");
        assert!(!cldata.spans().list.is_empty());
    }
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 2000, rng_seed: RngSeed::Fixed(3592), ..ProptestConfig::default() })]

    /// Any text gives records that are numbered from 1 and end their file, and every place that is named lies in it.
    #[test]
    fn any_text_gives_a_file_of_records(pieces in prop::collection::vec(select(PIECES), 0..40)) {
        let text = pieces.concat();
        let found = translate(&text);
        for (from, to) in &found.map {
            prop_assert!(text.get(from.clone()).is_some() && found.text.get(to.clone()).is_some());
        }
        for fault in &found.faults {
            prop_assert!(text.get(fault.range.clone()).is_some() && !fault.message.is_empty());
        }
        let records: Vec<&str> = found.text.lines().filter(|line| *line != ":").collect();
        for (index, record) in records.iter().enumerate() {
            let start = format!("{},", index + 1);
            prop_assert!(record.starts_with(&start), "{record}");
        }
        prop_assert_eq!(found.text.ends_with(":\n"), !records.is_empty());
    }
}

const PIECES: &[&str] = &[
    "GOTO / 1.0, 2.0, 3.0",
    "FROM/0,0,0",
    "GODLTA/1,2",
    "CIRCLE / 0,0,0,0,0,1,5",
    "MULTAX",
    "MULTAX/OFF",
    "UNITS / MM",
    "UNITS/",
    "PPRINT it's",
    "PARTNO",
    "INSERT N1$",
    "CUTTER/10,1E-3",
    "RAPID",
    "FINI",
    "FEDRAT / 400, MMPM",
    "$",
    "$$",
    "$$->",
    "$$* ",
    " ",
    ",",
    "/",
    "'",
    "''",
    "\n",
    "\n",
    "\r\n",
    "\r",
    "é",
    "−",
    "1.",
    "-.5E+2",
    ".",
    "A",
    "AB12",
];
