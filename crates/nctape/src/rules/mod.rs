//! The rules: one file each, with its names, verdicts, clauses, check and fix. Its page, which is its test, is
//! `tests/rules/<id>.md`.
//!
//! A check sees a word, a block, an event of execution, a whole tape, or the format. It is called from the list of its
//! stage below; that every rule is called is what the tests of the pages show.

pub(crate) mod cldata;
pub(crate) mod comment;
pub(crate) mod compensation;
pub(crate) mod conversion;
pub(crate) mod feed;
pub(crate) mod foreign_text;
pub(crate) mod format;
pub(crate) mod function;
pub(crate) mod motion;
pub(crate) mod number;
pub(crate) mod posting;
mod prelude;
pub(crate) mod row;
mod rule;
pub(crate) mod sequence;
pub(crate) mod skip;
mod sound;
pub(crate) mod tab;
pub(crate) mod tape;
mod view;
pub(crate) mod word;

pub(crate) use cldata::{CldataView, check_cldata, source_of_apt};
pub(crate) use foreign_text::is_source;
pub(crate) use prelude::{digits, is_declared_letter};
pub use rule::{Clause, Rule, Verdict, Verdicts};
pub(crate) use view::TapeView;

use crate::diagnostic::Sink;
use crate::format::Control;
use crate::read::{BlockView, Stray};

