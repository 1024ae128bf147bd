//! CLDATA that is edited, asked for what is visible, and posted to a tape.
//!
//! An edit is taken at once; the text is read, carried out, checked and posted anew as a whole when something of it is
//! asked for next. A hundred thousand records take less than a second, off the thread of the page.

use crate::argument;
use crate::cldata::{block, reading};
use crate::functions::set;
use crate::live::{BoundsView, Tape};
use crate::offsets::Offsets;
use crate::path::{change_to_js, path_to_js};
use crate::report::{self, BlockView, DiagnosticView, TotalsView};
use crate::value::to_js;
use nctape::cldata::{Cldata as CoreCldata, ElementKind, Options};
use nctape::convert::Converted;
use nctape::post::{self, read_and_post};
use nctape::{Diagnostic, Format, Severity};
use serde::Serialize;
use wasm_bindgen::prelude::*;

/// CLDATA under the format that it is posted to. Every change has a number; offsets are UTF-16 code units.
#[wasm_bindgen]
pub struct Cldata {
    text: String,
    offsets: Offsets,
    format: Format,
    options: Options,
    edit: u32,
    /// What follows from the text, where that was asked for since the last edit.
    read: Option<Read>,
    paths: u32,
}

struct Read {
    cldata: CoreCldata,
    posted: Converted,
    posted_offsets: Offsets,
    /// What was found in reading and in posting, by position.
    found: Vec<Diagnostic>,
}

#[derive(Serialize)]
struct Summary {
    edit: u32,
    unit: &'static str,
    axes: [&'static str; 3],
    blocks: usize,
    spans: usize,
    errors: usize,
    warnings: usize,
    infos: usize,
    totals: TotalsView,
    bounds: Option<BoundsView>,
    incomplete: bool,
}

#[derive(Serialize)]
struct RecordView {
    #[serde(flatten)]
    block: BlockView,
    index: usize,
    span: Option<usize>,
    called: String,
    #[serde(rename = "type")]
    kind: Option<u16>,
    says: String,
    kept: bool,
    statement: Option<StatementView>,
}

#[derive(Serialize)]
struct StatementView {
    record: usize,
    number: Option<i64>,
    identification: String,
    text: Option<String>,
}

#[derive(Serialize)]
struct HeldView {
    position: Option<[f64; 3]>,
    registers: Vec<RegisterView>,
}

#[derive(Serialize)]
struct RegisterView {
    name: &'static str,
    says: String,
    stated: bool,
}

#[wasm_bindgen]
impl Cldata {
    /// Takes a text that is posted to a format.
    #[wasm_bindgen(constructor)]
    pub fn new(
        #[wasm_bindgen(unchecked_param_type = "string")] source: &JsValue,
        #[wasm_bindgen(unchecked_param_type = "Format")] format: &JsValue,
        #[wasm_bindgen(unchecked_optional_param_type = "CldataOptions | null")] options: &JsValue,
    ) -> Result<Cldata, JsValue> {
        let text = argument::text(source, "source")?;
        let (format, _) = argument::format(format)?;
        let options = reading(options)?;
        let offsets = Offsets::new(&text);
        Ok(Cldata { text, offsets, format, options, edit: 0, read: None, paths: 0 })
    }

    /// Replaces the text between two offsets; answers the number of the edit.
    pub fn edit(&mut self, from: u32, to: u32, insert: &str) -> u32 {
        let (range, insert) = self.offsets.edit_in_bytes(&self.text, from, to, insert);
        self.text.replace_range(range.clone(), &insert);
        self.offsets.edit(&self.text, range.start, range.len(), insert.len());
        self.next_edit()
    }

    /// Changes the format that it is posted to; answers the number of the edit.
    #[wasm_bindgen(js_name = setFormat)]
    pub fn set_format(
        &mut self,
        #[wasm_bindgen(unchecked_param_type = "Format")] format: &JsValue,
    ) -> Result<u32, JsValue> {
        self.format = argument::format(format)?.0;
        Ok(self.next_edit())
    }

    fn next_edit(&mut self) -> u32 {
        self.read = None;
        self.edit = self.edit.wrapping_add(1);
        self.edit
    }

    /// What the text holds, in numbers.
    #[wasm_bindgen(unchecked_return_type = "CldataSummary")]
    pub fn summary(&mut self) -> JsValue {
        let (edit, read) = (self.edit, self.read());
        let count = |severity| read.found.iter().filter(|found| found.severity == severity).count();
        let totals = read.cldata.totals();
        to_js(&Summary {
            edit,
            unit: read.cldata.unit().name(),
            axes: ["X", "Y", "Z"],
            blocks: read.cldata.records().len(),
            spans: read.cldata.spans().list.len(),
            errors: count(Severity::Error),
            warnings: count(Severity::Warning),
            infos: count(Severity::Info),
            totals: TotalsView {
                rows: 0,
                tape_millimetres: 0.0,
                cutting: totals.cutting,
                rapid: totals.rapid,
                seconds: totals.seconds,
            },
            bounds: read.cldata.bounds().map(BoundsView::from),
            incomplete: read.posted.is_incomplete(),
        })
    }

