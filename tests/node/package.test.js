// The npm package in Node, as a script that programs against the core uses it.
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { join } from "node:path";
import { test } from "node:test";
import { pathToFileURL } from "node:url";

const folder = process.env.NCTAPE_PKG ?? join(import.meta.dirname, "../../pkg");
/** @type {typeof import("nctape")} */
const nctape = await import(pathToFileURL(join(folder, "nctape.js")).href);
await nctape.default({ module_or_path: readFileSync(join(folder, "nctape_bg.wasm")) });

/** @param {string} id */
function preset(id) {
  const found = nctape.presets().find((preset) => preset.id === id);
  assert.ok(found, id);
  return found;
}

test("the package says what it is", () => {
  const manifest = JSON.parse(readFileSync(join(folder, "package.json"), "utf8"));
  assert.equal(manifest.name, "nctape");
  assert.deepEqual(nctape.version(), { package: manifest.version, api: 1 });
});

test("the printed tapes are free of errors", () => {
  for (const { id, source, format } of nctape.presets().filter(({ kind }) => kind === "tape")) {
    const report = nctape.check(source, format);
    const faults = report.diagnostics.filter((found) => found.severity !== "info");
    assert.deepEqual(faults, [], id);
    assert.equal(report.api, 1);
    assert.equal(report.suppressed, 0);
    assert.equal(report.totals.rows, nctape.encode(source, format).length);
    assert.equal(report.totals.tapeMillimetres, report.totals.rows * 2.54);
  }
});

test("the circular tape of annex E", () => {
  const { source, format } = preset("annex-e-circular");
  const { spans, totals, axes, unit } = nctape.check(source, format);
  assert.deepEqual([axes, unit], [["X", "Y", "Z"], "mm"]);
  assert.deepEqual(spans.at(-1)?.end, [10, 10, 20]);
  const arcs = spans.filter((span) => span.kind === "arc");
  assert.deepEqual(arcs.map((arc) => arc.centre), [[45, 35, 10], [45, 35, 10], [73.284, 63.284, 10]]);
  assert.deepEqual(arcs.map((arc) => Math.sign(arc.sweep ?? 0)), [-1, -1, 1]);
  assert.ok(Math.abs((totals.seconds ?? 0) / 60 - 0.7861) < 5e-5);
});

test("the test vector of annex E, byte for byte", () => {
  const format = preset("annex-e-parabolic").format;
  const source = "%\nN001G01X010000Y010000Z020000F0300M05\n";
  const hex = (/** @type {Uint8Array} */ rows) => Buffer.from(rows).toString("hex");
  assert.equal(
    hex(nctape.encode(source, format)),
    "a50a4e3030b14730b1d830b13030303059 30b1303030305a30b230303030c6303330304d30350a".replace(" ", ""),
  );
  assert.equal(
    hex(nctape.encode(source, { ...format, itemized: { ...format.itemized, code: "eia" } })),
    "0b8045202001672001372001202020203820012020202029200220202020762013202054201580",
  );
});

test("a tape is converted to decimal G-code, and linked block by block", () => {
  const { source, format } = preset("annex-e-circular");
  const { text, diagnostics, map } = nctape.toDecimal(source, format, "linuxcnc");
  assert.ok(text.includes("\nG21 G17 G90 G91.1 "), text);
  assert.ok(text.includes("\nN006 G2 X45.000 Y55.000 I14.142 J-14.142 F19\n"), text);
  assert.deepEqual(diagnostics, []);
  assert.equal(map.length, nctape.check(source, format).blocks.length);
  for (const [from, to, textFrom, textTo] of map) {
    const sequence = source.slice(from, to).slice(0, 4);
    assert.ok(text.slice(textFrom, textTo).startsWith(sequence), `${sequence} in ${text.slice(textFrom, textTo)}`);
  }
});

test("what cannot be converted is said, with offsets in UTF-16", () => {
  const { format } = preset("annex-d-boring");
  const source = "%\n(\u{1F600})N001 G00 X+001000 B1 M30\n";
  const { text, diagnostics, map } = nctape.toDecimal(source, format, "linuxcnc");
  assert.deepEqual(diagnostics.map(({ rule, severity }) => [rule, severity]), [["CONV-03", "warning"]]);
  assert.equal(source.slice(diagnostics[0]?.from, diagnostics[0]?.to), "B1");
  assert.ok(text.includes("(\u{1F600})\n(LEFT OUT: B1)\nN001 G0 X10.00\nM30\n"), text);
  const [[from, to, textFrom, textTo] = [0, 0, 0, 0]] = map;
  assert.ok(source.slice(from, to).endsWith("M30\n"));
  assert.ok(text.slice(textFrom, textTo).endsWith("M30\n"));
  assert.deepEqual(nctape.toDecimal("", format, "linuxcnc").map, []);
});

