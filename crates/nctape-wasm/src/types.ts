export type Standard = "iso2539" | "iso1058" | "rs274";

/** The format specification of a control: what the tape is read against. */
export interface Format {
  standard: Standard;
  /** Annex C, "CSM 432"; EIA: "c23.313.22". */
  classification?: string;
  /** Annex D, "N3.G2.X+42.Y+32.Z+32.B1.F4.S3.T2.M2*"; EIA: "n3 g2 x+14 y+14 f21 m2*". */
  detail: string;
  /** What the standard leaves to the builder; every field has a default. */
  itemized?: Itemized;
}

export interface Itemized {
  code?: "iso" | "eia";
  dimensions?: "absolute" | "incremental";
  setPoint?: number[] | Record<string, number>;
  plane?: "xy" | "zx" | "yz";
  arcParameters?: "centre" | "angle-radius";
  arcCentre?: "as-dimensions" | "from-start" | "to-start" | "absolute" | "quadrant";
  parabolaParameters?: "tangent" | "slope" | "focus";
  helix?: boolean;
  fullCircle?: boolean;
  curves?: Record<string, "cubic">;
  feed?: "time-reciprocal" | "arithmetic" | "geometric" | "symbolic" | "direct";
  spindle?: "arithmetic" | "geometric" | "symbolic" | "direct";
  feedUnit?: "per-minute" | "per-revolution";
  arcFeed?: "radians" | "time";
  timeScale?: 1 | 10;
  symbolicFeeds?: Record<string, number>;
  symbolicSpeeds?: Record<string, number>;
  decimalShift?: number;
  rapid?: number;
  maximumFeed?: number;
  travel?: Record<string, [number, number]>;
  dwell?: { address: string; unit: "seconds" | "revolutions" };
  compensation?: boolean;
  compensationVector?: "normal" | "tangent";
  cutterRadius?: number;
  compensationDigits?: number;
  programNumberDigits?: number;
  endOfBlock?: "lf" | "cr";
  declared?: { G?: Record<string, string>; M?: Record<string, string>; letters?: Record<string, string> };
  readerSpeed?: number;
  buffered?: boolean;
}

export interface CheckOptions {
  /** The optional block skip switch: off. */
  skip?: boolean;
  /** Return the blocks: true. */
  blocks?: boolean;
  /** Return the spans: true. */
  spans?: boolean;
  /** Diagnostics returned: 1000. */
  limit?: number;
}

/** How CLDATA is to be read, and what of it is returned. `skip` does not apply. */
export interface CldataOptions extends CheckOptions {
  /** Read as records of so many columns, 1 to 1000: a literal goes on in the first column of the next line, and text behind the last column is not read. Left out: as a stream. */
  columns?: number;
  /** Whose integer codes hold in records of type 2000: "common". */
  dialect?: "common" | "apt360" | "ssv3" | "postworks" | "ncl" | "ibm";
}

export type Severity = "error" | "warning" | "info";

export interface Edit { from: number; to: number; insert: string }
export interface Related { from: number; to: number; message: string }
/** `kind`: once the edits are made, the text is to be read in that language instead. */
export interface Fix { title: string; edits?: Edit[]; format?: Format; kind?: SourceKind }
/** A text is a tape, or the CLDATA that a tape is made of. */
export type SourceKind = "tape" | "cldata";

/** Offsets are UTF-16 code units into the string as given; line and column count from 1. */
export interface Diagnostic {
  rule: string;
  name: string;
  severity: Severity;
  from: number;
  to: number;
  line: number;
  column: number;
  /** How often, where it is said once. */
  count: number;
  message: string;
  clauses: string[];
  related?: Related[];
  fixes?: Fix[];
}

/** Of CLDATA it is an element: the address of a keyword is the keyword, numbers and literals have none. */
export interface WordInfo { address: string; from: number; to: number; value: number | null }
/** Of CLDATA it is a record. */
export interface Block { from: number; to: number; sequence: string | null; words: WordInfo[] }

