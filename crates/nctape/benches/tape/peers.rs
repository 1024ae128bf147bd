//! Two parsers of today's G-code, each used as its own documentation does. Each answers with the lines and words that
//! it read, the sequence numbers included.

use gcode::core::{
    BlockVisitor, CommandVisitor, ControlFlow, HasDiagnostics, Noop, Number, ProgramVisitor, Span, Value,
};
use nom_gcode::{GCodeLine, parse_gcode};

/// `nom-gcode`: line by line, nothing kept.
pub fn nom_gcode(source: &str) -> (usize, usize) {
    let mut read = (0, 0);
    for line in source.lines() {
        if let Ok(("", Some(GCodeLine::GCode(line)))) = parse_gcode(line) {
            read.0 += 1;
            read.1 += 1 + usize::from(line.line_number.is_some()) + line.arguments().count();
        }
    }
    read
}

/// `gcode`: the program as a tree.
pub fn gcode_tree(source: &str) -> (usize, usize) {
    let Ok(program) = gcode::parse(source) else { return (0, 0) };
    let mut read = (0, 0);
    for block in &program.blocks {
        read.0 += 1;
        read.1 += usize::from(block.line_number.is_some()) + block.word_addresses.len();
        read.1 += block.codes.iter().map(|code| 1 + arguments(code).len()).sum::<usize>();
    }
    read
}

/// `gcode` without a tree: it tells of what it reads, and nothing is kept.
pub fn gcode_visited(source: &str) -> (usize, usize) {
    let mut counter = Counter::default();
    gcode::core::parse(source, &mut counter);
    (counter.lines, counter.words)
}

/// The X of each block as `gcode` reads it.
#[allow(dead_code, reason = "the test alone asks for it")]
pub fn gcode_x(source: &str) -> Vec<f32> {
    let program = gcode::parse(source).unwrap_or_default();
    let codes = program.blocks.iter().flat_map(|block| &block.codes).flat_map(arguments);
    codes
        .filter_map(|argument| match argument.value {
            gcode::Value::Literal(x) if argument.letter == 'X' => Some(x),
            _ => None,
        })
        .collect()
}

fn arguments(code: &gcode::Code) -> &[gcode::Argument] {
    match code {
        gcode::Code::General(code) => &code.args,
        gcode::Code::Miscellaneous(code) => &code.args,
        gcode::Code::ToolChange(code) => &code.args,
        _ => &[],
    }
}

#[derive(Default)]
struct Counter {
    lines: usize,
    words: usize,
    silent: Noop,
}

struct Each<'a>(&'a mut Counter);

impl HasDiagnostics for Counter {
    fn diagnostics(&mut self) -> &mut dyn gcode::core::Diagnostics {
        &mut self.silent
    }
}

impl HasDiagnostics for Each<'_> {
    fn diagnostics(&mut self) -> &mut dyn gcode::core::Diagnostics {
        &mut self.0.silent
    }
}

impl ProgramVisitor for Counter {
    fn start_block(&mut self) -> ControlFlow<impl BlockVisitor + '_> {
        self.lines += 1;
        ControlFlow::Continue(Each(self))
    }
}

impl Each<'_> {
    fn word(&mut self) -> ControlFlow<Each<'_>> {
        self.0.words += 1;
        ControlFlow::Continue(Each(self.0))
    }
}

impl BlockVisitor for Each<'_> {
    fn line_number(&mut self, _number: u32, _span: Span) {
        self.0.words += 1;
    }

    fn word_address(&mut self, _letter: char, _value: Value<'_>, _span: Span) {
        self.0.words += 1;
    }

    fn start_general_code(&mut self, _number: Number) -> ControlFlow<impl CommandVisitor + '_> {
        self.word()
    }

    fn start_miscellaneous_code(&mut self, _number: Number) -> ControlFlow<impl CommandVisitor + '_> {
        self.word()
    }

    fn start_tool_change_code(&mut self, _number: Number) -> ControlFlow<impl CommandVisitor + '_> {
        self.word()
    }
}

impl CommandVisitor for Each<'_> {
    fn argument(&mut self, _letter: char, _value: Value<'_>, _span: Span) {
        self.0.words += 1;
    }
}
