//! SKIP: optional block skip.

pub(crate) mod changes_what_follows;
pub(crate) mod misplaced;
pub(crate) mod without_sequence;
