//! What the two-digit preparatory (G) and miscellaneous (M) functions mean: ISO 1056.

mod conflict;
mod miscellaneous;
mod preparatory;

pub use conflict::{miscellaneous_conflict, preparatory_conflict};
pub use miscellaneous::{Hold, Matter, Miscellaneous, Start, miscellaneous};
pub use preparatory::{Group, Preparatory, preparatory};
