//! CLD: the reference language of ISO 3592.

pub(crate) mod apt_source;
pub(crate) mod assumed_unit;
pub(crate) mod behind_end;
pub(crate) mod behind_termination;
pub(crate) mod broken_sequence;
pub(crate) mod changed_unit;
pub(crate) mod compensation_on_arc;
pub(crate) mod cycle_without_depth;
pub(crate) mod doubtful_direction;
pub(crate) mod empty_element;
pub(crate) mod foreign_character;
pub(crate) mod idle_rapid;
pub(crate) mod idle_surface;
pub(crate) mod incomplete_point;
pub(crate) mod integer_for_real;
pub(crate) mod late_machin;
pub(crate) mod line_end_in_literal;
pub(crate) mod lower_case;
pub(crate) mod meaningless_character;
pub(crate) mod no_end;
pub(crate) mod no_feed;
pub(crate) mod no_file_separator;
pub(crate) mod no_record_separator;
pub(crate) mod no_termination;
pub(crate) mod no_two_integers;
pub(crate) mod not_interpreted;
pub(crate) mod off_the_circle;
mod prelude;
pub(crate) mod real_for_integer;
pub(crate) mod spindle_off;
pub(crate) mod split_code;
pub(crate) mod stray_continuation;
pub(crate) mod tilted_circle;
pub(crate) mod too_few_elements;
pub(crate) mod too_large;
pub(crate) mod too_many_elements;
pub(crate) mod tool_with_spindle;
pub(crate) mod typographic_character;
pub(crate) mod unclosed_literal;
pub(crate) mod unknown_keyword;
pub(crate) mod unknown_start;
pub(crate) mod unlisted_code;
pub(crate) mod unlisted_subtype;
pub(crate) mod unlisted_type;
pub(crate) mod unreadable_element;
mod view;
pub(crate) mod wrong_element;

pub(crate) use view::CldataView;

use crate::diagnostic::{Diagnostic, Sink};
use crate::rules::foreign_text;
use std::ops::Range;

/// The first statement of a text that is the source of a part program, and how many there are.
pub(crate) fn source_of_apt(text: &str) -> Option<(Range<usize>, usize)> {
    foreign_text::apt(text)
}

/// All that is found in a text, by position. Where it is the source of a part program, that is said alone.
pub(crate) fn check_cldata(view: &CldataView<'_>, apt: Option<(Range<usize>, usize)>) -> Vec<Diagnostic> {
    let mut found = Vec::new();
    let mut sink = Sink::cldata(&mut found);
    match apt {
        Some(apt) => apt_source::check_text(view.text, apt, &mut sink),
        None => check(view, &mut sink),
    }
    found.sort_by_key(|diagnostic| (diagnostic.range.start, diagnostic.range.end));
    found
}

fn check(view: &CldataView<'_>, sink: &mut Sink<'_>) {
    typographic_character::check(view, sink);
    broken_sequence::check(view, sink);
    no_termination::check(view, sink);
    behind_termination::check(view, sink);
    integer_for_real::check(view, sink);
    split_code::check(view, sink);
    for slip in &view.tables.slips {
        apt_source::check(slip, view, sink);
        meaningless_character::check(slip, view, sink);
        foreign_character::check(slip, view, sink);
        lower_case::check(slip, view, sink);
        unclosed_literal::check(slip, view, sink);
        line_end_in_literal::check(slip, view, sink);
        unreadable_element::check(slip, view, sink);
        empty_element::check(slip, view, sink);
        unknown_keyword::check(slip, view, sink);
        too_large::check(slip, view, sink);
        no_record_separator::check(slip, view, sink);
        no_file_separator::check(slip, view, sink);
    }
    for record in &view.tables.records {
        too_few_elements::check(record, view, sink);
        too_many_elements::check(record, view, sink);
        no_two_integers::check(record, view, sink);
        unlisted_type::check(record, view, sink);
    }
    for event in &view.execution.events {
        too_large::check_event(event, view, sink);
        real_for_integer::check(event, view, sink);
        wrong_element::check(event, view, sink);
        incomplete_point::check(event, view, sink);
        unlisted_subtype::check(event, view, sink);
        not_interpreted::check(event, view, sink);
        unlisted_code::check(event, view, sink);
        unknown_start::check(event, view, sink);
        no_feed::check(event, view, sink);
        spindle_off::check(event, view, sink);
        idle_rapid::check(event, view, sink);
        stray_continuation::check(event, view, sink);
        idle_surface::check(event, view, sink);
        off_the_circle::check(event, view, sink);
        doubtful_direction::check(event, view, sink);
        tilted_circle::check(event, view, sink);
        tool_with_spindle::check(event, view, sink);
        compensation_on_arc::check(event, view, sink);
        cycle_without_depth::check(event, view, sink);
        no_end::check(event, view, sink);
        behind_end::check(event, view, sink);
        late_machin::check(event, view, sink);
        changed_unit::check(event, view, sink);
        assumed_unit::check(event, view, sink);
    }
}
