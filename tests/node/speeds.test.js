// Codes of speeds, and the time of a tape with its reader.
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { join } from "node:path";
import { test } from "node:test";
import { pathToFileURL } from "node:url";

const folder = process.env.NCTAPE_PKG ?? join(import.meta.dirname, "../../pkg");
/** @type {typeof import("nctape")} */
const nctape = await import(pathToFileURL(join(folder, "nctape.js")).href);
await nctape.default({ module_or_path: readFileSync(join(folder, "nctape_bg.wasm")) });

/** @type {import("nctape").Format} */
const format = { standard: "iso2539", classification: "CSM 333", detail: "N3.G2.XD33.YD33.ZD33.ID33.JD33.F4.M2*", itemized: { feed: "time-reciprocal" } };

test("a speed has a code by each method, and a code a speed", () => {
  const { unit, lengthUnit, rows } = nctape.speedCodes(300, { format, length: 11.716, radius: 20 });
  assert.deepEqual([unit, lengthUnit], ["mm/min", "mm"]);
  assert.deepEqual(rows.map(({ code }) => code), ["0025", "0015", "630", "6300", "63000", "50", null, "0300"]);
  assert.deepEqual(rows.filter(({ inForce }) => inForce).map(({ method }) => method), ["time-reciprocal", "time-reciprocal"]);
  // 25 blocks of this length a minute; 15 radians of this radius; digits that say themselves; R20; symbols without values.
  assert.deepEqual(rows.map(({ speed }) => speed), [25 * 11.716, 15 * 20, 300, 300, 300, 315, null, 300]);

  const back = nctape.speedOf("615", { format, address: "S" });
  assert.deepEqual(back?.rows.map(({ speed }) => speed), [150, null, null, 615]);
  assert.equal(nctape.speedOf("6l5", { format }), null);
  assert.equal(nctape.speedOf("99", { format })?.rows.find(({ method }) => method === "geometric")?.rapid, true);
});

test("malformed questions are refused with their field", () => {
  const field = (/** @type {string} */ name) => (/** @type {unknown} */ error) =>
    error instanceof TypeError && Reflect.get(error, "field") === name;
  const any = /** @type {any} */ (nctape);
  assert.throws(() => any.speedCodes(300), field("format"));
  assert.throws(() => any.speedCodes(300, { format, address: "X" }), field("address"));
  assert.throws(() => any.speedCodes(300, { format, length: "10" }), field("length"));
  assert.throws(() => any.speedOf(615, { format }), field("code"));
  for (const speed of [NaN, -1, Infinity]) {
    assert.ok(nctape.speedCodes(speed, { format, length: 1, radius: 1 }).rows.every(({ code }) => code === null));
  }
});

test("the printed circular tape with a slow reader", () => {
  const preset = nctape.presets().find(({ id }) => id === "annex-e-circular");
  assert.ok(preset);
  const slow = { ...preset.format, itemized: { ...preset.format.itemized, readerSpeed: 10 } };
  const tape = new nctape.Tape(preset.source, slow);
  const { executing, reading, starved } = tape.times(0, 1000);
  const { blocks } = nctape.check(preset.source, slow);
  assert.deepEqual([executing.length, reading.length, starved.length], [blocks.length, blocks.length, blocks.length]);
  executing.forEach((seconds, index) => assert.equal(starved[index] === 1, seconds > 0 && reading[index] > seconds));
  const time = tape.time();
  assert.equal(time.starved, starved.filter((one) => one === 1).length);
  assert.ok((time.buffered ?? 0) < (time.unbuffered ?? 0) && (time.buffered ?? 0) > (time.executing ?? 0));
  const found = tape.diagnostics(0, preset.source.length, 100).find(({ rule }) => rule === "FEED-15");
  assert.deepEqual([found?.severity, found?.count], ["warning", time.starved]);
  assert.ok(time.sentences.length === 3);
  tape.free();
});

test("a dwell is a span without length", () => {
  const dwelling = /** @type {const} */ ({ standard: "iso2539", classification: "CAM 222", detail: "N3G2X+42Y+42F4M2*", itemized: { dwell: { address: "X", unit: "seconds" } } });
  const source = "%\nN001G01X+001000F0300\nN002G04X+000150\nN003Y+001000M30\n";
  const { spans, totals } = nctape.check(source, dwelling);
  assert.deepEqual(spans.map(({ kind, length, seconds }) => [kind, length, seconds]), [["line", 10, 2], ["dwell", 0, 1.5], ["line", 10, 2]]);
  assert.deepEqual([spans[1].start, spans[1].end, totals.seconds], [[10, 0, 0], [10, 0, 0], 5.5]);
  assert.deepEqual([...nctape.points(source, dwelling, 0.01).span], [0, 0, 1, 1, 2, 2]);
});
