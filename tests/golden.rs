//! Pictures of tape, compared with those kept in `tests/golden`, bit for bit.
//!
//! tiny-skia was found to give the same pixels with and without SIMD, with AVX2 and FMA, and in wasm.
//!
//! After an intended change, `BLESS=1 cargo test -p nctape-draw --test golden` writes them anew; look at them before keeping them.

use std::fs::{self, File};
use std::io::{BufReader, BufWriter};
use std::path::{Path, PathBuf};

use nctape_draw::{Columns, Picture, Theme, tile};

/// "N001G02X+0141" and its end of block in ISO 840, parity in track 8, between two blank rows.
const BLOCK: [u8; 16] =
    [0x00, 0x4e, 0x30, 0x30, 0xb1, 0x47, 0x30, 0xb2, 0xd8, 0x2b, 0x30, 0xb1, 0xb4, 0xb1, 0x0a, 0x00];

#[test]
fn block_by_day() {
    compare("block-light-24", &tile(&BLOCK, &Columns::new(24, Theme::Light)));
}

#[test]
fn block_in_the_dark() {
    compare("block-dark-24", &tile(&BLOCK, &Columns::new(24, Theme::Dark)));
}

#[test]
fn block_at_the_largest_pitch() {
    compare("block-light-64", &tile(&BLOCK, &Columns::new(64, Theme::Light)));
}

#[test]
fn block_at_the_smallest_pitch() {
    compare("block-light-4", &tile(&BLOCK, &Columns::new(4, Theme::Light)));
}

#[test]
fn all_rows_by_day() {
    compare("all-rows-light-8", &Columns::new(8, Theme::Light).sheet());
}

#[test]
fn all_rows_in_the_dark() {
    compare("all-rows-dark-5", &Columns::new(5, Theme::Dark).sheet());
}

fn compare(name: &str, actual: &Picture) {
    let golden_path = Path::new(concat!(env!("CARGO_MANIFEST_DIR"), "/../../tests/golden")).join(format!("{name}.png"));
    if std::env::var_os("BLESS").is_some() {
        write(&golden_path, actual);
        return;
    }
    let Some(difference) = difference(&golden_path, actual) else {
        return;
    };
    let actual_path = PathBuf::from(env!("CARGO_TARGET_TMPDIR")).join(format!("{name}.png"));
    write(&actual_path, actual);
    panic!("{name}: {difference}; the picture drawn is {}", actual_path.display());
}

fn difference(golden_path: &Path, actual: &Picture) -> Option<String> {
    if !golden_path.exists() {
        return Some("there is no golden picture".to_owned());
    }
    let golden = read(golden_path);
    let (was, is) = ((golden.width, golden.height), (actual.width, actual.height));
    if was != is {
        return Some(format!("the size was {was:?} and is {is:?}"));
    }
    let byte = golden.rgba.iter().zip(&actual.rgba).position(|(was, is)| was != is)?;
    let pixel = byte as u32 / 4;
    let (x, y) = (pixel % actual.width, pixel / actual.width);
    let (was, is) = (golden.rgba[byte], actual.rgba[byte]);
    Some(format!("channel {} at x {x}, y {y} was {was} and is {is}", byte % 4))
}

fn read(path: &Path) -> Picture {
    let decoder = png::Decoder::new(BufReader::new(File::open(path).unwrap()));
    let mut reader = decoder.read_info().unwrap();
    let mut rgba = vec![0; reader.output_buffer_size().unwrap()];
    let frame = reader.next_frame(&mut rgba).unwrap();
    assert_eq!(frame.color_type, png::ColorType::Rgba, "{}", path.display());
    Picture { width: frame.width, height: frame.height, rgba }
}

fn write(path: &Path, picture: &Picture) {
    fs::create_dir_all(path.parent().unwrap()).unwrap();
    let file = BufWriter::new(File::create(path).unwrap());
    let mut encoder = png::Encoder::new(file, picture.width, picture.height);
    encoder.set_color(png::ColorType::Rgba);
    encoder.set_compression(png::Compression::High);
    let mut writer = encoder.write_header().unwrap();
    writer.write_image_data(&picture.rgba).unwrap();
}
