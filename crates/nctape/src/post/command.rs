//! The words of ISO 4343 that a tape knows.

use super::posting::Poster;
use crate::cldata::Key;
use crate::cldata::command::Argument;
use crate::cldata::step::Step;
use crate::format::Unit;
use crate::rules::posting as rules;

impl Poster<'_> {
    /// A command; `moves`: there is a motion behind it in its file.
    pub(super) fn command(&mut self, step: &Step, word: Key, arguments: &[Argument], moves: bool) {
        let place = self.source.record(step.record);
        let named = word.word();
        let has = |word: &str| arguments.contains(&Argument::Word(Key::of(word)));
        let number = arguments.iter().find_map(|argument| match argument {
            Argument::Number(number) => Some(*number),
            _ => None,
        });
        match named.as_str() {
            // What they say is in the steps, or is for no tape.
            "RAPID" | "FEDRAT" | "UNITS" | "MULTAX" | "MACHIN" | "DISPLY" => {}
            "PARTNO" | "PPRINT" => {
                let text = self.source.literals(step.record);
                self.writer.comment(&text);
            }
            "SPINDL" => self.spindle(step, arguments),
            "COOLNT" => self.coolant(step, arguments),
            "LOADTL" | "SELCTL" | "TOOLNO" | "TURRET" => self.tool(step, &named, arguments),
            "CUTCOM" => self.compensation(step, arguments),
            "DELAY" => self.delay(step, arguments),
            "CYCLE" => self.cycle(step, arguments),
            "STOP" | "OPSTOP" => {
                let written = self.writer.function('M', u8::from(named == "OPSTOP"));
                self.take(written, place);
                self.state.machine.stopped();
            }
            "END" if moves => {
                let message = "The machine run ends here, and the text goes on with motions: the tape stops (M00), as \
                               nothing behind M02 or M30 would be carried out.";
                self.report(&rules::part_left_out::RULE, "", place.clone(), message.to_owned());
                let written = self.writer.function('M', 0);
                self.take(written, place);
                self.state.machine = super::machine::Machine::default();
            }
            "END" => self.state.end = Some(step.record),
            "REWIND" if !moves => self.state.rewinds = true,
            "INSERT" => self.insert(step),
            "AUXFUN" | "PREFUN" => self.function(step, &named, number),
            "SEQNO" => self.sequence(arguments, number),
            "OPSKIP" if has("ON") || has("OFF") => self.skip(step, has("ON")),
            "LEADER" => self.leader(step, number),
            "CLEARP" | "CLRSRF" if number.is_some() && !has("YZPLAN") && !has("ZXPLAN") => {
                self.state.clearance = number.map(|number| self.length(number * step.scale));
            }
            "RETRCT" if self.state.clearance.is_some() => {
                let [x, y, z] = std::array::from_fn(|axis| self.writer.position(axis));
                self.rapid([x, y, self.state.clearance.unwrap_or(z)], place);
            }
            // A place where the machine may begin: the alignment function (B.2), which says all that is in force.
            "TMARK" => {
                self.writer.align();
                self.state.unsaid = [true; 3];
            }
            "INDEX" | "COPY" | "TRACUT" => {
                let message = format!(
                    "{named} is passed over, and the points are taken as they stand: the processor that wrote them is \
                     taken to have carried it out, as APT does. If it has not, this tape cuts elsewhere."
                );
                self.report(&rules::part_left_out::RULE, "", place, message);
            }
            _ => {
                let message = format!("{named} is nothing that this post-processor knows how to say on a tape.");
                self.lack(&rules::command_not_posted::RULE, "", place, message);
            }
        }
    }

    /// INSERT: text that goes to the tape as it stands.
    fn insert(&mut self, step: &Step) {
        let place = self.source.record(step.record);
        let text = self.source.literals(step.record);
        let text = text.trim();
        if text.is_empty() {
            return;
        }
        let message = "This text goes to the tape as it stands, and what it does is not followed: the blocks behind it \
                       say anew what is in force, and count on the tool being where it was.";
        self.report(&rules::text_as_it_stands::RULE, "", place, message.to_owned());
        self.writer.verbatim(text);
        self.state.machine.stopped();
        self.state.unsaid = [true; 3];
    }

    /// AUXFUN and PREFUN: a function by its number.
    fn function(&mut self, step: &Step, named: &str, number: Option<f64>) {
        let place = self.source.record(step.record);
        let code = number.filter(|code| code.fract() == 0.0 && (0.0..=99.0).contains(code)).map(|code| code as u8);
        let Some(code) = code else {
            let message = format!("{named} wants the number of a function, from 0 to 99.");
            self.lack(&rules::command_not_posted::RULE, "", place, message);
            return;
        };
        // What the tape writer sets itself: motions, planes, threads, cycles, dimensions, registers, kinds of feed.
        if named == "PREFUN" && matches!(code, 0..=3 | 6 | 17..=19 | 33..=35 | 80..=95) {
            let message = format!("G{code:02} is set by what the other records say, and not by itself.");
            self.lack(&rules::command_not_posted::RULE, "", place, message);
            return;
        }
        let written = self.writer.function(if named == "PREFUN" { 'G' } else { 'M' }, code);
        self.take(written, place);
        if named == "AUXFUN" && matches!(code, 0 | 1 | 5 | 9 | 19) {
            self.state.machine.stopped();
        }
    }

    /// SEQNO: from which number on the blocks are numbered, by which steps, and whether at all.
    fn sequence(&mut self, arguments: &[Argument], number: Option<f64>) {
        let whole = |number: f64| (number.fract() == 0.0 && (1.0..1e9).contains(&number)).then_some(number as i64);
        let numbering = &mut self.writer.numbering;
        let mut increment = false;
        for argument in arguments {
            match argument {
                Argument::Word(key) => {
                    increment = *key == Key::of("INCR");
                    match key.word().as_str() {
                        "OFF" => numbering.on = false,
                        "ON" => numbering.on = true,
                        _ => {}
                    }
                }
                Argument::Number(step) if increment => numbering.step = whole(*step).unwrap_or(numbering.step),
                _ => {}
            }
        }
        let starts = matches!(arguments.first(), Some(Argument::Number(_)));
        if let Some(first) = number.filter(|_| starts).and_then(whole) {
            (numbering.next, numbering.first, numbering.on) = (first, first, true);
        }
    }

    /// OPSKIP: the blocks up to its OFF may be skipped.
    fn skip(&mut self, step: &Step, on: bool) {
        let at: [f64; 3] = std::array::from_fn(|axis| self.writer.position(axis));
        self.writer.skip = on;
        // Whether they were carried out nobody knows: what they said is said again.
        self.writer.forget();
        self.state.unsaid = [true; 3];
        if on {
            self.state.skip_start.get_or_insert(at);
            return;
        }
        let moved = self.state.skip_start.take().is_some_and(|start| start != at);
        if moved && (0..3).any(|axis| self.writer.is_incremental(axis)) {
            let message = "The blocks between OPSKIP,ON and here move the tool, and the dimensions are incremental: \
                           where they are skipped, all that follows is cut elsewhere.";
            let place = self.source.record(step.record);
            self.report(&rules::skip_displaces::RULE, "", place, message.to_owned());
        }
    }

    /// LEADER: blank tape, which has rows and no characters, so that no tape text can hold it.
    fn leader(&mut self, step: &Step, number: Option<f64>) {
        let place = self.source.record(step.record);
        let inch = self.source.cldata.unit() == Unit::Inch;
        let millimetres = number.unwrap_or(0.0) * step.scale * if inch { 25.4 } else { 1.0 };
        let rows = (millimetres / crate::ROW_PITCH_MILLIMETRES).ceil();
        let message = format!(
            "Blank tape has feed holes and no characters, so that it is not in the text of the tape: {rows} rows are \
             asked for here. Set them when the tape is punched."
        );
        self.report(&rules::leader_not_in_text::RULE, "", place, message);
    }

    /// Millimetres in the unit of the format.
    pub(super) fn millimetres(&self, value: f64) -> f64 {
        if self.control.unit == Unit::Inch { value / 25.4 } else { value }
    }
}
