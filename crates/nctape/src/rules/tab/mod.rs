//! TAB: tabulation.

pub(crate) mod in_address_system;
