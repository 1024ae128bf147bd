//! CONV: what a conversion cannot carry over, or writes otherwise than a reader may expect. No check of a tape reports
//! them, but `convert`; their pages are run through it.

pub(crate) mod curve_as_chords;
pub(crate) mod cut_without_feed;
pub(crate) mod does_not_fit;
pub(crate) mod end_as_stop;
pub(crate) mod function_left_out;
pub(crate) mod other_set_point;
pub(crate) mod rounded;
pub(crate) mod skip_is_fixed;
pub(crate) mod span_not_converted;
pub(crate) mod unreached_left_out;
pub(crate) mod word_left_out;