export type Plane = "xy" | "zx" | "yz";
export interface Span {
  kind: "rapid" | "line" | "arc" | "parabola" | "curve" | "dwell";
  /** First and last block. */
  blocks: [number, number];
  start: number[];
  end: number[];
  plane?: Plane;
  centre?: number[];
  /** Radians, counter-clockwise positive, seen from the positive third axis of the plane. */
  sweep?: number;
  /** Parabola: the tangent intersection point. */
  tangent?: number[];
  /** Curve: the two control points between its ends, as of a Bézier cubic. */
  control?: number[][];
  /**
   * Along X, Y and Z; where those stand still, along the axes parallel to them (U, V, W, P, Q, R); of a rotary axis that
   * moves alone, in turns or degrees; 0 of a dwell, and of nothing else.
   */
  length: number;
  /** Unit per minute along the path; turns or degrees per minute of a rotary axis that moves alone. */
  feed: number | null;
  seconds: number | null;
  /** A stand-in for what could not be computed. */
  substitute?: true;
}

export interface Totals {
  rows: number;
  tapeMillimetres: number;
  cutting: number;
  rapid: number;
  /** Without reader time; null if a moving span has no known time. */
  seconds: number | null;
}

export interface Report {
  api: 1;
  unit: "mm" | "inch";
  /** "X", "Y", "Z" first, then the format's other dimension axes. */
  axes: string[];
  diagnostics: Diagnostic[];
  /** Diagnostics beyond the limit. */
  suppressed: number;
  blocks: Block[];
  spans: Span[];
  totals: Totals;
}

export interface ClassificationInfo {
  text: string;
  /** "A", "T" or "S"; null where the shorthand does not say. */
  system: string | null;
  unit: "mm" | "inch" | null;
  angles: "turns" | "degrees" | null;
  motions: number | null;
  dimensionMotions: number | null;
  simultaneousMotions: number | null;
}
export interface DetailWord {
  address: string;
  from: number;
  to: number;
  tab: boolean;
  dimension: boolean;
  /** "absolute-positive", "absolute", "incremental", "both"; null for a word that is no dimension. */
  sign: string | null;
  before: number;
  after: number;
  zeros: "all" | "leading-omitted" | "trailing-omitted";
}
export interface FormatExplanation {
  classification: ClassificationInfo | null;
  detail: { words: DetailWord[]; endsWithAsterisk: boolean } | null;
  sentences: string[];
  /** `path`: "classification", "detail", "itemized.feed" …; offsets into that field's string. */
  diagnostics: (Diagnostic & { path: string })[];
}

/** A format that fits a listing: what the listing says itself, what was assumed, and the errors that remain. */
export interface Suggestion { format: Format; sure: string[]; assumed: string[]; errors: number }

export interface Rule {
  rule: string;
  aliases: string[];
  name: string;
  family: string;
  title: string;
  /** On a tape by its standard; of a rule on CLDATA `iso3592`. */
  severity: Record<Standard, Severity | null> & { iso3592?: Severity };
  clauses: string[];
  /** The page in Markdown: what it means, why a control objects, a bad and a good tape. */
  page: string;
}
export interface Preset {
  id: string;
  title: string;
  about: string;
  kind: SourceKind;
  /** Of CLDATA, the format that it is posted to. */
  format: Format;
  source: string;
  /** Where the cursor stands when the preset opens. */
  cursor: number;
}

/** How one field of a format is edited: all that the page knows about it. */
export interface FormatField {
  /** "classification", "itemized.feed" … */
  path: string;
  label: string;
  help: string;
  /**
   * text; choice (of `choices`); flag (true or false); number; position ([10, 10, 20]);
   * numbers ({"1": 120}); texts ({"G05": "hold"}); ranges ({"X": [0, 85]}); json (anything else).
   */
  kind: "text" | "choice" | "flag" | "number" | "position" | "numbers" | "texts" | "ranges" | "json";
  choices: { value: string; title: string }[];
  /** What holds while the field is not stated, as words for the user. */
  default: string;
  group: string;
}

/** One of the 256 rows of a code. */
export interface RowMeaning {
  /** One or a few characters to set under the row: "X", "EOB"; empty for a row without meaning. */
  label: string;
  name: string;
  /** Tracks with a hole, 1 to 8. */
  tracks: number[];
  /** The row has the right parity for the code. */
  parity: boolean;
}

export interface DecodeOptions {
  /** "auto": recognised by the first end of block and by parity. */
  code?: "auto" | "iso" | "eia";
  /** Count the characters of each block, as a control with TV check does: false. */
  countBlocks?: boolean;
}
/** CL text of a CAM system, turned into the reference language of ISO 3592. */
export interface TranslatedClText {
  text: string;
  /** The statements that became no command: they are kept in 1000 records. */
  faults: { from: number; to: number; message: string }[];
  /** From each statement to its records: from, to in the source -> from, to in the text. */
  map: [number, number, number, number][];
}