test("decimal G-code becomes a tape, and comes back", () => {
  const { format } = preset("annex-d-boring");
  const source = "G21 (\u{1F600})\nG0 X10.5 Y-3\nM30\n";
  const tape = nctape.fromDecimal(source, format);
  assert.deepEqual(tape.diagnostics, []);
  const [from, to, textFrom, textTo] = tape.map[1] ?? [0, 0, 0, 0];
  assert.equal(source.slice(from, to), "G0 X10.5 Y-3");
  assert.equal(tape.text.slice(textFrom, textTo), "N001\tG00\tX+001050\tY-00300\n");
  assert.ok(nctape.toDecimal(tape.text, format, "linuxcnc").text.includes("N001 G0 X10.50 Y-3.00\n"));
  const lacking = nctape.fromDecimal("G0 X100000.5\n", format).diagnostics;
  assert.deepEqual(lacking.map(({ rule, severity }) => [rule, severity]), [["CONV-09", "error"]]);
});

test("a tape becomes a tape of another format, and comes back", () => {
  const { source, format } = preset("annex-e-circular");
  const to = {
    ...format,
    classification: "CAM 333",
    detail: "N4G2X+43Y+43Z+43I+43J+43F4M2*",
    itemized: { ...format.itemized, arcCentre: /** @type {const} */ ("from-start") },
  };
  const there = nctape.convert(source, format, to);
  assert.deepEqual(there.diagnostics.filter(({ severity }) => severity === "error"), []);
  const [from, end, textFrom, textTo] = there.map.at(-1) ?? [0, 0, 0, 0];
  assert.ok(source.slice(from, end).includes("M"), source.slice(from, end));
  assert.ok(there.text.slice(textFrom, textTo).startsWith("N0"), there.text);
  const ends = (/** @type {string} */ text, /** @type {import("nctape").Format} */ format) =>
    nctape.check(text, format).spans.filter(({ kind }) => kind === "arc").map(({ sweep }) => Math.sign(sweep ?? 0));
  assert.deepEqual(ends(there.text, to), ends(source, format));
  const back = nctape.convert(there.text, to, format);
  assert.deepEqual(ends(back.text, format), ends(source, format));
  // @ts-expect-error: that is what is tried
  assert.throws(() => nctape.convert(source, format, { standard: "din" }), TypeError);
});

test("an unknown dialect is a TypeError that names its field", () => {
  const { source, format } = preset("annex-e-circular");
  for (const dialect of ["fanuc", "", null, 7]) {
    assert.throws(
      // @ts-expect-error: that is what is tried
      () => nctape.toDecimal(source, format, dialect),
      (error) => error instanceof TypeError && "field" in error && error.field === "dialect",
    );
  }
});

test("options leave out what is not wanted, and the limit is kept", () => {
  const { format } = preset("annex-e-circular");
  const report = nctape.check("%\n" + "N001 #\n".repeat(20), format, { blocks: false, spans: false, limit: 5 });
  assert.deepEqual([report.blocks, report.spans], [[], []]);
  assert.equal(report.diagnostics.length, 5);
  assert.ok(report.suppressed >= 15);
});

test("a malformed argument throws a TypeError with its field", () => {
  const { source, format } = preset("annex-e-circular");
  const field = (/** @type {string} */ name) => (/** @type {unknown} */ error) =>
    error instanceof TypeError && Reflect.get(error, "field") === name;
  const any = /** @type {any} */ (nctape);
  assert.throws(() => any.check(1, format), field("source"));
  assert.throws(() => any.check(source), field("format"));
  assert.throws(() => any.check(source, { ...format, standard: "din66025" }), field("standard"));
  assert.throws(() => any.check(source, format, 5), field("options"));
  assert.throws(() => any.check(source, format, { limit: "all" }), field("limit"));
  assert.throws(() => any.points(source, format, 0), field("tolerance"));
  assert.throws(() => any.encode(undefined, format), field("source"));
});

test("every rule has a page, and every id stands once", () => {
  const rules = nctape.rules();
  const ids = rules.flatMap((rule) => [rule.rule, ...rule.aliases]);
  assert.equal(new Set(ids).size, ids.length);
  for (const rule of rules) {
    assert.ok(rule.page.startsWith(`# ${rule.rule} ${rule.name}\n`), rule.rule);
  }
});

