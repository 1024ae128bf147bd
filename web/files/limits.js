// How much of a file is worked on.

/** Rows in a picture: more would make one that few programs open. */
export const MOST_ROWS = 5000;
/** Rows in a line of it: ten inches of tape, which a sheet of A4 or letter paper takes sideways. */
export const ROWS_IN_LINE = 100;
/** Bytes of a file that is opened: a hundred times the longest reel of tape. */
export const MOST_BYTES = 20_000_000;
