//! TAPE: the tape as a whole.

pub(crate) mod empty_block;
pub(crate) mod foreign_character;
pub(crate) mod last_end;
pub(crate) mod late_program_start;
pub(crate) mod leading_end;
pub(crate) mod lower_case;
pub(crate) mod no_end_code;
pub(crate) mod program_number;
pub(crate) mod rewind_stop;
pub(crate) mod unreached;
