//! What stands before the first block: where the text comes from, what it lacks, and the modes that it rests on.

use super::findings::Findings;
use super::words::{comment_lines, coordinate, plain};
use crate::format::Unit;
use crate::tape::Tape;

pub(super) fn write(tape: &Tape, findings: &Findings, tolerance: f64, chords: bool) -> String {
    let control = tape.control();
    let unit = if control.unit == Unit::Inch { "inch" } else { "mm" };
    let mut head = String::from("%\n");
    let mut say = |sentence: &str| {
        for line in comment_lines(sentence) {
            head.push_str(&line);
            head.push('\n');
        }
    };
    let format = &control.format;
    let classification = format.classification.as_deref().map(|text| format!(" {text}")).unwrap_or_default();
    let origin = format!("{}{classification} {}", format.standard.title(), format.detail);
    say(&format!("For LinuxCNC, by the NC Tape Playground from a tape for {origin}"));
    match findings.refusals() {
        0 => {}
        1 => say("INCOMPLETE: a motion is not converted. Look for NOT CONVERTED, where LinuxCNC stops."),
        count => say(&format!(
            "INCOMPLETE: {count} motions are not converted. Look for NOT CONVERTED, where LinuxCNC stops."
        )),
    }
    if findings.leaves_out() {
        say("Functions or words are left out. Look for LEFT OUT.");
    }
    if findings.lacks_feed() {
        say("A cut has no known feed. Look for F0, at which LinuxCNC stops.");
    }
    let stands = control.set_point.iter().zip(&control.axes).filter(|(_, axis)| axis.sign.is_some());
    let stands = stands.map(|(&at, axis)| {
        let at = crate::execute::in_unit(axis, at);
        format!("{}{}", axis.letter, coordinate(at, axis.decimals))
    });
    let stands: Vec<String> = stands.collect();
    if !stands.is_empty() {
        say(&format!("Before the first block the tool stands at {}", stands.join(" ")));
    }
    if chords {
        say(&format!("Curves that LinuxCNC lacks are chords, at most {} {unit} off", plain(tolerance)));
    }
    head.push_str(if control.unit == Unit::Inch { "G20" } else { "G21" });
    head.push_str(" G17 G90 G91.1 G40 G49 G61 G80 G94 G97\n");
    head
}
