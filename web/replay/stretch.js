// What a replay asks of the tape. Runs in the worker.
/** @typedef {import('nctape').Tape} Tape */
/** @typedef {import('nctape').Registers} Registers */

/**
 * Some blocks with all that the views show of each.
 * @typedef {object} Stretch
 * @property {number} first
 * @property {{ block: import('nctape').BlockView, span: import('nctape').Span | null }[]} blocks
 * @property {Registers[]} held  what the control holds behind each
 * @property {number} firstRow
 * @property {Uint32Array} offsets  of the characters of their rows
 */

export const replayQuestions = {
  /** @param {Tape} tape */
  course: (tape) => tape.course(),

  /**
   * @param {Tape} tape
   * @param {number} first
   * @param {number} count
   * @returns {Stretch}
   */
  stretch(tape, first, count) {
    const blocks = [];
    for (let index = first; index < first + count; index += 1) {
      const block = tape.block(index);
      if (block === null) break;
      blocks.push({ block, span: block.span === null ? null : tape.span(block.span) });
    }
    const firstRow = blocks[0]?.block.rows[0] ?? 0;
    const behind = blocks[blocks.length - 1]?.block.rows[1] ?? firstRow;
    const { offsets } = tape.rows(firstRow, behind - firstRow);
    return { first, blocks, held: tape.registersOf(first, blocks.length), firstRow, offsets };
  },
};