/** What a conversion gave. */
export interface Converted {
  text: string;
  /** What could not be carried over, or is written otherwise than one may expect: rules of the families CONV and POST. */
  diagnostics: Diagnostic[];
  /**
   * What became of each executed block: from, to in the source -> from, to in the text, in the order of the text. A block
   * that gave nothing has an empty range there; one that shares a motion with another is linked to its lines too. Of
   * CLDATA, what became of each record; of CL text, of each statement.
   */
  map: [number, number, number, number][];
  /** Something of the source is lacking: a diagnostic is an error. */
  incomplete?: true;
}

/** How CLDATA is read and posted. */
export interface PostOptions {
  /** As in CldataOptions; CL text has no columns. */
  columns?: number;
  dialect?: CldataOptions["dialect"];
  /** What arcs become, as a format does not say which interpolations a control has: "circles". */
  arcs?: "circles" | "parabolas" | "chords";
  /** The control carries out no more than a quadrant of a circle at a time: false, and always where I, J and K have no sign. */
  quadrants?: boolean;
  /** How far parabolas and chords may lie off an arc, in the unit of the format: what the text states (INTOL, OUTTOL), otherwise half an increment. */
  tolerance?: number;
}

export interface Decoded {
  /** The listing; U+FFFD for a row that cannot be read. */
  text: string;
  code: "iso" | "eia";
  /** Why that code. */
  reason: string;
  issues: RowIssue[];
}
/** Something about one row; `from` and `to` into the decoded text, empty where the row left nothing there. */
export interface RowIssue { row: number; byte: number; rule: string; kind: string; message: string; from: number; to: number }

/** What a file holds: a listing, or the image of a tape with what was found in its rows. */
export interface OpenedFile {
  kind: "listing" | "image";
  /** What the text is written in, by most of its lines. */
  language: SourceKind;
  text: string;
  /** Why it was taken for the one or the other. */
  reason: string;
  /** The format that was given, in the code of the tape. */
  format: Format;
  decoded: Decoded | null;
}
/** One row of holes in one code. */
export interface RowInCode {
  id: "iso" | "eia";
  title: string;
  /** Empty where the row has no meaning. */
  label: string;
  name: string | null;
  parity: boolean;
  /** Weights, character and parity in words. */
  sentence: string;
}
/** The tape and its codes in words; `tracks` says what a hole counts or does, track 1 first. */
export interface AboutCodes {
  tape: string[];
  codes: { id: "iso" | "eia"; title: string; tracks: string[]; about: string[] }[];
}

/** What a live tape holds, in numbers; `edit` is the number of the edit that it answers. */
export interface Summary {
  edit: number;
  unit: "mm" | "inch";
  axes: string[];
  code: "iso" | "eia";
  blocks: number;
  /** Blocks that the optional block skip switch leaves out. */
  skips: number;
  rows: number;
  spans: number;
  errors: number;
  warnings: number;
  infos: number;
  totals: Totals;
  /** Smallest box around all spans, X Y Z; null without spans. */
  bounds: { min: [number, number, number]; max: [number, number, number] } | null;
  /** Cutter compensation is in force somewhere, and the format states the radius of the cutter: see `offset`. */
  compensated: boolean;
}

/** One block of a live tape, and where it lies in every view. */
export interface BlockView extends Block {
  index: number;
  /** Rows of the tape, [first, last + 1]. */
  rows: [number, number];
  /** The span that the block belongs to; null if it moves nothing. */
  span: number | null;
}

/** A stretch of rows. One entry in each array for each row. */
export interface RowWindow {
  first: number;
  /** The holes: track n is bit n-1. */
  bytes: Uint8Array;
  /** UTF-16 offset of the character that the row stands for. */
  offsets: Uint32Array;
  /** Block of the row, -1 for what belongs to no block. */
  blocks: Int32Array;
  /** Kind of the block's span: 0 none, else an index into `spanKinds()` plus 1. */
  kinds: Uint8Array;
}

