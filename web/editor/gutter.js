// The slim column beside the text: the kind of the block's span, and the worst problem of the line.
import { gutter, GutterMarker } from '@codemirror/view';
import { el } from '../dom.js';
import { severityMark } from '../severity.js';

/** @typedef {import('nctape').Severity} Severity */

export class BlockMarker extends GutterMarker {
  /**
   * @param {string | null} kind
   * @param {Severity | null} worst
   */
  constructor(kind, worst) {
    super();
    this.kind = kind;
    this.worst = worst;
  }

  /**
   * @override
   * @param {GutterMarker} other
   */
  eq(other) {
    return other instanceof BlockMarker && other.kind === this.kind && other.worst === this.worst;
  }

  /** @override */
  toDOM() {
    return el(
      'span',
      { class: 'cm-block' },
      el('span', { class: 'cm-worst' }, this.worst === null ? null : severityMark(this.worst)),
      el('span', { class: `cm-kind ${this.kind === null ? '' : `kind-${this.kind}`}` }),
    );
  }
}

/** @param {(view: import('@codemirror/view').EditorView) => import('@codemirror/state').RangeSet<BlockMarker>} markers */
export const blockGutter = (markers) =>
  gutter({ class: 'cm-block-gutter', markers, initialSpacer: () => new BlockMarker(null, null) });