    /// The diagnostics that touch a stretch of text, at most `limit`: those of reading and those of posting.
    #[wasm_bindgen(unchecked_return_type = "Diagnostic[]")]
    pub fn diagnostics(&mut self, from: u32, to: u32, limit: u32) -> JsValue {
        self.read();
        let ((from, _), (to, _)) = (self.offsets.byte(from as usize), self.offsets.byte(to as usize));
        let found = self.read.as_ref().map_or(&[][..], |read| &read.found);
        let touching = found.iter().take_while(|found| found.range.start <= to).filter(|found| found.range.end >= from);
        let views: Vec<DiagnosticView> = touching
            .take(limit as usize)
            .map(|found| report::diagnostic(found, self.format.standard, &self.offsets))
            .collect();
        to_js(&views)
    }

    /// Some records in their order.
    #[wasm_bindgen(unchecked_return_type = "RecordView[]")]
    pub fn records(&mut self, first: u32, count: u32) -> JsValue {
        self.read();
        let end = (first as usize).saturating_add(count as usize);
        to_js(&(first as usize..end).map_while(|index| self.view(index)).collect::<Vec<_>>())
    }

    fn view(&self, index: usize) -> Option<RecordView> {
        let cldata = &self.read.as_ref()?.cldata;
        let record = cldata.records().get(index)?;
        let block = block(cldata, record, &self.offsets);
        let called = match &block.sequence {
            Some(number) => format!("record {number}"),
            None => format!("record at place {}", index + 1),
        };
        let statement = cldata.statement(index).map(|statement| StatementView {
            record: statement.record,
            number: statement.number,
            identification: statement.identification.into_owned(),
            text: statement.text.map(std::borrow::Cow::into_owned),
        });
        let spans = cldata.spans_of(index);
        Some(RecordView {
            block,
            index,
            span: (!spans.is_empty()).then_some(spans.start),
            called,
            kind: Some(record.kind).filter(|kind| *kind > 0),
            says: cldata.says(index),
            kept: cldata.is_kept(index),
            statement,
        })
    }

    /// The record at an offset; -1 where there is none.
    #[wasm_bindgen(js_name = recordAt)]
    pub fn record_at(&mut self, offset: u32) -> i32 {
        let (byte, _) = self.offsets.byte(offset as usize);
        self.read().cldata.record_at(byte).map_or(-1, |index| index as i32)
    }

    /// The span at an offset: of the point there where its record has several; -1 where there is none.
    #[wasm_bindgen(js_name = spanAt)]
    pub fn span_at(&mut self, offset: u32) -> i32 {
        let (byte, _) = self.offsets.byte(offset as usize);
        let cldata = &self.read().cldata;
        cldata.record_at(byte).and_then(|record| cldata.span_at(record, byte)).map_or(-1, |span| span as i32)
    }

    /// Where the point stands that a span ends in; `null` beyond the last one.
    #[wasm_bindgen(js_name = endOfSpan, unchecked_return_type = "{ from: number, to: number } | null")]
    pub fn end_of_span(&mut self, span: u32) -> JsValue {
        self.read();
        let Some(cldata) = self.read.as_ref().map(|read| &read.cldata) else { return JsValue::NULL };
        let Some(element) = cldata.end_of_span(span as usize) else { return JsValue::NULL };
        let range = cldata.element_range(element);
        let object = js_sys::Object::new();
        set(&object, "from", &(self.offsets.utf16(range.start) as u32).into());
        set(&object, "to", &(self.offsets.utf16(range.end) as u32).into());
        object.into()
    }

    /// What holds when a record has been carried out; `null` beyond the last one.
    #[wasm_bindgen(unchecked_return_type = "CldataState | null")]
    pub fn state(&mut self, record: u32) -> JsValue {
        let Some(held) = self.read().cldata.held(record as usize) else { return JsValue::NULL };
        let register = |it: nctape::cldata::Register| RegisterView { name: it.name, says: it.says, stated: it.stated };
        to_js(&HeldView { position: held.position, registers: held.registers.into_iter().map(register).collect() })
    }

