//! NUM: digits and signs.

pub(crate) mod decimal_sign;
pub(crate) mod incremental_sign_missing;
pub(crate) mod minus_zero;
pub(crate) mod miscellaneous;
pub(crate) mod preparatory;
pub(crate) mod sign_forbidden;
pub(crate) mod sign_inside;
pub(crate) mod sign_missing;
pub(crate) mod sign_on_function;
pub(crate) mod too_few;
pub(crate) mod too_many;
pub(crate) mod tool;
pub(crate) mod wrong_count;
