//! CLDATA (ISO 3592) as a script sees it: records are blocks, elements are words.

use crate::argument::{self, malformed};
use crate::offsets::Offsets;
use crate::report::{self, API, BlockView, ReportView, TotalsView, WordView};
use crate::value::{from_js, to_js};
use nctape::Standard;
use nctape::cldata::{Cldata, Dialect, Options, Record, apt};
use nctape::format::value::Value;
use serde::Serialize;
use wasm_bindgen::prelude::*;

/// The most columns that a record may have.
const MOST_COLUMNS: f64 = 1000.0;

/// Reads, executes and checks CLDATA.
#[wasm_bindgen(js_name = checkCldata, unchecked_return_type = "Report")]
pub fn check_cldata(
    #[wasm_bindgen(unchecked_param_type = "string")] source: &JsValue,
    #[wasm_bindgen(unchecked_optional_param_type = "CldataOptions | null")] options: &JsValue,
) -> Result<JsValue, JsValue> {
    let source = argument::text(source, "source")?;
    let wanted = argument::options(options)?;
    let cldata = Cldata::new(&source, &reading(options)?);
    let offsets = Offsets::new(&source);
    let found = cldata.diagnostics();
    let shown = &found[..found.len().min(wanted.limit)];
    let records = &cldata.records()[..if wanted.blocks { cldata.records().len() } else { 0 }];
    let spans = if wanted.spans { cldata.spans().list.len() } else { 0 };
    let totals = cldata.totals();
    Ok(to_js(&ReportView {
        api: API,
        unit: cldata.unit().name(),
        axes: ["X", "Y", "Z"].map(str::to_owned).to_vec(),
        // The clauses of ISO 3592 are the same whatever a tape is to follow.
        diagnostics: shown.iter().map(|found| report::diagnostic(found, Standard::Iso2539, &offsets)).collect(),
        suppressed: found.len() - shown.len(),
        blocks: records.iter().map(|record| block(&cldata, record, &offsets)).collect(),
        spans: (0..spans).map(|index| report::span_of(cldata.spans(), index)).collect(),
        totals: TotalsView {
            rows: 0,
            tape_millimetres: 0.0,
            cutting: totals.cutting,
            rapid: totals.rapid,
            seconds: totals.seconds,
        },
    }))
}

#[derive(Serialize)]
struct TranslatedView {
    text: String,
    faults: Vec<FaultView>,
    map: Vec<[usize; 4]>,
}

#[derive(Serialize)]
struct FaultView {
    from: usize,
    to: usize,
    message: String,
}

/// The CL text of a CAM system (`GOTO / 1.0, 2.0, 3.0`) in the reference language. It is no part of ISO 3592; what is no
/// statement is kept in a 1000 record and said.
#[wasm_bindgen(js_name = clTextToCldata, unchecked_return_type = "TranslatedClText")]
pub fn cl_text_to_cldata(
    #[wasm_bindgen(unchecked_param_type = "string")] source: &JsValue,
) -> Result<JsValue, JsValue> {
    let source = argument::text(source, "source")?;
    let found = apt::translate(&source);
    let (from, to) = (Offsets::new(&source), Offsets::new(&found.text));
    let fault = |fault: apt::Fault| FaultView {
        from: from.utf16(fault.range.start),
        to: from.utf16(fault.range.end),
        message: fault.message,
    };
    let map = found.map.iter().map(|(statement, records)| {
        [from.utf16(statement.start), from.utf16(statement.end), to.utf16(records.start), to.utf16(records.end)]
    });
    let map = map.collect();
    Ok(to_js(&TranslatedView { faults: found.faults.into_iter().map(fault).collect(), map, text: found.text }))
}

/// How the text is to be read.
pub(crate) fn reading(options: &JsValue) -> Result<Options, JsValue> {
    let mut reading = Options::default();
    if options.is_undefined() || options.is_null() {
        return Ok(reading);
    }
    let options = from_js(options);
    reading.columns = match options.get("columns") {
        None => None,
        Some(Value::Number(columns)) if (1.0..=MOST_COLUMNS).contains(columns) && columns.fract() == 0.0 => {
            Some(*columns as usize)
        }
        Some(_) => return Err(malformed("columns", "a whole number from 1 to 1000 is wanted")),
    };
    reading.dialect = match options.get("dialect") {
        None => None,
        Some(Value::Text(word)) if Dialect::from_word(word).is_some() => Dialect::from_word(word),
        Some(_) => {
            let words: Vec<&str> = Dialect::ALL.iter().map(|choice| choice.1).collect();
            return Err(malformed("dialect", &format!("one of {} is wanted", words.join(", "))));
        }
    };
    Ok(reading)
}

/// A record with its elements. The address of a keyword is the keyword; numbers and literals have none.
pub(crate) fn block(cldata: &Cldata, record: &Record, offsets: &Offsets) -> BlockView {
    let units = |range: &std::ops::Range<usize>| (offsets.utf16(range.start), offsets.utf16(range.end));
    let elements = cldata.elements(record);
    let words = elements.iter().map(|element| {
        let (from, to) = units(&cldata.element_range(element));
        let address = element.key().map_or(String::new(), |_| cldata.keyword(element));
        WordView { address, from, to, value: element.value() }
    });
    let number = elements.first().filter(|element| element.value().is_some());
    let (from, to) = units(&cldata.record_range(record));
    BlockView {
        from,
        to,
        sequence: number.map(|number| cldata.text()[cldata.element_range(number)].to_owned()),
        words: words.collect(),
    }
}