/// Every rule, family by family.
pub static ALL: &[&Rule] = &[
    &tape::leading_end::RULE,
    &tape::last_end::RULE,
    &tape::late_program_start::RULE,
    &tape::rewind_stop::RULE,
    &tape::program_number::RULE,
    &tape::foreign_character::RULE,
    &tape::lower_case::RULE,
    &tape::no_end_code::RULE,
    &tape::unreached::RULE,
    &tape::empty_block::RULE,
    &comment::unclosed::RULE,
    &comment::unopened::RULE,
    &comment::colon::RULE,
    &comment::percent::RULE,
    &comment::nested::RULE,
    &comment::swallowed::RULE,
    &skip::misplaced::RULE,
    &skip::without_sequence::RULE,
    &skip::changes_what_follows::RULE,
    &sequence::missing::RULE,
    &sequence::digits::RULE,
    &sequence::width::RULE,
    &sequence::tab::RULE,
    &sequence::not_first::RULE,
    &sequence::repeated::RULE,
    &sequence::falling::RULE,
    &sequence::alignment::RULE,
    &sequence::incomplete_alignment::RULE,
    &word::order::RULE,
    &word::dimension_order::RULE,
    &word::repeated::RULE,
    &word::two_miscellaneous::RULE,
    &word::two_tools::RULE,
    &word::no_digits::RULE,
    &word::no_address::RULE,
    &word::unknown_address::RULE,
    &word::unassigned_letter::RULE,
    &word::letter_o::RULE,
    &word::parameters::RULE,
    &word::undeclared_meaning::RULE,
    &word::compensation_letter::RULE,
    &word::axis_feed::RULE,
    &word::common_feed::RULE,
    &word::contouring_feed::RULE,
    &word::no_tool_change::RULE,
    &word::trailing_tabs::RULE,
    &word::letter_for_digit::RULE,
    &tab::in_address_system::RULE,
    &tab::wrong_column::RULE,
    &tab::too_many::RULE,
    &tab::missing::RULE,
    &tab::mixed::RULE,
    &tab::behind_address::RULE,
    &tab::sign_only::RULE,
    &tab::other_column::RULE,
    &tab::address_in_tab_system::RULE,
    &number::wrong_count::RULE,
    &number::too_many::RULE,
    &number::decimal_sign::RULE,
    &number::too_few::RULE,
    &number::both_zeros::RULE,
    &number::sign_missing::RULE,
    &number::incremental_sign_missing::RULE,
    &number::sign_forbidden::RULE,
    &number::sign_inside::RULE,
    &number::sign_on_function::RULE,
    &number::minus_zero::RULE,
    &number::preparatory::RULE,
    &number::miscellaneous::RULE,
    &number::tool::RULE,
    &number::turns_recommended::RULE,
    &number::beyond_a_turn::RULE,
    &number::out_of_travel::RULE,
    &function::unassigned_preparatory::RULE,
    &function::permanently_unassigned::RULE,
    &function::dimension_mode::RULE,
    &function::no_interpolation::RULE,
    &function::unassigned_miscellaneous::RULE,
    &function::start_of_effect::RULE,
    &function::contouring::RULE,
    &function::not_carried_out::RULE,
    &function::no_lead::RULE,
    &function::idle_lead::RULE,
    &motion::too_many_axes::RULE,
    &motion::out_of_plane::RULE,
    &motion::radius_mismatch::RULE,
    &motion::other_reading::RULE,
    &motion::zero_radius::RULE,
    &motion::unfinished_arc::RULE,
    &motion::points_on_a_line::RULE,
    &motion::other_way::RULE,
    &motion::leaves_quadrant::RULE,
    &motion::full_circle::RULE,
    &motion::unfinished_parabola::RULE,
    &motion::degenerate_parabola::RULE,
    &motion::skewed_parabola::RULE,
    &motion::idle_parameter::RULE,
    &motion::no_motion::RULE,
    &motion::open_path::RULE,
    &motion::overflow::RULE,
    &motion::undetermined_arc::RULE,
    &feed::short_reciprocal::RULE,
    &feed::no_own_feed::RULE,
    &feed::coarse_reciprocal::RULE,
    &feed::arc_feed_not_stated::RULE,
    &feed::reciprocal_on_parabola::RULE,
    &feed::second_digit_zero::RULE,
    &feed::arithmetic_width::RULE,
    &feed::geometric_width::RULE,
    &feed::stop_or_rapid::RULE,
    &feed::shift_not_stated::RULE,
    &feed::unlisted_code::RULE,
    &feed::no_feed::RULE,
    &feed::too_fast::RULE,
    &feed::slow_reading::RULE,
    &feed::not_in_1058::RULE,
    &feed::spindle_without_speed::RULE,
    &compensation::unit_vector::RULE,
    &compensation::vector_as_axes::RULE,
    &compensation::vector_aside::RULE,
    &compensation::centre_in_vector::RULE,
    &compensation::cutter_too_large::RULE,
    &format::class_contouring::RULE,
    &format::class_positioning::RULE,
    &format::class_system::RULE,
    &format::class_unit::RULE,
    &format::class_angles::RULE,
    &format::class_digits::RULE,
    &format::class_rising::RULE,
    &format::angles_undeclared::RULE,
    &format::motion_count::RULE,
    &format::tabs_disagree::RULE,
    &format::no_asterisk::RULE,
    &format::letter_order::RULE,
    &format::dimension_digits::RULE,
    &format::zero_mark::RULE,
    &format::function_digits::RULE,
    &format::short_sequence::RULE,
    &format::sequence_not_three::RULE,
    &format::two_digit_functions::RULE,
    &format::both_in_1058::RULE,
    &format::unassigned_letters::RULE,
    &format::parameters_in_1058::RULE,
    &format::shorthand_disagrees::RULE,
    &format::unknown_field::RULE,
    &format::unusable_value::RULE,
    &format::stray_character::RULE,
    &format::empty_detail::RULE,
    &format::idle_value::RULE,
    &conversion::span_not_converted::RULE,
    &conversion::function_left_out::RULE,
    &conversion::word_left_out::RULE,
    &conversion::cut_without_feed::RULE,
    &conversion::skip_is_fixed::RULE,
    &conversion::end_as_stop::RULE,
    &conversion::unreached_left_out::RULE,
    &conversion::curve_as_chords::RULE,
    &conversion::does_not_fit::RULE,
    &conversion::rounded::RULE,
    &conversion::other_set_point::RULE,
    &row::parity::RULE,
    &row::unknown::RULE,
    &row::blank::RULE,
    &row::disregarded::RULE,
    &row::odd_block::RULE,
    &row::label::RULE,
    &row::no_parity::RULE,
    &row::foreign_delete::RULE,
    &cldata::apt_source::RULE,
    &cldata::typographic_character::RULE,
    &cldata::meaningless_character::RULE,
    &cldata::foreign_character::RULE,
    &cldata::lower_case::RULE,
    &cldata::unclosed_literal::RULE,
    &cldata::line_end_in_literal::RULE,
    &cldata::unreadable_element::RULE,
    &cldata::empty_element::RULE,
    &cldata::unknown_keyword::RULE,
    &cldata::too_large::RULE,
    &cldata::no_record_separator::RULE,
    &cldata::no_file_separator::RULE,
    &cldata::too_few_elements::RULE,
    &cldata::too_many_elements::RULE,
    &cldata::no_two_integers::RULE,
    &cldata::broken_sequence::RULE,
    &cldata::unlisted_type::RULE,
    &cldata::no_termination::RULE,
    &cldata::behind_termination::RULE,
    &cldata::integer_for_real::RULE,
    &cldata::real_for_integer::RULE,
    &cldata::wrong_element::RULE,
    &cldata::incomplete_point::RULE,
    &cldata::unlisted_subtype::RULE,
    &cldata::not_interpreted::RULE,
    &cldata::unlisted_code::RULE,
    &cldata::unknown_start::RULE,
    &cldata::no_feed::RULE,
    &cldata::spindle_off::RULE,
    &cldata::idle_rapid::RULE,
    &cldata::stray_continuation::RULE,
    &cldata::idle_surface::RULE,
    &cldata::off_the_circle::RULE,
    &cldata::doubtful_direction::RULE,
    &cldata::tilted_circle::RULE,
    &cldata::tool_with_spindle::RULE,
    &cldata::compensation_on_arc::RULE,
    &cldata::cycle_without_depth::RULE,
    &cldata::no_end::RULE,
    &cldata::behind_end::RULE,
    &cldata::late_machin::RULE,
    &cldata::changed_unit::RULE,
    &cldata::assumed_unit::RULE,
    &cldata::split_code::RULE,
    &posting::tilted_tool_axis::RULE,
    &posting::command_not_posted::RULE,
    &posting::motion_not_posted::RULE,
    &posting::part_left_out::RULE,
    &posting::start_elsewhere::RULE,
    &posting::text_as_it_stands::RULE,
    &posting::leader_not_in_text::RULE,
    &posting::skip_displaces::RULE,
    &posting::statement_not_read::RULE,
];

