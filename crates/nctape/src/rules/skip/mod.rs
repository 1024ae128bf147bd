//! SKIP: optional block skip.

pub(crate) mod misplaced;
pub(crate) mod without_sequence;