/** What the blocks of a stretch of text are made of. */
export interface Syntax {
  /** UTF-16 offset of each block. */
  starts: Uint32Array;
  /** Kind of each block's span: 0 none, else an index into `spanKinds()` plus 1. */
  kinds: Uint8Array;
  /** Start and end of each address, and of each sequence number as a whole. */
  ranges: Uint32Array;
  /** For each of these: 0 an address, or a keyword of CLDATA; 1 a sequence number; of CLDATA also 2 a record type, 3 a literal, 4 a record that is kept and not interpreted. */
  roles: Uint8Array;
}

/** What CLDATA holds, in numbers; `edit` is the number of the edit that it answers. */
export interface CldataSummary {
  edit: number;
  unit: "mm" | "inch";
  axes: string[];
  /** Records. */
  blocks: number;
  spans: number;
  /** What was found in reading and in posting. */
  errors: number;
  warnings: number;
  infos: number;
  totals: Totals;
  bounds: Summary["bounds"];
  /** Posting it found errors: the tape lacks something. */
  incomplete: boolean;
}

/** One record of CLDATA; its elements are `words`. */
export interface RecordView extends Block {
  index: number;
  /** The first span that the record belongs to; null if it moves nothing. */
  span: number | null;
  /** "record 12". */
  called: string;
  type: number | null;
  /** What it says, in a sentence or two. */
  says: string;
  /** It is kept, and not interpreted. */
  kept: boolean;
  /** The statement of the part program that it comes from, and the record that says so. */
  statement: { record: number; number: number | null; identification: string; text: string | null } | null;
}

/** What holds when a record of CLDATA has been carried out: always the same registers in the same order. */
export interface CldataState {
  position: [number, number, number] | null;
  /** Not `stated`: taken for granted, or not known. */
  registers: { name: string; says: string; stated: boolean }[];
}

/**
 * The flattened path. Every span gives its start, then its points; a point's span is in `span`. A dwell gives the same
 * point twice.
 */
export interface Points { xyz: Float64Array; span: Uint32Array }

/** The path of a live tape with what drawing needs: one entry of `kind`, `substitute` and `block` for each span. */
export interface Path extends Points {
  kinds: Uint8Array;
  substitutes: Uint8Array;
  /** First and last block of each span, two entries a span. */
  blocks: Uint32Array;
}

/** The path of the cutter's centre. A point's span is in `span`; a joint belongs to the span behind it. */
export interface OffsetPath {
  xyz: Float64Array;
  span: Uint32Array;
  /** Points at which a stretch begins that does not go on from the point before. */
  starts: Uint32Array;
}

/** The axes beyond X, Y and Z. For each span two entries of `lengths`: the way along X, Y and Z at its start and end. */
export interface OtherAxes {
  names: string[];
  /** An angle, in the unit of `angles`; else a length. */
  rotary: boolean[];
  angles: "turns" | "degrees";
  lengths: Float64Array;
  /** For each span, axis by axis, the value at its start and at its end. */
  values: Float64Array;
}

/** What has changed of a path: the spans between those that are kept. `span` counts as in the whole path. */
export interface PathChange extends Path {
  /** By which the next change is asked for. */
  number: number;
  /** So many spans at the start are kept. */
  first: number;
  /** So many spans at the end are kept. */
  last: number;
  /** By how much the blocks of the last ones have other numbers. */
  shift: number;
}

/** A function with its meaning: "G02", "M30". */
export interface NamedFunction {
  code: string;
  meaning: string;
  /** What its group is about; empty where it has none. */
  group: string;
  /** When it begins to act and how long it does; empty where nothing says so. */
  acts: string;
  /** What other sources say of it, where they differ. */
  conflict: string | null;
}
/** An entry of the tables of G and M (ISO 1056). */
export interface FunctionEntry extends NamedFunction { state: "assigned" | "unassigned" | "permanently unassigned" }

