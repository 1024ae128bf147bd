// The views that CLDATA has beside those of a tape. Fetched when it is opened first.
import { makePosted } from './posted.js';
import { makeRecord } from './record.js';

/** @param {Parameters<typeof makePosted>[0] & Parameters<typeof makeRecord>[0]} parts */
export function makeCldataViews(parts) {
  makePosted(parts);
  makeRecord(parts);
}
