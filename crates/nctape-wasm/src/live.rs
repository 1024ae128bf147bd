//! The live tape: one text that is edited, asked for what is visible.

use crate::argument;
use crate::functions::set;
use crate::offsets::Offsets;
use crate::path::{change_to_js, path_to_js};
use crate::report::{self, BlockView, TotalsView};
use crate::value::to_js;
use nctape::{Bounds, Format, Kept, Severity, Tape as CoreTape};
use serde::Serialize;
use wasm_bindgen::prelude::*;

/// A tape that is edited. Every change has a number; offsets are UTF-16 code units.
#[wasm_bindgen]
pub struct Tape {
    pub(crate) tape: CoreTape,
    offsets: Offsets,
    edit: u32,
    /// The path that was told last, and the one before it: the page may have thrown the last one away as late.
    told: Vec<Told>,
    paths: u32,
}

/// A path that was told, and what of it still holds.
#[derive(Clone, Copy)]
struct Told {
    number: u32,
    tolerance: f64,
    kept: Kept,
    blocks: usize,
}

#[derive(Serialize)]
struct Summary {
    edit: u32,
    unit: &'static str,
    axes: Vec<String>,
    code: &'static str,
    blocks: usize,
    skips: usize,
    rows: usize,
    spans: usize,
    errors: usize,
    warnings: usize,
    infos: usize,
    totals: TotalsView,
    bounds: Option<BoundsView>,
    compensated: bool,
}

#[derive(Serialize)]
pub(crate) struct BoundsView {
    min: [f64; 3],
    max: [f64; 3],
}

impl From<Bounds> for BoundsView {
    fn from(bounds: Bounds) -> BoundsView {
        BoundsView { min: bounds.least, max: bounds.greatest }
    }
}

impl Tape {
    /// A tape of a text that is read under a format.
    pub(crate) fn of(source: &str, format: &Format, skip: bool) -> Tape {
        let tape = CoreTape::with_skip(source, format, skip);
        Tape { tape, offsets: Offsets::new(source), edit: 0, told: Vec::new(), paths: 0 }
    }
}

#[derive(Serialize)]
struct PlacedBlock {
    #[serde(flatten)]
    block: BlockView,
    index: usize,
    rows: (usize, usize),
    span: Option<usize>,
}

#[wasm_bindgen]
impl Tape {
    /// Reads and executes a text under a format.
    #[wasm_bindgen(constructor)]
    pub fn new(
        #[wasm_bindgen(unchecked_param_type = "string")] source: &JsValue,
        #[wasm_bindgen(unchecked_param_type = "Format")] format: &JsValue,
        #[wasm_bindgen(unchecked_optional_param_type = "{ skip?: boolean } | null")] options: &JsValue,
    ) -> Result<Tape, JsValue> {
        let source = argument::text(source, "source")?;
        let (format, _) = argument::format(format)?;
        let options = argument::options(options)?;
        Ok(Tape::of(&source, &format, options.skip))
    }

    /// Replaces the text between two offsets; answers the number of the edit.
    ///
    /// Where an end lies within a surrogate pair, the half that stays becomes U+FFFD, as JavaScript shows it.
    pub fn edit(&mut self, from: u32, to: u32, insert: &str) -> u32 {
        let (range, text) = self.offsets.edit_in_bytes(self.tape.text(), from, to, insert);
        self.tape.edit(range.clone(), &text);
        self.offsets.edit(self.tape.text(), range.start, range.len(), text.len());
        let kept = self.tape.last_kept();
        for told in &mut self.told {
            told.kept.first = told.kept.first.min(kept.first);
            told.kept.last = told.kept.last.min(kept.last);
        }
        self.next_edit()
    }

    /// Changes the format; answers the number of the edit.
    #[wasm_bindgen(js_name = setFormat)]
    pub fn set_format(
        &mut self,
        #[wasm_bindgen(unchecked_param_type = "Format")] format: &JsValue,
    ) -> Result<u32, JsValue> {
        let (format, _) = argument::format(format)?;
        self.tape.set_format(&format);
        self.told.clear();
        Ok(self.next_edit())
    }

