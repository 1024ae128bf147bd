// What of the core goes into the one file. The worker's other answers are not asked for there; what they would call is
// left out, of the script and of the wasm.
export {
  default,
  Tape,
  aboutCodes,
  codeTable,
  columns,
  formatLine,
  presets,
  rowWords,
  rules,
  spanKinds,
  standards,
  version,
} from '../../pkg/nctape.js';
