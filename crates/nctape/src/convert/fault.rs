//! What a format cannot say, in words.

use crate::write::Fault;

/// What a format cannot say, in words.
pub(super) fn told(fault: &Fault) -> String {
    format!("{}. It is not converted, and the tape stops there.", fault.told())
}
