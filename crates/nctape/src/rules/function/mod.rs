//! FUN: preparatory and miscellaneous functions.

pub(crate) mod contouring;
pub(crate) mod dimension_mode;
pub(crate) mod idle_lead;
pub(crate) mod no_interpolation;
pub(crate) mod no_lead;
pub(crate) mod not_carried_out;
pub(crate) mod permanently_unassigned;
pub(crate) mod start_of_effect;
pub(crate) mod unassigned_miscellaneous;
pub(crate) mod unassigned_preparatory;

use crate::format::Control;
use crate::function::{miscellaneous_conflict, preparatory_conflict};

/// The itemized data gives the function a meaning, or the detail lacks its address, which is the fault then.
fn is_declared(letter: char, code: u8, control: &Control) -> bool {
    if control.designation(letter as u8).is_none() {
        return true;
    }
    let stated = &control.format.itemized;
    let name = format!("{letter}{code:02}");
    let declared = stated.declared.as_ref().map(|declared| if letter == 'G' { &declared.g } else { &declared.m });
    let curve = letter == 'G' && stated.curves.as_ref().is_some_and(|curves| curves.contains_key(&name));
    curve || declared.is_some_and(|functions| functions.contains_key(&name))
}

/// What another source says of the function, behind a message; empty where all agree.
fn conflict(letter: char, code: u8) -> String {
    let note = if letter == 'G' { preparatory_conflict(code) } else { miscellaneous_conflict(code) };
    note.map_or(String::new(), |note| format!(" {note}"))
}