/// The rules on one block: a function of its characters and the control.
pub(crate) fn check_block(block: &BlockView<'_>, sink: &mut Sink<'_>) {
    tape::foreign_character::check(block.strays, block.control, sink);
    tape::rewind_stop::check_block(block, sink);
    comment::unclosed::check(block, sink);
    comment::unopened::check(block, sink);
    comment::colon::check(block, sink);
    comment::percent::check(block, sink);
    comment::nested::check(block, sink);
    comment::swallowed::check(block, sink);
    skip::misplaced::check(block, sink);
    skip::without_sequence::check(block, sink);
    sequence::missing::check(block, sink);
    sequence::tab::check(block, sink);
    sequence::not_first::check(block, sink);
    sequence::alignment::check(block, sink);
    word::order::check(block, sink);
    word::dimension_order::check(block, sink);
    word::repeated::check(block, sink);
    word::two_miscellaneous::check(block, sink);
    word::two_tools::check(block, sink);
    word::trailing_tabs::check(block, sink);
    word::letter_o::check_block(block, sink);
    word::letter_for_digit::check(block, sink);
    tab::too_many::check(block, sink);
    tab::behind_address::check(block, sink);
    tape::last_end::check(block, sink);
    tape::empty_block::check(block, sink);
    for word in block.words {
        let sound = sound::is_sound(word, block);
        if sound && !cfg!(debug_assertions) {
            continue;
        }
        let before = sink.len();
        sequence::digits::check(word, block, sink);
        sequence::width::check(word, block, sink);
        word::no_digits::check(word, block, sink);
        word::no_address::check(word, block, sink);
        word::unknown_address::check(word, block, sink);
        word::unassigned_letter::check(word, block, sink);
        word::letter_o::check(word, sink);
        tab::wrong_column::check(word, block, sink);
        tab::sign_only::check(word, block, sink);
        word::parameters::check(word, block, sink);
        number::wrong_count::check(word, block, sink);
        number::too_many::check(word, block, sink);
        number::decimal_sign::check(word, block, sink);
        number::too_few::check(word, block, sink);
        number::sign_missing::check(word, block, sink);
        number::incremental_sign_missing::check(word, block, sink);
        number::sign_forbidden::check(word, block, sink);
        number::sign_inside::check(word, block, sink);
        number::sign_on_function::check(word, block, sink);
        number::minus_zero::check(word, block, sink);
        number::preparatory::check(word, block, sink);
        number::miscellaneous::check(word, block, sink);
        number::tool::check(word, block, sink);
        number::beyond_a_turn::check(word, block, sink);
        feed::not_in_1058::check_word(word, sink);
        feed::arithmetic_width::check(word, block, sink);
        feed::geometric_width::check(word, block, sink);
        function::unassigned_preparatory::check(word, block, sink);
        function::permanently_unassigned::check(word, block, sink);
        function::unassigned_miscellaneous::check(word, block, sink);
        function::dimension_mode::check(word, block, sink);
        function::contouring::check(word, block, sink);
        debug_assert!(!sound || sink.len() == before, "a rule speaks of a sound word: {word:?}");
    }
}

