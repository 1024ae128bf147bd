// Brings a place of a text into sight.

/** @typedef {import('@codemirror/view').EditorView} EditorView */

/** So far from the edges a line comes to lie. */
const MARGIN = 60;

/**
 * Brings a place into sight within the editor, and moves nothing around it.
 * @param {EditorView} view
 * @param {number} offset
 * @param {'nearest' | 'center' | 'opened'} where  opened: from the top, where the place is to be seen then
 */
export function scrollWithin(view, offset, where) {
  const { scrollDOM } = view;
  view.requestMeasure({
    key: scrollWithin,
    read: () => view.lineBlockAt(Math.min(offset, view.state.doc.length)),
    write({ top, bottom }) {
      const { clientHeight, scrollTop } = scrollDOM;
      const margin = Math.min(MARGIN, clientHeight / 3);
      if (where === 'nearest' && top - margin >= scrollTop && bottom + margin <= scrollTop + clientHeight) return;
      const toTop = top - margin;
      const toBottom = bottom + margin - clientHeight;
      if (where === 'opened' && bottom + margin <= clientHeight) {
        scrollDOM.scrollTop = 0;
        return;
      }
      scrollDOM.scrollTop = where !== 'nearest' ? (top + bottom - clientHeight) / 2 : toTop < scrollTop ? toTop : toBottom;
    },
  });
  // Across, once the line is there.
  requestAnimationFrame(() => {
    const at = offset <= view.state.doc.length ? view.coordsAtPos(offset) : null;
    if (at === null) return;
    const box = scrollDOM.getBoundingClientRect();
    const margin = Math.min(MARGIN, box.width / 3);
    if (at.left < box.left + margin) scrollDOM.scrollLeft -= box.left + margin - at.left;
    else if (at.right > box.right - margin) scrollDOM.scrollLeft += at.right - box.right + margin;
  });
}
