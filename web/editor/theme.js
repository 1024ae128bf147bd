// The editor's looks, in the colours of the page: custom properties reach into its shadow root.
import { EditorView } from '@codemirror/view';

export const theme = EditorView.theme({
  '&': { height: '100%', color: 'var(--text)', backgroundColor: 'var(--sheet)' },
  '&.cm-focused': { outline: 'none' },
  '.cm-scroller': {
    fontFamily: 'var(--mono)',
    fontSize: 'var(--code-size)',
    fontVariantNumeric: 'tabular-nums',
    lineHeight: '1.65',
  },
  '.cm-content': { padding: '8px 0 40vh', caretColor: 'var(--accent)' },
  '.cm-line': { padding: '0 16px 0 10px' },
  '.cm-cursor': { borderLeftColor: 'var(--accent)', borderLeftWidth: '2px' },
  '&.cm-focused > .cm-scroller > .cm-selectionLayer .cm-selectionBackground, .cm-selectionBackground': {
    backgroundColor: 'var(--selection)',
  },
  '.cm-gutters': { backgroundColor: 'var(--sheet)', border: 'none', color: 'var(--muted)' },
  '.cm-block-gutter .cm-gutterElement': { padding: '0' },
  '.cm-block': { display: 'flex', height: '100%', alignItems: 'stretch' },
  '.cm-worst': { width: '24px', display: 'grid', placeItems: 'center' },
  '.cm-kind': { width: '4px', backgroundColor: 'var(--kind, transparent)' },
  '.cm-kind.kind-rapid': {
    background: 'repeating-linear-gradient(to bottom, var(--kind-rapid) 0 5px, transparent 5px 9px)',
  },
  '.cm-sequence': { color: 'var(--muted)' },
  '.cm-address': { color: 'var(--address)', fontWeight: '600' },
  '.cm-type': { color: 'var(--muted)' },
  '.cm-literal': { color: 'var(--literal)' },
  '.cm-kept': { fontStyle: 'italic', color: 'var(--muted)' },
  '.cm-lit': { backgroundColor: 'var(--lit)', boxShadow: 'inset 3px 0 0 var(--accent)' },
  '.cm-chosen': { outline: '2px solid var(--accent)', outlineOffset: '0', borderRadius: '2px' },
  '.cm-squiggle': {
    textDecorationLine: 'underline',
    textDecorationThickness: '1.5px',
    textUnderlineOffset: '4px',
    textDecorationSkipInk: 'none',
  },
  '.cm-squiggle-error': { textDecorationStyle: 'wavy', textDecorationColor: 'var(--error)' },
  '.cm-squiggle-warning': { textDecorationStyle: 'dashed', textDecorationColor: 'var(--warning)' },
  '.cm-squiggle-info': { textDecorationStyle: 'dotted', textDecorationColor: 'var(--info)' },
  '.cm-tooltip': {
    border: '1px solid var(--line)',
    borderRadius: '8px',
    backgroundColor: 'var(--panel)',
    color: 'var(--text)',
    boxShadow: 'var(--shadow)',
    maxWidth: 'min(440px, 90vw)',
    overflow: 'hidden',
  },
  '.cm-specialChar': { color: 'var(--error)' },
});
