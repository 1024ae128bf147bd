//! The tape as paper: letters in the leader, what a row of holes says, a file that holds rows, the picture of a tape.

use crate::argument::{self, code_word, malformed};
use crate::functions::{DecodedView, decoded, set};
use crate::value::{Plain, to_js};
use nctape::Language;
use nctape::code::lettering as letters;
use nctape::code::{Code, Opened, about_tape, open};
use nctape::format::{TapeCode, TapeEnd};
use nctape::span::SpanKind;
use serde::Serialize;
use wasm_bindgen::prelude::*;

const CODES: [Code; 2] = [Code::Iso, Code::Eia];

/// The rows of a text in letters that a person reads, for the leader of a tape in either code; no row of them ends a
/// block or starts a program. None where nothing of the text can be lettered.
#[wasm_bindgen]
pub fn lettering(#[wasm_bindgen(unchecked_param_type = "string")] text: &JsValue) -> Result<Vec<u8>, JsValue> {
    Ok(letters::lettering(&argument::text(text, "text")?))
}

#[derive(Serialize)]
struct LeaderNote {
    advice: &'static str,
    missing: String,
}

/// What a control makes of a text in letters before this listing, and the characters that cannot be lettered.
#[wasm_bindgen(js_name = letteringNote, unchecked_return_type = "{ advice: string, missing: string }")]
pub fn lettering_note(
    #[wasm_bindgen(unchecked_param_type = "string")] text: &JsValue,
    #[wasm_bindgen(unchecked_param_type = "string")] source: &JsValue,
) -> Result<JsValue, JsValue> {
    let (text, source) = (argument::text(text, "text")?, argument::text(source, "source")?);
    Ok(to_js(&LeaderNote { advice: letters::advice(&source), missing: letters::missing(&text) }))
}

