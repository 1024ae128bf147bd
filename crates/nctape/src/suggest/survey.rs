//! What a listing shows of its format.

use crate::format::{Control, DIMENSION_LETTERS, Format, Standard, System};
use crate::order::order_by_key;
use crate::read::{NumberFault, Reading, Word, read};

/// One address, or one tab column, and the words under it.
#[derive(Clone, Debug)]
pub(super) struct Seen {
    /// The address; in a T system the one that the column is taken for.
    pub address: u8,
    pub count: usize,
    pub signed: usize,
    pub shortest: u16,
    pub longest: u16,
    /// Words shorter than the longest that begin with 0: they speak against leading zeros left out.
    padded_in_front: usize,
    /// Words that end with 0: they speak against trailing zeros left out.
    padded_behind: usize,
}

impl Seen {
    fn new(address: u8) -> Seen {
        let (shortest, longest) = (u16::MAX, 0);
        Seen { address, count: 0, signed: 0, shortest, longest, padded_in_front: 0, padded_behind: 0 }
    }

    /// A column that no block fills: a dimension is taken to be like the one nearest to it, a function to have the digits
    /// that it has most often.
    fn of_empty_column(address: u8, columns: &[u8], seen: &[Seen]) -> Seen {
        let is_dimension = DIMENSION_LETTERS.contains(char::from(address));
        let place = |letter: u8| columns.iter().position(|&column| column == letter);
        let distance = |other: &&Seen| place(other.address).zip(place(address)).map(|(one, other)| one.abs_diff(other));
        let like = seen.iter().filter(|other| is_dimension && other.is_dimension()).min_by_key(distance);
        let digits = match address {
            b'N' | b'S' => 3,
            b'G' | b'T' | b'M' => 2,
            b'F' => 4,
            _ => 6,
        };
        let (signed, shortest, longest) =
            like.map_or((0, digits, digits), |like| (like.signed, like.shortest, like.longest));
        Seen { signed, shortest, longest, ..Seen::new(address) }
    }

    /// It is the word of a dimension: its letter may be one, and it is longer than a symbol of one digit.
    pub(super) fn is_dimension(&self) -> bool {
        DIMENSION_LETTERS.contains(char::from(self.address)) && (self.longest > 1 || self.signed > 0)
    }

    fn take(&mut self, word: &Word, digits: &str) {
        self.count += 1;
        self.signed += usize::from(word.sign.is_some());
        self.shortest = self.shortest.min(word.digits);
        self.longest = self.longest.max(word.digits);
        // A single zero is how any system says zero.
        let zero = digits.bytes().all(|digit| digit == b'0');
        self.padded_in_front += usize::from(!zero && digits.starts_with('0'));
        self.padded_behind += usize::from(!zero && digits.ends_with('0'));
    }
}

/// What was seen in a listing.
#[derive(Clone, Debug)]
pub(super) struct Survey {
    /// The addresses in the order of the standard.
    pub letters: Vec<Seen>,
    pub system: System,
    /// Most addresses are in lower case.
    pub lower_case: bool,
    /// G02, G03 or G06, or an interpolation parameter.
    pub contours: bool,
    /// I, J or K.
    pub parameters: bool,
    /// G90 or G91.
    pub selects_dimensions: bool,
    /// Every block that cuts has an F, and they differ.
    pub feed_in_every_cut: bool,
    /// Most dimension words have a decimal sign.
    pub decimal_signs: bool,
    /// Digits of the program number behind `%`.
    pub program_number_digits: Option<u8>,
    /// The numbers of each axis in their order, as written, each with its count of digits.
    axes: Vec<Vec<(i64, u16)>>,
    /// Most axes in one block.
    pub axes_at_once: usize,
    /// Where each block ends.
    ends: Vec<usize>,
}

/// The order of the words of a block: 3.2.1 and 3.2.2.
pub(super) const ORDER: &[u8] = b"NGXYZUVWPQRIJKABCDEFSTM";

