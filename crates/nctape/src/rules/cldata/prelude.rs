//! What the files of these rules use.

pub(crate) use super::CldataView;
pub(crate) use crate::cldata::ElementKind;
pub(crate) use crate::cldata::event::{Event, Noted, Uninterpreted};
pub(crate) use crate::cldata::record::{Record, Slip, Slipped, Unreadable};
pub(crate) use crate::diagnostic::{Fix, Severity, Sink};
pub(crate) use crate::order::order_by_key;
pub(crate) use crate::rules::prelude::page;
pub(crate) use crate::rules::{Clause, Rule, Verdicts};

/// A piece of the text as a message cites it: in typewriter's quotes, cut where it is long.
pub(crate) fn quoted(text: &str) -> String {
    /// More than this says nothing more.
    const MOST: usize = 24;
    let mut shown: String = text.chars().take(MOST).map(|c| if c.is_control() { ' ' } else { c }).collect();
    if text.chars().count() > MOST {
        shown.push('…');
    }
    format!("\"{shown}\"")
}

/// A length or an angle with at most four decimals, and no more of them than it needs.
pub(crate) fn shown(value: f64) -> String {
    let text = format!("{value:.4}");
    text.trim_end_matches('0').trim_end_matches('.').to_owned()
}
