//! What a replay asks of the live tape: the way of the blocks through the control, and its registers.

use crate::functions::set;
use crate::live::Tape;
use crate::value::to_js;
use nctape::{Dwelling, Modal, Named, Rate, Registers};
use serde::Serialize;
use wasm_bindgen::prelude::*;

#[derive(Serialize)]
struct RegistersView {
    block: usize,
    fate: &'static str,
    program: Option<String>,
    sequence: Option<String>,
    modal: Vec<ModalView>,
    once: Vec<NamedView>,
    stop: Option<NamedView>,
    dwell: Option<DwellView>,
    position: Vec<f64>,
    doubtful: Vec<bool>,
    feed: Option<RateView>,
    leads: Option<[f64; 3]>,
    speed: Option<RateView>,
    spindle: Option<SpindleView>,
    coolant: Option<CoolantView>,
    tool: Option<ToolView>,
    compensation: Option<String>,
    others: Vec<OtherView>,
}

#[derive(Serialize)]
struct NamedView {
    code: String,
    meaning: String,
    group: &'static str,
    acts: String,
    conflict: Option<&'static str>,
}

#[derive(Serialize)]
struct ModalView {
    group: &'static str,
    code: Option<String>,
    meaning: String,
    acts: String,
    conflict: Option<&'static str>,
    stated: bool,
}

#[derive(Serialize)]
#[serde(rename_all = "camelCase")]
struct RateView {
    word: String,
    per_minute: Option<f64>,
}

#[derive(Serialize)]
struct DwellView {
    word: String,
    seconds: Option<f64>,
}

#[derive(Serialize)]
struct SpindleView {
    turns: &'static str,
    #[serde(flatten)]
    function: NamedView,
}

#[derive(Serialize)]
struct CoolantView {
    on: bool,
    #[serde(flatten)]
    function: NamedView,
}

#[derive(Serialize)]
struct OtherView {
    address: char,
    word: Option<String>,
}

#[derive(Serialize)]
struct ToolView {
    word: String,
    change: Option<NamedView>,
}

fn named(Named { code, meaning, group, acts, conflict }: Named) -> NamedView {
    NamedView { code, meaning, group, acts, conflict }
}

fn modal(Modal { group, function, stated }: Modal) -> ModalView {
    let code = function.as_ref().map(|named| named.code.clone());
    let (meaning, acts, conflict) = function.map_or_else(Default::default, |it| (it.meaning, it.acts, it.conflict));
    ModalView { group: group.title(), code, meaning, acts, conflict, stated }
}

fn rate(Rate { word, per_minute }: Rate) -> RateView {
    RateView { word, per_minute }
}

fn view(block: usize, held: Registers) -> RegistersView {
    RegistersView {
        block,
        fate: held.fate.name(),
        program: held.program,
        sequence: held.sequence,
        modal: held.modal.into_iter().map(modal).collect(),
        once: held.once.into_iter().map(named).collect(),
        stop: held.stop.map(named),
        dwell: held.dwell.map(|Dwelling { word, seconds }| DwellView { word, seconds }),
        position: held.position,
        doubtful: held.doubtful,
        feed: held.feed.map(rate),
        leads: held.leads,
        speed: held.speed.map(rate),
        spindle: held
            .spindle
            .map(|(turning, function)| SpindleView { turns: turning.name(), function: named(function) }),
        coolant: held.coolant.map(|(on, function)| CoolantView { on, function: named(function) }),
        compensation: held.compensation,
        others: held.others.into_iter().map(|(address, word)| OtherView { address, word }).collect(),
        tool: held.tool.map(|(word, change)| ToolView { word, change: change.map(named) }),
    }
}

#[wasm_bindgen]
impl Tape {
    /// What the control holds behind a block; `null` beyond the last one.
    #[wasm_bindgen(unchecked_return_type = "Registers | null")]
    pub fn registers(&self, block: u32) -> JsValue {
        let block = block as usize;
        self.tape.registers(block).map_or(JsValue::NULL, |held| to_js(&view(block, held)))
    }

    /// What the control holds behind each of some blocks: many cost little more than one.
    #[wasm_bindgen(js_name = registersOf, unchecked_return_type = "Registers[]")]
    pub fn registers_of(&self, first: u32, count: u32) -> JsValue {
        let first = first as usize;
        let held = self.tape.registers_of(first..first.saturating_add(count as usize));
        to_js(&held.into_iter().enumerate().map(|(index, held)| view(first + index, held)).collect::<Vec<_>>())
    }

    /// How the tape passes through the control, block by block.
    #[wasm_bindgen(unchecked_return_type = "Course")]
    pub fn course(&self) -> JsValue {
        let course = self.tape.course();
        let spans = &self.tape.spans().list;
        let rows: Vec<u32> =
            course.steps.iter().flat_map(|step| [step.rows.start as u32, step.rows.end as u32]).collect();
        let seconds: Vec<f64> = course.steps.iter().map(|step| step.seconds).collect();
        let ends: Vec<u32> = course.steps.iter().map(|step| step.spans.end as u32).collect();
        let fates: Vec<u8> = course.steps.iter().map(|step| step.fate.index() as u8).collect();
        let stops: Vec<u8> = course.steps.iter().map(|step| step.stop.index() as u8).collect();
        let kinds: Vec<u8> = spans.iter().map(|span| span.kind.index() as u8 + 1).collect();
        let object = js_sys::Object::new();
        set(&object, "rows", &js_sys::Uint32Array::from(rows.as_slice()));
        set(&object, "seconds", &js_sys::Float64Array::from(seconds.as_slice()));
        set(&object, "spanEnds", &js_sys::Uint32Array::from(ends.as_slice()));
        set(&object, "fates", &js_sys::Uint8Array::from(fates.as_slice()));
        set(&object, "stops", &js_sys::Uint8Array::from(stops.as_slice()));
        set(&object, "spanSeconds", &js_sys::Float64Array::from(course.span_seconds.as_slice()));
        set(&object, "spanKinds", &js_sys::Uint8Array::from(kinds.as_slice()));
        set(&object, "assumed", &(course.assumed as f64).into());
        set(&object, "note", &course.note.map_or(JsValue::NULL, JsValue::from));
        set(&object, "readerSpeed", &course.reader_speed.into());
        object.into()
    }
}