impl Survey {
    pub(super) fn of(source: &str) -> Survey {
        // A detail without words gives every number its plain value and no address a meaning.
        let reading = read(source, &Control::new(&Format::new(Standard::Iso2539, "*")));
        let words: Vec<&Word> = reading.blocks.iter().flat_map(|block| reading.words(block)).collect();
        let addressed = words.iter().filter(|word| word.address != 0).count();
        let tabs = words.iter().filter(|word| word.tabs > 0).count();
        let system = match (2 * addressed > words.len(), tabs > 0) {
            (true, true) => System::TabAndAddress,
            (false, true) => System::Tab,
            _ => System::Address,
        };
        let mut survey = Survey {
            letters: Vec::new(),
            system,
            lower_case: 2 * words.iter().filter(|word| word.lower_case).count() > words.len(),
            contours: false,
            parameters: false,
            selects_dimensions: false,
            feed_in_every_cut: false,
            decimal_signs: false,
            program_number_digits: None,
            axes: vec![Vec::new(); DIMENSION_LETTERS.len()],
            axes_at_once: 0,
            ends: reading.blocks.iter().map(|block| block.range.end).collect(),
        };
        let dimensions: Vec<&&Word> =
            words.iter().filter(|word| DIMENSION_LETTERS.contains(char::from(word.address))).collect();
        let signs = dimensions.iter().filter(|word| matches!(word.fault, NumberFault::DecimalSign(_))).count();
        survey.decimal_signs = 2 * signs > dimensions.len();
        let columns = if system == System::Tab { columns(&reading, source) } else { Vec::new() };
        survey.take_words(&reading, source, &columns);
        let number = reading.programs().next().map(|mark| &source[mark.number]);
        let digits = number.map_or(0, |number| number.bytes().filter(u8::is_ascii_digit).count());
        survey.program_number_digits = u8::try_from(digits).ok().filter(|digits| (1..=9).contains(digits));
        survey
    }

    fn take_words(&mut self, reading: &Reading, source: &str, columns: &[u8]) {
        let mut cuts = 0;
        let mut feeds: Vec<i64> = Vec::new();
        let mut rapid = false;
        for block in &reading.blocks {
            let mut column = 0;
            let (mut moving, mut feed) = (0, None);
            for word in reading.words(block) {
                column += usize::from(word.tabs);
                let address = if columns.is_empty() { word.address } else { columns.get(column).copied().unwrap_or(0) };
                if address == 0 || word.fault != NumberFault::None {
                    continue;
                }
                let address = if address == b':' { b'N' } else { address };
                let digits: String = source[reading.range(block, word)].chars().filter(char::is_ascii_digit).collect();
                let seen = match self.letters.iter().position(|seen| seen.address == address) {
                    Some(index) => index,
                    None => {
                        self.letters.push(Seen::new(address));
                        self.letters.len() - 1
                    }
                };
                self.letters[seen].take(word, &digits);
                let value = word.value.unwrap_or(0);
                if address == b'G' && matches!(value, 0..=3 | 6) {
                    rapid = value == 0;
                }
                match (address, value) {
                    (b'G', 2 | 3 | 6) => self.contours = true,
                    (b'G', 90 | 91) => self.selects_dimensions = true,
                    (b'F', _) => feed = Some(value),
                    (b'I' | b'J' | b'K', _) => {
                        self.contours = true;
                        self.parameters = true;
                    }
                    _ => {
                        if let Some(axis) = DIMENSION_LETTERS.bytes().position(|letter| letter == address) {
                            self.axes[axis].push((value, word.digits));
                            moving += 1;
                        }
                    }
                }
            }
            self.axes_at_once = self.axes_at_once.max(moving);
            if moving > 0 && !rapid {
                cuts += 1;
                feeds.extend(feed);
            }
        }
        let differ = feeds.iter().any(|feed| *feed != feeds[0]);
        self.feed_in_every_cut = cuts >= 3 && feeds.len() == cuts && differ;
        for &address in columns.iter().filter(|&&address| address != 0) {
            if !self.letters.iter().any(|seen| seen.address == address) {
                self.letters.push(Seen::of_empty_column(address, columns, &self.letters));
            }
        }
        let place = |seen: &Seen| ORDER.iter().position(|&letter| letter == seen.address);
        self.letters.retain(|seen| place(seen).is_some());
        order_by_key(&mut self.letters, |seen| (place(seen).unwrap_or(0), 0));
    }

    /// Some dimension word has words of different length: zeros are left out.
    pub(super) fn shortens(&self) -> bool {
        self.letters.iter().any(|seen| seen.is_dimension() && seen.shortest < seen.longest)
    }

    /// Leading zeros are the ones left out, rather than trailing ones: words padded with zeros in front are fewer than
    /// words padded behind.
    pub(super) fn leading_zeros_omitted(&self) -> bool {
        let dimensions = || self.letters.iter().filter(|seen| seen.is_dimension());
        let in_front: usize = dimensions().map(|seen| seen.padded_in_front).sum();
        let behind: usize = dimensions().map(|seen| seen.padded_behind).sum();
        in_front <= behind
    }

