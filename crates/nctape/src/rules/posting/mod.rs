//! POST: what a post-processor cannot put on a tape, or puts there otherwise than a reader may expect. No check of
//! CLDATA reports them, but `postprocess`; their pages are run through it. What holds of every conversion to a format
//! is of the family CONV.

pub(crate) mod command_not_posted;
pub(crate) mod leader_not_in_text;
pub(crate) mod motion_not_posted;
pub(crate) mod part_left_out;
pub(crate) mod skip_displaces;
pub(crate) mod start_elsewhere;
pub(crate) mod statement_not_read;
pub(crate) mod text_as_it_stands;
pub(crate) mod tilted_tool_axis;
