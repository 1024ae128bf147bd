//! Punches a text in ASCII, without parity, and writes the picture of it.
//!
//! ```text
//! cargo run -p nctape-draw --example strip -- "N001G02X+0141" strip.png
//! ```

use std::error::Error;
use std::fs::File;

use nctape_draw::{Columns, Theme, tile};

fn main() -> Result<(), Box<dyn Error>> {
    let mut arguments = std::env::args().skip(1);
    let text = arguments.next().ok_or("usage: strip TEXT FILE.png [PITCH]")?;
    let path = arguments.next().ok_or("usage: strip TEXT FILE.png [PITCH]")?;
    let pitch = arguments.next().map_or(Ok(32), |pitch| pitch.parse())?;

    let picture = tile(text.as_bytes(), &Columns::new(pitch, Theme::Light));

    let mut encoder = png::Encoder::new(File::create(path)?, picture.width, picture.height);
    encoder.set_color(png::ColorType::Rgba);
    encoder.write_header()?.write_image_data(&picture.rgba)?;
    Ok(())
}
