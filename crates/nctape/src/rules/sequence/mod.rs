//! SEQ: sequence numbers.

pub(crate) mod alignment;
pub(crate) mod digits;
pub(crate) mod falling;
pub(crate) mod incomplete_alignment;
pub(crate) mod missing;
pub(crate) mod not_first;
pub(crate) mod repeated;
pub(crate) mod tab;
pub(crate) mod width;