    /// Turns the optional block skip switch; answers the number of the edit.
    #[wasm_bindgen(js_name = setSkip)]
    pub fn set_skip(&mut self, on: bool) -> u32 {
        self.tape.set_skip(on);
        self.told.clear();
        self.next_edit()
    }

    fn next_edit(&mut self) -> u32 {
        self.edit = self.edit.wrapping_add(1);
        self.edit
    }

    /// What the tape holds, in numbers.
    #[wasm_bindgen(unchecked_return_type = "Summary")]
    pub fn summary(&self) -> JsValue {
        to_js(&Summary {
            edit: self.edit,
            unit: self.tape.control().unit.name(),
            axes: report::axes(&self.tape),
            code: argument::code_word(self.tape.control().code),
            blocks: self.tape.reading().blocks.len(),
            skips: self.tape.reading().blocks.iter().filter(|block| block.skip).count(),
            rows: self.tape.reading().row_count(),
            spans: self.tape.spans().list.len(),
            errors: self.tape.count(Severity::Error),
            warnings: self.tape.count(Severity::Warning),
            infos: self.tape.count(Severity::Info),
            totals: report::totals(&self.tape),
            compensated: self.tape.spans().offsets().iter().any(|offset| *offset != nctape::span::Offset::None),
            bounds: self.tape.bounds().map(BoundsView::from),
        })
    }

    /// The diagnostics that touch a stretch of text, at most `limit`.
    #[wasm_bindgen(unchecked_return_type = "Diagnostic[]")]
    pub fn diagnostics(&self, from: u32, to: u32, limit: u32) -> JsValue {
        let (from, _) = self.offsets.byte(from as usize);
        let (to, _) = self.offsets.byte(to as usize);
        let found = self.tape.diagnostics_in(from..to.max(from), limit as usize);
        let views = found.iter().map(|found| report::diagnostic(found, self.tape.standard(), &self.offsets));
        to_js(&views.collect::<Vec<_>>())
    }

    /// A block, and where it lies in every view; `null` beyond the last one.
    #[wasm_bindgen(unchecked_return_type = "BlockView | null")]
    pub fn block(&self, index: u32) -> JsValue {
        let index = index as usize;
        let Some(block) = self.tape.reading().blocks.get(index) else { return JsValue::NULL };
        let rows = self.tape.rows_of(block);
        to_js(&PlacedBlock {
            block: report::block(&self.tape, block, &self.offsets),
            index,
            rows: (rows.start, rows.end),
            span: self.span_of(index),
        })
    }

    /// What the blocks that touch a stretch of text are made of, for whoever colours it: at most `limit` blocks.
    #[wasm_bindgen(unchecked_return_type = "Syntax")]
    pub fn syntax(&self, from: u32, to: u32, limit: u32) -> JsValue {
        let reading = self.tape.reading();
        let ((from, _), (to, _)) = (self.offsets.byte(from as usize), self.offsets.byte(to as usize));
        let first = reading.blocks.partition_point(|block| block.range.end < from);
        let touched =
            || reading.blocks[first..].iter().take(limit as usize).take_while(|block| block.range.start <= to);
        let unit = |byte: usize| self.offsets.utf16(byte) as u32;
        let starts: Vec<u32> = touched().map(|block| unit(block.range.start)).collect();
        let kinds: Vec<u8> = (first..first + starts.len()).map(|block| self.kind_of(block)).collect();
        let (mut ranges, mut roles) = (Vec::new(), Vec::new());
        for block in touched() {
            for (place, word) in reading.words(block).iter().take(limit as usize).enumerate() {
                let range = reading.range(block, word);
                let is_sequence = place == 0 && word.is_sequence();
                let address = usize::from(word.address != 0 && !word.by_column);
                let end = if is_sequence { range.end } else { range.start + address };
                if end > range.start {
                    ranges.extend([unit(range.start), unit(end)]);
                    roles.push(u8::from(is_sequence));
                }
            }
        }
        let object = js_sys::Object::new();
        set(&object, "starts", &js_sys::Uint32Array::from(starts.as_slice()));
        set(&object, "kinds", &js_sys::Uint8Array::from(kinds.as_slice()));
        set(&object, "ranges", &js_sys::Uint32Array::from(ranges.as_slice()));
        set(&object, "roles", &js_sys::Uint8Array::from(roles.as_slice()));
        object.into()
    }

