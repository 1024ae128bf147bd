//! What the two-digit preparatory (G) and miscellaneous (M) functions mean: ISO 1056.

mod miscellaneous;
mod preparatory;

pub use miscellaneous::{Miscellaneous, Start, miscellaneous};
pub use preparatory::{Group, Preparatory, preparatory};
