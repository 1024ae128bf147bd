//! ROW: rows of holes. They are found by [`crate::code::decode`], whatever the format.

pub(crate) mod blank;
pub(crate) mod disregarded;
pub(crate) mod foreign_delete;
pub(crate) mod label;
pub(crate) mod no_parity;
pub(crate) mod odd_block;
pub(crate) mod parity;
pub(crate) mod unknown;

/// "holes in tracks 1, 3 and 5".
pub(crate) fn tracks(row: u8) -> String {
    let tracks: Vec<String> =
        (1..=8).filter(|track| row & (1 << (track - 1)) != 0).map(|track| track.to_string()).collect();
    match tracks.as_slice() {
        [] => "no hole".to_owned(),
        [one] => format!("a hole in track {one}"),
        [most @ .., last] => format!("holes in tracks {} and {last}", most.join(", ")),
    }
}
