//! Random edits of a tape where edits are awkward: inside CR LF, `*` with a line end, words, comments and surrogate
//! pairs; parentheses that open and close; whole stretches that go.

/// Numbers without a pattern that are the same in every run: SplitMix64 (Steele, Lea and Flood, 2014).
pub struct Numbers(u64);

impl Numbers {
    pub fn new(seed: u64) -> Numbers {
        Numbers(seed)
    }

    pub fn next(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9E37_79B9_7F4A_7C15);
        let mut mixed = self.0;
        mixed = (mixed ^ (mixed >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
        mixed = (mixed ^ (mixed >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
        mixed ^ (mixed >> 31)
    }

    /// A number below a limit.
    pub fn below(&mut self, limit: usize) -> usize {
        (self.next() % limit.max(1) as u64) as usize
    }

    pub fn one_of<T: Copy>(&mut self, choices: &[T]) -> T {
        choices[self.below(choices.len())]
    }
}

const PIECES: &[&str] = &[
    "\n",
    "\r\n",
    "\r",
    "*",
    "*\n",
    "*\r\n",
    "\n\n",
    "(",
    ")",
    "()",
    "(A)",
    "(\u{1F600})",
    "%",
    "%12",
    "/",
    "\t",
    " ",
    ":",
    "+",
    "-",
    ".",
    "O",
    "5",
    "00",
    "X",
    "N",
    "G02",
    "G03 X+010000 Y+005000 I+005000 J+000000",
    "N007 G01 X+001000 F0300\n",
    "N008 G02 X+020000 Y+010000\nN009 X+030000 Y+000000\n",
    "G91",
    "G90",
    "G06",
    "M30",
    "M02\n",
    "M30\n%\n",
    "T05 M06",
    "F0",
    "\u{2212}",
    "\u{1F600}",
    "\u{0}",
    "x+000100",
    "/N010 X+001000\n",
    "(N011 G01\nN012 X+005000\n)",
    "1.5",
];

/// An edit of a text in UTF-16 code units: from, to, insert. It may fall between the halves of a surrogate pair.
pub fn edit(numbers: &mut Numbers, length: usize) -> (usize, usize, &'static str) {
    let from = numbers.below(length + 1);
    let removed = match numbers.below(12) {
        0..6 => 0,
        6..9 => 1,
        9 => 2,
        10 => numbers.below(30),
        _ => numbers.below(length / 4 + 2),
    };
    let insert = if removed > 0 && numbers.below(2) == 0 { "" } else { numbers.one_of(PIECES) };
    (from, (from + removed).min(length), insert)
}

/// A tape of blocks with a little of everything, long enough for an open comment to swallow many.
pub fn tape(blocks: usize) -> String {
    let mut text = String::from("(LEADER)\r\n%\n");
    for index in 1..blocks {
        let line = match index % 11 {
            0 => format!("N{index:03} G02 X+{index:06} Y+000000 I+000500 J+000000\r\n"),
            3 => format!("N{index:03} (PART {index}) G01 X+{:06} F0300*\n", index * 7),
            5 => format!("/N{index:03} Y+{:06}*", index * 3),
            7 => format!("N{index:03} G06 X+{index:06} Y+001000\nX+{:06} Y+000000\n", index + 900),
            9 => format!("N{index:03} X{index} (\u{1F600}\n)\n"),
            _ => format!("N{index:03} G01 X+{:06} Y-{index:06} F0200\n", index * 5),
        };
        text.push_str(&line);
    }
    text.push_str("N999 M30\n");
    text
}
