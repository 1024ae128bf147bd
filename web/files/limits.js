// How much of a file is worked on.

/** Rows in a picture: more would make one that few programs open. */
export const MOST_ROWS = 5000;
/** Bytes of a file that is opened: a hundred times the longest reel of tape. */
export const MOST_BYTES = 20_000_000;