    /// What the records that touch a stretch of text are made of, for whoever colours it: at most `limit` records.
    #[wasm_bindgen(unchecked_return_type = "Syntax")]
    pub fn syntax(&mut self, from: u32, to: u32, limit: u32) -> JsValue {
        self.read();
        let Some(cldata) = self.read.as_ref().map(|read| &read.cldata) else { return JsValue::NULL };
        let ((from, _), (to, _)) = (self.offsets.byte(from as usize), self.offsets.byte(to as usize));
        let records = cldata.records();
        let unit = |byte: usize| self.offsets.utf16(byte) as u32;
        let first = records.partition_point(|record| cldata.record_range(record).end < from);
        let (mut starts, mut kinds, mut ranges, mut roles) = (Vec::new(), Vec::new(), Vec::new(), Vec::new());
        for (index, record) in records.iter().enumerate().skip(first).take(limit as usize) {
            let range = cldata.record_range(record);
            if range.start > to {
                break;
            }
            starts.push(unit(range.start));
            kinds.push(
                cldata
                    .spans()
                    .list
                    .get(cldata.spans_of(index))
                    .and_then(<[_]>::first)
                    .map_or(0, |span| span.kind.index() as u8 + 1),
            );
            if cldata.is_kept(index) {
                ranges.extend([unit(range.start), unit(range.end)]);
                roles.push(KEPT);
            }
            for (place, element) in cldata.elements(record).iter().enumerate() {
                let role = match (place, element.kind) {
                    (0, ElementKind::Integer) => SEQUENCE,
                    (1, ElementKind::Integer) => TYPE,
                    (_, ElementKind::Keyword) => ADDRESS,
                    (_, ElementKind::Literal) => LITERAL,
                    _ => continue,
                };
                let range = cldata.element_range(element);
                if range.end > range.start {
                    ranges.extend([unit(range.start), unit(range.end)]);
                    roles.push(role);
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

    /// A span; `null` beyond the last one. Its blocks are records.
    #[wasm_bindgen(unchecked_return_type = "Span | null")]
    pub fn span(&mut self, index: u32) -> JsValue {
        let spans = self.read().cldata.spans();
        let index = index as usize;
        if index < spans.list.len() { to_js(&report::span_of(spans, index)) } else { JsValue::NULL }
    }

    /// The flattened path; the tolerance is a length above zero in the unit of the summary.
    #[wasm_bindgen(unchecked_return_type = "Path")]
    pub fn path(
        &mut self,
        #[wasm_bindgen(unchecked_param_type = "number")] tolerance: &JsValue,
    ) -> Result<JsValue, JsValue> {
        let tolerance = argument::tolerance(tolerance)?;
        let cldata = &self.read().cldata;
        Ok(path_to_js(&cldata.spans().list, &cldata.points(tolerance)).into())
    }

    /// The same as a change of the path, as a live tape tells it: all of it is new.
    #[wasm_bindgen(js_name = pathChange, unchecked_return_type = "PathChange")]
    pub fn path_change(
        &mut self,
        #[wasm_bindgen(unchecked_param_type = "number")] tolerance: &JsValue,
    ) -> Result<JsValue, JsValue> {
        let object: js_sys::Object = self.path(tolerance)?.unchecked_into();
        self.paths = self.paths.wrapping_add(1);
        change_to_js(&object, self.paths, [0, 0], 0.0);
        Ok(object.into())
    }

    /// The tape that it became: its text, and four offsets for each stretch of the source that gave something (or
    /// nothing): from and to in the source, from and to in the text.
    #[wasm_bindgen(unchecked_return_type = "{ text: string, map: Uint32Array }")]
    pub fn posted(&mut self) -> JsValue {
        self.read();
        let object = js_sys::Object::new();
        let Some(read) = &self.read else { return object.into() };
        let mut map = Vec::with_capacity(4 * read.posted.map.len());
        for (source, text) in &read.posted.map {
            map.extend([source.start, source.end].map(|byte| self.offsets.utf16(byte) as u32));
            map.extend([text.start, text.end].map(|byte| read.posted_offsets.utf16(byte) as u32));
        }
        set(&object, "text", &JsValue::from_str(&read.posted.text));
        set(&object, "map", &js_sys::Uint32Array::from(map.as_slice()));
        object.into()
    }

    /// The tape that it became, as a live tape under the format.
    #[wasm_bindgen(js_name = postedTape)]
    pub fn posted_tape(&mut self) -> Tape {
        self.read();
        let text = self.read.as_ref().map_or("", |read| &read.posted.text);
        Tape::of(text, &self.format, false)
    }
}

/// The roles of [`Cldata::syntax`]; the first two are those of a tape.
const ADDRESS: u8 = 0;
const SEQUENCE: u8 = 1;
const TYPE: u8 = 2;
const LITERAL: u8 = 3;
const KEPT: u8 = 4;

impl Cldata {
    /// What follows from the text.
    fn read(&mut self) -> &Read {
        let Cldata { text, format, options, read, .. } = self;
        read.get_or_insert_with(|| {
            let posting = post::Options { reading: *options, ..post::Options::default() };
            let (cldata, posted) = read_and_post(text, format, &posting);
            let mut found = [cldata.diagnostics(), &posted.diagnostics].concat();
            found.sort_by_key(|found| (found.range.start, found.range.end));
            Read { cldata, posted_offsets: Offsets::new(&posted.text), posted, found }
        })
    }
}
