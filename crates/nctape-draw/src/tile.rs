//! A stretch of tape.

use crate::columns::Columns;
use crate::picture::{BYTES_PER_PIXEL, Picture};

/// The picture of some rows, the first on the left.
///
/// It is as high as a column and as wide as all rows together.
/// Tiles put side by side make one tape: the drawing has no beginning and no end, and knows no place but that of a row in the tile,
/// so that a tape of kilometres is drawn as sharply at its end as at its beginning.
/// Nothing is visible at a tile's border.
pub fn tile(rows: &[u8], columns: &Columns) -> Picture {
    let width = rows.len() * columns.pitch() as usize;
    let height = columns.height() as usize;
    let mut rgba = Vec::with_capacity(width * height * BYTES_PER_PIXEL);
    for line in columns.lines() {
        for row in rows {
            rgba.extend_from_slice(line.pixels(*row));
        }
    }
    Picture { width: width as u32, height: height as u32, rgba }
}
