//! The commands, one file for each.

pub mod bench;
pub mod build;
pub mod serve;
pub mod suites;
pub mod test;