    /// Some dimension word has a sign.
    pub(super) fn signed(&self) -> bool {
        self.letters.iter().any(|seen| seen.is_dimension() && seen.signed > 0)
    }

    /// The interpolation parameters have no signs, though other dimension words have.
    pub(super) fn unsigned_parameters(&self) -> bool {
        let is_parameter = |seen: &&Seen| b"IJK".contains(&seen.address);
        self.signed() && !self.letters.iter().filter(is_parameter).any(|seen| seen.signed > 0)
    }

    /// Some axis has numbers and never a sign.
    pub(super) fn has_unsigned_axis(&self) -> bool {
        let is_axis = |seen: &&Seen| seen.is_dimension() && !b"IJK".contains(&seen.address);
        self.letters.iter().filter(is_axis).any(|seen| seen.signed == 0)
    }

    /// The numbers of each axis in increments: where trailing zeros are left out they are put back.
    pub(super) fn coordinates(&self) -> Vec<Vec<i128>> {
        let trailing = self.shortens() && !self.leading_zeros_omitted();
        let axis = |numbers: &Vec<(i64, u16)>| {
            let longest = numbers.iter().map(|number| number.1).max().unwrap_or(0);
            // A number has at most 18 digits, so that 18 more still fit.
            let zeros = |digits: u16| if trailing { 10i128.pow(u32::from((longest - digits).min(18))) } else { 1 };
            numbers.iter().map(|&(value, digits)| i128::from(value) * zeros(digits)).collect()
        };
        self.axes.iter().map(axis).collect()
    }

    /// The text up to the end of a number of blocks.
    pub(super) fn beginning<'a>(&self, source: &'a str, blocks: usize) -> &'a str {
        self.ends.get(blocks).map_or(source, |&end| &source[..end])
    }
}

/// What the tab columns of a T system are taken for: the sequence number, the preparatory function, then dimensions as
/// long as words are signed or longer than a function, then F, S, T and M from the end.
fn columns(reading: &Reading, source: &str) -> Vec<u8> {
    let mut shapes: Vec<Seen> = Vec::new();
    for block in &reading.blocks {
        let mut column = 0;
        for word in reading.words(block) {
            column += usize::from(word.tabs);
            while shapes.len() <= column {
                shapes.push(Seen::new(0));
            }
            let digits: String = source[reading.range(block, word)].chars().filter(char::is_ascii_digit).collect();
            shapes[column].take(word, &digits);
        }
    }
    let mut letters = vec![0; shapes.len()];
    let mut column = 0;
    if shapes.first().is_some_and(|shape| shape.signed == 0 && shape.longest >= 3) {
        letters[0] = b'N';
        column = 1;
    }
    if shapes.get(column).is_some_and(|shape| shape.signed == 0 && shape.longest == 2) {
        letters[column] = b'G';
        column += 1;
    }
    // Dimension words have signs, all or none of them. Without signs a feed looks like one; but a contour has a
    // dimension word in many blocks, and a feed holds until it is changed.
    let signed = shapes.get(column).is_some_and(|shape| shape.signed > 0);
    let often = |shape: &Seen| 10 * shape.count >= reading.blocks.len();
    let alike =
        |shape: &Seen| if signed { shape.signed > 0 } else { shape.signed == 0 && shape.longest > 2 && often(shape) };
    // In a handful of blocks no word is frequent; there the functions are the columns that are shorter than every
    // dimension before them.
    let first = column;
    let few = reading.blocks.len() < 10;
    let ends = |column: usize| {
        let shortest = shapes[first..column].iter().filter(|shape| shape.count > 0).map(|shape| shape.longest).min();
        let shorter = |shortest: u16| shapes[column..].iter().all(|shape| shape.longest < shortest);
        !signed && few && column + 1 < shapes.len() && shapes[column].count > 0 && shortest.is_some_and(shorter)
    };
    for letter in DIMENSION_LETTERS.bytes().filter(|letter| !b"IJK".contains(letter)) {
        match shapes.get(column) {
            Some(_) if ends(column) => break,
            Some(shape) if shape.count == 0 || alike(shape) => letters[column] = letter,
            _ => break,
        }
        column += 1;
    }
    let rest = &mut letters[column..];
    let names: &[u8] = match rest.len() {
        0 => b"",
        1 => b"M",
        2 => b"FM",
        3 => b"FSM",
        _ => b"FSTM",
    };
    for (slot, name) in rest.iter_mut().zip(names) {
        *slot = *name;
    }
    letters
}