test("an empty text is said to be one", () => {
  const report = nctape.check("", preset("annex-e-circular").format);
  assert.deepEqual(report.diagnostics.map((found) => [found.rule, found.from, found.to]), [["TAPE-10", 0, 0]]);
  assert.deepEqual([report.blocks, report.spans, report.totals.rows], [[], [], 0]);
});

test("rows and text, both ways, and a format suggested", () => {
  for (const { id, source, format } of nctape.presets().filter(({ kind }) => kind === "tape")) {
    const decoded = nctape.decode(nctape.encode(source, format));
    assert.equal(decoded.code, format.itemized?.code ?? "iso", id);
    assert.deepEqual(decoded.issues, [], id);
    assert.deepEqual(nctape.encode(decoded.text, format), nctape.encode(source, format), id);
    assert.equal(nctape.suggestFormat(source)[0]?.errors, 0, id);
  }
});

test("a name in letters of holes is passed over when its tape is opened", () => {
  const { source, format } = preset("annex-e-circular");
  for (const code of /** @type {const} */ (["iso", "eia"])) {
    const rows = nctape.encode(source, { ...format, itemized: { ...format.itemized, code } });
    const letters = nctape.lettering("Ada Lovelace");
    const opened = nctape.openFile(Buffer.concat([letters, rows]), format);
    assert.equal(opened.kind, "image");
    assert.equal(opened.text, source);
    assert.deepEqual(opened.decoded?.issues.map((issue) => issue.kind), ["label"]);
    assert.equal(opened.format.itemized?.code ?? "iso", code, "the format is in the code of the tape");
    assert.deepEqual(opened.format.itemized?.setPoint, [10, 10, 20], "and otherwise as it was");
  }
  assert.equal(nctape.openFile(Buffer.from(source), format).kind, "listing");
  assert.equal(nctape.lettering("\u4e16").length, 0);
  assert.match(nctape.letteringNote("\u4e16!", "N001\n").advice, /Put an end of block first/);
  assert.equal(nctape.letteringNote("\u4e16!", source).missing, "\u4e16");
});

test("a row is explained in both codes, and every row of a code by that code", () => {
  assert.deepEqual(
    nctape.rowWords(0x47).map(({ id, label, name, parity }) => [id, label, name, parity]),
    [["iso", "G", "letter", true], ["eia", "", null, false]],
  );
  for (const { id, tracks } of nctape.aboutCodes().codes) {
    assert.equal(tracks.length, 8);
    const table = nctape.codeTable(id);
    table.forEach(({ label }, row) => assert.equal(nctape.rowWords(row).find((one) => one.id === id)?.label, label));
  }
});

test("what is known of the machine is kept, and what is not is said", () => {
  const { format } = preset("annex-e-circular");
  /** @type {import("nctape").Format} */
  const found = { standard: "iso2539", detail: "N3.G2.X+42.F4.M2*" };
  const known = { ...format, itemized: { ...format.itemized, readerSpeed: 60, rapid: 5000 } };
  assert.deepEqual(nctape.onMachineOf(found, known).itemized, { readerSpeed: 60, rapid: 5000 }, "a set point is of its own tape");
  assert.equal(nctape.readerSpeed(found), 300);
  assert.equal(nctape.whyUntimed("rapid", found).field, "itemized.rapid");
  // @ts-expect-error no such kind
  assert.throws(() => nctape.whyUntimed("hop", found), { name: "TypeError", field: "kind" });
});

test("a picture of a tape is true to scale", () => {
  const { width, height, rgba, pixelsPerMetre } = nctape.picture(new Uint8Array([0, 0xff]), 24, "light");
  assert.equal(width, 48);
  assert.equal(rgba.length, 4 * width * height);
  assert.ok(Math.abs(width / pixelsPerMetre - 2 * 0.00254) < 1e-12);
});

test("what colours the listing: each address, the sequence number as a whole, the kind of each block", () => {
  const { format } = preset("annex-e-circular");
  const source = "%\nN001 G00 X+000100\nN002 M02\n";
  const tape = new nctape.Tape(source, format, null);
  const { starts, kinds, ranges, roles } = tape.syntax(0, source.length, 100);
  const pieces = Array.from(roles, (role, i) => [source.slice(ranges[2 * i], ranges[2 * i + 1]), role]);
  assert.deepEqual(pieces, [["N001", 1], ["G", 0], ["X", 0], ["N002", 1], ["M", 0]]);
  assert.deepEqual([...starts], [source.indexOf("N001"), source.indexOf("N002")]);
  assert.deepEqual(Array.from(kinds, (kind) => nctape.spanKinds()[kind - 1] ?? null), ["rapid", null]);
  assert.equal(tape.syntax(0, source.length, 1).starts.length, 1, "no more than were asked for");
});