#[derive(Serialize)]
struct CodeView {
    id: &'static str,
    title: &'static str,
    tracks: [&'static str; 8],
    about: [&'static str; 3],
}

#[derive(Serialize)]
struct CodesView {
    tape: [&'static str; 2],
    codes: Vec<CodeView>,
}

/// The tape and its two codes in words.
#[wasm_bindgen(js_name = aboutCodes, unchecked_return_type = "AboutCodes")]
pub fn about_codes() -> JsValue {
    let codes = CODES.map(|code| CodeView {
        id: code_word(code),
        title: code.name(),
        tracks: code.tracks(),
        about: code.about(),
    });
    to_js(&CodesView { tape: about_tape(), codes: codes.into() })
}

#[derive(Serialize)]
struct RowInCode {
    id: &'static str,
    title: &'static str,
    label: String,
    name: Option<&'static str>,
    parity: bool,
    sentence: String,
}

/// What one row of holes says in each of the codes.
#[wasm_bindgen(js_name = rowWords, unchecked_return_type = "RowInCode[]")]
pub fn row_words(row: u8) -> JsValue {
    let views = CODES.map(|code| {
        let words = code.row_words(row);
        let (label, name, parity, sentence) = (words.label, words.name, words.parity, words.sentence);
        RowInCode { id: code_word(code), title: code.name(), label, name, parity, sentence }
    });
    to_js(&views.into_iter().collect::<Vec<_>>())
}

#[derive(Serialize)]
struct OpenedView {
    kind: &'static str,
    language: &'static str,
    text: String,
    reason: String,
    format: Plain,
    decoded: Option<DecodedView>,
}

/// What a file holds, by its content: a listing, or the image of a tape. The format is the given one, in the code that
/// the tape was found to be in.
#[wasm_bindgen(js_name = openFile, unchecked_return_type = "OpenedFile")]
pub fn open_file(
    #[wasm_bindgen(unchecked_param_type = "Uint8Array")] bytes: &JsValue,
    #[wasm_bindgen(unchecked_param_type = "Format")] format: &JsValue,
) -> Result<JsValue, JsValue> {
    let bytes = argument::bytes(bytes, "bytes")?;
    let (mut format, _) = argument::format(format)?;
    Ok(to_js(&match open(&bytes) {
        Opened::Listing { text, reason } => {
            let language = Language::of(&text).name();
            OpenedView { kind: "listing", language, text, reason, format: Plain(format.write()), decoded: None }
        }
        Opened::Image { decoded: found, reason } => {
            let (code, end) = match found.code {
                Code::Iso => (TapeCode::Iso, if found.by_return { TapeEnd::Cr } else { TapeEnd::Lf }),
                Code::Eia => (TapeCode::Eia, TapeEnd::Lf),
            };
            // What holds without being stated is not stated.
            let stated = &mut format.itemized;
            if stated.code.unwrap_or(TapeCode::Iso) != code {
                stated.code = Some(code);
            }
            if stated.end_of_block.unwrap_or(TapeEnd::Lf) != end {
                stated.end_of_block = Some(end);
            }
            OpenedView {
                kind: "image",
                language: Language::of(&found.text).name(),
                text: found.text.clone(),
                reason,
                format: Plain(format.write()),
                decoded: Some(decoded(&found)),
            }
        }
    }))
}

/// Rows that the reader of a format draws past its head in a second.
#[wasm_bindgen(js_name = readerSpeed)]
pub fn reader_speed(#[wasm_bindgen(unchecked_param_type = "Format")] format: &JsValue) -> Result<f64, JsValue> {
    Ok(argument::format(format)?.0.reader_speed())
}

#[derive(Serialize)]
struct UntimedView {
    sentence: &'static str,
    field: Option<&'static str>,
}

/// Why a moving span of a kind has no known time, and the field of the format that would say it.
#[wasm_bindgen(js_name = whyUntimed, unchecked_return_type = "{ sentence: string, field: string | null }")]
pub fn why_untimed(
    #[wasm_bindgen(unchecked_param_type = "Span[\"kind\"]")] kind: &JsValue,
    #[wasm_bindgen(unchecked_param_type = "Format")] format: &JsValue,
) -> Result<JsValue, JsValue> {
    let (format, _) = argument::format(format)?;
    let word = argument::text(kind, "kind")?;
    let kind = SpanKind::ALL.into_iter().find(|kind| kind.name() == word);
    let found = format.why_untimed(kind.ok_or_else(|| malformed("kind", "a kind of span is wanted"))?);
    Ok(to_js(&UntimedView { sentence: found.sentence, field: found.field }))
}

/// A format on the machine of another: set point, rapid traverse, reader and cutter are kept from that one.
#[wasm_bindgen(js_name = onMachineOf, unchecked_return_type = "Format")]
pub fn on_machine_of(
    #[wasm_bindgen(unchecked_param_type = "Format")] format: &JsValue,
    #[wasm_bindgen(unchecked_param_type = "Format")] other: &JsValue,
) -> Result<JsValue, JsValue> {
    let ((format, _), (other, _)) = (argument::format(format)?, argument::format(other)?);
    Ok(to_js(&Plain(format.on_machine_of(&other).write())))
}

/// A drawing of a tape in true millimetres, as SVG, so many rows to a line.
#[wasm_bindgen(js_name = tapeDrawing)]
pub fn tape_drawing(
    #[wasm_bindgen(unchecked_param_type = "Uint8Array")] rows: &JsValue,
    rows_in_line: u32,
) -> Result<String, JsValue> {
    Ok(nctape_draw::svg(&argument::bytes(rows, "rows")?, rows_in_line as usize))
}

/// The picture of a stretch of tape, true to scale: a row is `pitch` pixels long, which stand for 2.54 mm.
#[wasm_bindgen(unchecked_return_type = "{ width: number, height: number, rgba: Uint8Array, pixelsPerMetre: number }")]
pub fn picture(
    #[wasm_bindgen(unchecked_param_type = "Uint8Array")] rows: &JsValue,
    pitch: f64,
    #[wasm_bindgen(unchecked_param_type = "\"light\" | \"dark\"")] theme: &JsValue,
) -> Result<JsValue, JsValue> {
    let rows = argument::bytes(rows, "rows")?;
    let theme = argument::theme(theme)?;
    // `as` saturates, and a pitch that is no number becomes 0: the columns clamp it to what they can draw.
    let columns = nctape_draw::Columns::new(pitch as u32, theme);
    let tile = nctape_draw::tile(&rows, &columns);
    let metres = nctape_draw::dimensions::ROW_PITCH.nominal / 1000.0;
    let object = js_sys::Object::new();
    set(&object, "width", &tile.width.into());
    set(&object, "height", &tile.height.into());
    set(&object, "rgba", &js_sys::Uint8Array::from(tile.rgba.as_slice()));
    set(&object, "pixelsPerMetre", &(f64::from(columns.pitch()) / metres).into());
    Ok(object.into())
}
