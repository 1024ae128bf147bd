//! CTRL: control out and control in.

pub(crate) mod colon;
pub(crate) mod nested;
pub(crate) mod percent;
pub(crate) mod swallowed;
pub(crate) mod unclosed;
pub(crate) mod unopened;