    /// The kind of a block's span: 0 none, else its place among all kinds plus 1.
    fn kind_of(&self, block: usize) -> u8 {
        self.span_of(block).map_or(0, |span| self.tape.spans().list[span].kind.index() as u8 + 1)
    }

    /// The span that a block belongs to. Where it ends one and stands in for another, the one that begins last.
    fn span_of(&self, block: usize) -> Option<usize> {
        let spans = self.tape.spans().of_block(block);
        (!spans.is_empty()).then(|| spans.end - 1)
    }

    /// The block at an offset; -1 where there is none.
    #[wasm_bindgen(js_name = blockAt)]
    pub fn block_at(&self, offset: u32) -> i32 {
        self.tape.reading().block_at(self.offsets.byte(offset as usize).0).map_or(-1, |index| index as i32)
    }

    /// The block of a row; -1 where it belongs to none.
    #[wasm_bindgen(js_name = blockOfRow)]
    pub fn block_of_row(&self, row: u32) -> i32 {
        self.tape.reading().block_of_row(row as usize).map_or(-1, |index| index as i32)
    }

    /// The row whose character stands at or behind an offset; -1 behind the last one.
    #[wasm_bindgen(js_name = rowAt)]
    pub fn row_at(&self, offset: u32) -> i32 {
        let (byte, _) = self.offsets.byte(offset as usize);
        let row = self.tape.row_at(byte);
        if row < self.tape.reading().row_count() { row as i32 } else { -1 }
    }

    /// A stretch of rows, one entry in each array for each row.
    #[wasm_bindgen(unchecked_return_type = "RowWindow")]
    pub fn rows(&self, first: u32, count: u32) -> JsValue {
        let from = (first as usize).min(self.tape.reading().row_count());
        let rows = self.tape.rows_from(from, count as usize);
        let offsets: Vec<u32> = rows.offsets.iter().map(|&byte| self.offsets.utf16(byte as usize) as u32).collect();
        let blocks: Vec<i32> = (from..from + rows.bytes.len()).map(|row| self.block_of_row(row as u32)).collect();
        let kinds: Vec<u8> =
            blocks.iter().map(|&block| usize::try_from(block).map_or(0, |block| self.kind_of(block))).collect();
        let object = js_sys::Object::new();
        set(&object, "first", &(from as u32).into());
        set(&object, "bytes", &js_sys::Uint8Array::from(rows.bytes.as_slice()));
        set(&object, "offsets", &js_sys::Uint32Array::from(offsets.as_slice()));
        set(&object, "blocks", &js_sys::Int32Array::from(blocks.as_slice()));
        set(&object, "kinds", &js_sys::Uint8Array::from(kinds.as_slice()));
        object.into()
    }

    /// The first span whose time is not known; -1 where there is none.
    pub fn untimed(&self) -> i32 {
        self.tape.spans().list.iter().position(|span| span.seconds.is_none()).map_or(-1, |index| index as i32)
    }

    /// A span; `null` beyond the last one.
    #[wasm_bindgen(unchecked_return_type = "Span | null")]
    pub fn span(&self, index: u32) -> JsValue {
        let index = index as usize;
        if index < self.tape.spans().list.len() { to_js(&report::span(&self.tape, index)) } else { JsValue::NULL }
    }

    /// The flattened path with what drawing needs; the tolerance is a length above zero in the unit of the format.
    #[wasm_bindgen(unchecked_return_type = "Path")]
    pub fn path(
        &self,
        #[wasm_bindgen(unchecked_param_type = "number")] tolerance: &JsValue,
    ) -> Result<JsValue, JsValue> {
        Ok(self.path_of(Kept::default(), argument::tolerance(tolerance)?).into())
    }

    /// Whether the path is that of another tape within a tolerance, a length above zero in the unit of this one's
    /// format. Order and direction count, and rapid traverse is another path than the same way at feed; how the path is
    /// divided into blocks does not count.
    #[wasm_bindgen(js_name = samePath)]
    pub fn same_path(
        &self,
        other: &Tape,
        #[wasm_bindgen(unchecked_param_type = "number")] tolerance: &JsValue,
    ) -> Result<bool, JsValue> {
        Ok(nctape::same_path(&self.tape, &other.tape, argument::tolerance(tolerance)?))
    }

