//! COMP: cutter compensation.

pub(crate) mod unit_vector;