/// The rules on what stands before the first block of a program.
pub(crate) fn check_head(strays: &[Stray], control: &Control, sink: &mut Sink<'_>) {
    tape::foreign_character::check(strays, control, sink);
}

/// The rules on a whole tape and what executing it noted.
pub(crate) fn check_tape(tape: &TapeView<'_>, sink: &mut Sink<'_>) {
    tape::leading_end::check(tape, sink);
    tape::late_program_start::check(tape, sink);
    tape::rewind_stop::check(tape, sink);
    tape::program_number::check(tape, sink);
    tape::lower_case::check(tape, sink);
    tape::no_end_code::check(tape, sink);
    tape::unreached::check(tape, sink);
    skip::changes_what_follows::check(tape, sink);
    sequence::repeated::check(tape, sink);
    sequence::falling::check(tape, sink);
    sequence::incomplete_alignment::check(tape, sink);
    word::unknown_address::check_tape(tape, sink);
    word::no_tool_change::check(tape, sink);
    for block in word::feed_words(tape) {
        word::axis_feed::check(&block, tape, sink);
        word::common_feed::check(&block, tape, sink);
        word::contouring_feed::check(&block, tape, sink);
    }
    tab::in_address_system::check(tape, sink);
    tab::missing::check(tape, sink);
    tab::mixed::check(tape, sink);
    tab::other_column::check(tape, sink);
    tab::address_in_tab_system::check(tape, sink);
    function::no_interpolation::check(tape, sink);
    function::start_of_effect::check(tape, sink);
    function::not_carried_out::check(tape, sink);
    motion::too_many_axes::check_positioning(tape, sink);
    motion::full_circle::check(tape, sink);
    motion::no_motion::check(tape, sink);
    motion::open_path::check(tape, sink);
    feed::no_own_feed::check(tape, sink);
    feed::coarse_reciprocal::check(tape, sink);
    feed::arc_feed_not_stated::check(tape, sink);
    feed::reciprocal_on_parabola::check(tape, sink);
    feed::stop_or_rapid::check(tape, sink);
    feed::unlisted_code::check(tape, sink);
    feed::no_feed::check(tape, sink);
    feed::spindle_without_speed::check(tape, sink);
    feed::slow_reading::check(tape, sink);
    let is_moved = feed::shift_not_stated::check(tape, sink);
    compensation::vector_as_axes::check(tape, sink);
    compensation::vector_aside::check(tape, sink);
    compensation::cutter_too_large::check(tape, sink);
    for event in &tape.execution.events {
        motion::too_many_axes::check(event, tape, sink);
        motion::out_of_plane::check(event, tape, sink);
        motion::radius_mismatch::check(event, tape, sink);
        motion::other_reading::check(event, tape, sink);
        motion::zero_radius::check(event, tape, sink);
        motion::undetermined_arc::check(event, tape, sink);
        motion::unfinished_arc::check(event, tape, sink);
        motion::points_on_a_line::check(event, tape, sink);
        motion::other_way::check(event, tape, sink);
        motion::unfinished_parabola::check(event, tape, sink);
        motion::degenerate_parabola::check(event, tape, sink);
        motion::idle_parameter::check(event, tape, sink);
        motion::overflow::check(event, tape, sink);
        motion::leaves_quadrant::check(event, tape, sink);
        motion::skewed_parabola::check(event, tape, sink);
        number::out_of_travel::check(event, tape, sink);
        feed::second_digit_zero::check(event, tape, sink);
        if !is_moved {
            feed::too_fast::check(event, tape, sink);
        }
        function::no_lead::check(event, tape, sink);
        function::idle_lead::check(event, tape, sink);
        compensation::unit_vector::check(event, tape, sink);
        compensation::centre_in_vector::check(event, tape, sink);
    }
}