    /// The path of the cutter's centre where cutter compensation is in force; `null` where it is not, or where the
    /// format states no radius of a cutter.
    #[wasm_bindgen(unchecked_return_type = "OffsetPath | null")]
    pub fn offset(
        &self,
        #[wasm_bindgen(unchecked_param_type = "number")] tolerance: &JsValue,
    ) -> Result<JsValue, JsValue> {
        let Some(path) = self.tape.offset(argument::tolerance(tolerance)?) else { return Ok(JsValue::NULL) };
        let object = js_sys::Object::new();
        set(&object, "xyz", &js_sys::Float64Array::from(path.xyz.as_slice()));
        set(&object, "span", &js_sys::Uint32Array::from(path.span.as_slice()));
        set(&object, "starts", &js_sys::Uint32Array::from(path.starts.as_slice()));
        Ok(object.into())
    }

    /// The axes beyond X, Y and Z against the length of the path; `null` where the format has none.
    #[wasm_bindgen(unchecked_return_type = "OtherAxes | null")]
    pub fn axes(&self) -> JsValue {
        let axes = &self.tape.control().axes[3..];
        if axes.is_empty() {
            return JsValue::NULL;
        }
        let spans = self.tape.spans();
        let (mut length, mut way) = (0.0, Vec::with_capacity(2 * spans.list.len()));
        for span in &spans.list {
            let still = span.start == span.end && span.geometry == nctape::span::Geometry::Line;
            let end = if still { length } else { length + span.length };
            way.extend([length, end]);
            length = end;
        }
        let values: Vec<f64> = spans.beyond().iter().flatten().copied().collect();
        let named = axes.iter().map(|axis| JsValue::from_str(axis.letter.encode_utf8(&mut [0; 4])));
        let rotary = axes.iter().map(|axis| JsValue::from_bool("ABCDE".contains(axis.letter)));
        let object = js_sys::Object::new();
        set(&object, "names", &named.collect::<js_sys::Array>().into());
        set(&object, "rotary", &rotary.collect::<js_sys::Array>().into());
        let turns = self.tape.control().angles() == nctape::format::Angles::Turns;
        set(&object, "angles", &JsValue::from_str(if turns { "turns" } else { "degrees" }));
        set(&object, "lengths", &js_sys::Float64Array::from(way.as_slice()));
        set(&object, "values", &js_sys::Float64Array::from(values.as_slice()));
        object.into()
    }

    /// What has changed of the path since one that was told under the same tolerance, by its number; all of it where
    /// that is too long ago, or where the format or the switch has changed since.
    #[wasm_bindgen(js_name = pathChange, unchecked_return_type = "PathChange")]
    pub fn path_change(
        &mut self,
        #[wasm_bindgen(unchecked_param_type = "number")] tolerance: &JsValue,
        since: u32,
    ) -> Result<JsValue, JsValue> {
        let tolerance = argument::tolerance(tolerance)?;
        let (spans, blocks) = (self.tape.spans().list.len(), self.tape.reading().blocks.len());
        let base = self.told.iter().copied().find(|told| told.number == since && told.tolerance == tolerance);
        let kept = base.map_or(Kept::default(), |told| told.kept);
        // Where nothing was edited, all stands at either end.
        let kept = Kept { last: kept.last.min(spans - kept.first), ..kept };
        let shift = blocks as f64 - base.map_or(blocks, |told| told.blocks) as f64;
        self.paths = self.paths.wrapping_add(1);
        let told = Told { number: self.paths, tolerance, kept: Kept { first: spans, last: spans }, blocks };
        self.told = base.into_iter().chain([told]).collect();
        let object = self.path_of(kept, tolerance);
        change_to_js(&object, self.paths, [kept.first, kept.last], shift);
        Ok(object.into())
    }

    /// The path of the spans between those that are kept.
    fn path_of(&self, kept: Kept, tolerance: f64) -> js_sys::Object {
        let count = self.tape.spans().list.len();
        let range = kept.first..count - kept.last;
        path_to_js(&self.tape.spans().list[range.clone()], &self.tape.points_of(range, tolerance))
    }
}