/** What the control holds behind a block. */
export interface Registers {
  block: number;
  /** Where the block is not executed, the control holds what it held before. */
  fate: "executed" | "skipped" | "unreached";
  /** The digits behind the program start character. */
  program: string | null;
  sequence: string | null;
  /** The preparatory functions in force; not `stated`: the control starts with it. */
  modal: { group: string; code: string | null; meaning: string; acts: string; conflict: string | null; stated: boolean }[];
  /** What acts in this block alone. */
  once: NamedFunction[];
  /** The function of the block that makes the control wait behind it. */
  stop: NamedFunction | null;
  /** How long the block dwells (G04), where the format states the word that says it. */
  dwell: { word: string; seconds: number | null } | null;
  /** In the order of `axes`. */
  position: number[];
  /** The axes whose position is a guess, because a word could not be read. */
  doubtful: boolean[];
  feed: { word: string; perMinute: number | null } | null;
  /** The leads of a thread along X, Y and Z; null but under G33 to G35. */
  leads: [number, number, number] | null;
  speed: { word: string; perMinute: number | null } | null;
  /** null while the tape has not said. */
  spindle: (NamedFunction & { turns: "still" | "clockwise" | "counter-clockwise" }) | null;
  coolant: (NamedFunction & { on: boolean }) | null;
  /** The tool word in force, and the tool change given since. */
  tool: { word: string; change: NamedFunction | null } | null;
  /** The number of the tool compensation: the last digits of T, or the word D. */
  compensation: string | null;
  /** Every other address of the detail that is no dimension, with its last word. */
  others: { address: string; word: string | null }[];
}

/** What the codes of a speed are compared for. */
export interface SpeedQuery {
  /** Its digits, tables and unit hold. */
  format: Format;
  /** Feeds or spindle speeds: "F". */
  address?: "F" | "S";
  /** Length of the block and radius of its arc in the unit of the format: the reciprocal of time needs them. */
  length?: number | null;
  radius?: number | null;
}
/** A speed, or a code, under each method of annex A. */
export interface SpeedComparison {
  /** What the speeds are counted in: "mm/min", "inch/rev", "rev/min". */
  unit: string;
  lengthUnit: "mm" | "inch";
  rows: ComparedSpeed[];
}
export interface ComparedSpeed {
  method: "time-reciprocal" | "arithmetic" | "geometric" | "symbolic" | "direct";
  /** The method in words, and where it is printed. */
  title: string;
  clause: string;
  /** The word has this coding in the format. */
  inForce: boolean;
  /** The digits behind the address; null where the speed has no code. */
  code: string | null;
  /** What the code says; null where it says no speed. */
  speed: number | null;
  /** How far that is above the speed that was asked for, in per cent; null where none was. */
  deviation: number | null;
  /** The code says rapid traverse. */
  rapid: boolean;
  /** Why there is no code or no speed; else empty. */
  note: string;
}

/** How long blocks take, one entry for each. */
export interface BlockTimes {
  /** Seconds of the spans that a block ends; 0 where it moves nothing, -1 where it is not known. */
  executing: Float64Array;
  /** Seconds of the reader for its rows; 0 behind the end of the program. */
  reading: Float64Array;
  /** 1: it cuts, and faster than it is read. */
  starved: Uint8Array;
}
/** The time of a tape with its reader, in seconds; null where a span has no known time. */
export interface TapeTime {
  reading: number;
  /** The machine alone. */
  executing: number | null;
  /** With the reader, with and without one block of buffer. */
  buffered: number | null;
  unbuffered: number | null;
  /** Blocks that cut faster than they are read, and for how long the tool stands there. */
  starved: number;
  waiting: number;
  /** Rows of zeros before and behind the numbers of dimension words; those that the format lets be left out. */
  leadingZeros: number;
  trailingZeros: number;
  permittedZeros: number;
  /** The same in words. */
  sentences: string[];
}

/** How a tape passes through the control. Times that are not known are assumed, so that it can be shown at work. */
export interface Course {
  /** First row and behind the last row of each block, two entries a block. */
  rows: Uint32Array;
  /** How long each block takes: its spans, or the reader where it has none. */
  seconds: Float64Array;
  /** Behind the last span carried out with each block; it begins where that of the block before ends. */
  spanEnds: Uint32Array;
  /** 0 executed, 1 skipped, 2 behind the end. */
  fates: Uint8Array;
  /** Why the control waits behind a block: 0 it does not, 1 program stop, 2 end. */
  stops: Uint8Array;
  /** Seconds of each span, known or assumed, and its kind: an index into `spanKinds()` plus 1. */
  spanSeconds: Float64Array;
  spanKinds: Uint8Array;
  /** How many spans have an assumed time, and what is assumed, in words. */
  assumed: number;
  note: string | null;
  /** The pace of blocks that move nothing, rows per second. */
  readerSpeed: number;
}
