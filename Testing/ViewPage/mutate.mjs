// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause

// The scripts of pages read view files with random changes, or refuse them with a sentence: they
// throw nothing else, and do not hang (who runs this has a limit of time).
//
// usage: node mutate.mjs FILE.tcview [--count N]

import fs from "node:fs";
import path from "node:path";
import { fileURLToPath } from "node:url";
import vm from "node:vm";
import zlib from "node:zlib";

const PAGE = path.join(path.dirname(fileURLToPath(import.meta.url)),
  "../../vtkTemporalCoherence/Vtk/ViewFile/Page");
const BYTES_BEFORE_HEADER = 24;

// The scripts have no exports: they are parts of one.
const script = ["container.js", "decode.js"].map((name) =>
  fs.readFileSync(path.join(PAGE, name), "utf8")).join("\n");
const { readContainer, decodeView, WrongFile, checksumOf } = vm.runInThisContext(
  `(() => { "use strict";\n${script}\nreturn { readContainer, decodeView, WrongFile, checksumOf }; })()`);

// Numbers from 0 to below 1, the same for the same seed.
function randomOf(seed) {
  let state = (seed * 2654435761 + 12345) >>> 0;
  return () => {
    state = (state + 0x6d2b79f5) >>> 0;
    let mixed = Math.imul(state ^ (state >>> 15), state | 1);
    mixed ^= mixed + Math.imul(mixed ^ (mixed >>> 7), mixed | 61);
    return ((mixed ^ (mixed >>> 14)) >>> 0) / 4294967296;
  };
}

class Mutator {
  constructor(file) {
    this.file = file;
    const length = file.readUInt32LE(12);
    this.begin = file.subarray(0, BYTES_BEFORE_HEADER);
    this.text = file.subarray(BYTES_BEFORE_HEADER, BYTES_BEFORE_HEADER + length);
    this.sections = file.subarray(BYTES_BEFORE_HEADER + length);
  }

  make(number) {
    const random = randomOf(number);
    this.below = (count) => Math.floor(random() * count);
    return [() => this.changed(this.file), () => this.join(this.changed(this.text), this.sections),
      () => this.withChangedValues(), () => this.withChangedSection()][number % 4]();
  }

  // A file with a right length and checksum of its header.
  join(text, sections) {
    const begin = Buffer.from(this.begin);
    begin.writeUInt32LE(text.length, 12);
    begin.writeUInt32LE(checksumOf(text), 16);
    return Buffer.concat([begin, text, sections]);
  }

  // Some bytes changed, deleted or repeated, or cut off.
  changed(original) {
    let bytes = Buffer.from(original);
    for (let changes = 1 + this.below(3); changes > 0 && bytes.length > 0; --changes) {
      const at = this.below(bytes.length), end = Math.min(at + this.below(9), bytes.length);
      const kind = this.below(8);
      if (kind === 0) {
        bytes = Buffer.concat([bytes.subarray(0, at), bytes.subarray(end)]);
      } else if (kind === 1) {
        bytes = Buffer.concat([bytes.subarray(0, end), bytes.subarray(at)]);
      } else if (kind === 2 && this.below(4) === 0) {
        bytes = bytes.subarray(0, at);
      } else {
        bytes[at] = kind === 3 ? bytes[at] + 1 : kind === 4 ? bytes[at] - 1 : this.below(256);
      }
    }
    return bytes;
  }

  // Some values of the header replaced, removed or repeated.
  withChangedValues() {
    const values = [null, true, "rising", [], {}, { toString: 1 }, -1, 0, 1, 2, 16, 24, 127, 384, 65535,
      65536, 4294967296, 1e-300, 1e300, -0.5, 2 ** 53, [1, 2], [0, 0, 0], [null, null, null]];
    const header = JSON.parse(this.text.toString());
    for (let changes = 1 + this.below(3); changes > 0; --changes) {
      let parent = header, key = null;
      for (let at = header; at !== null && typeof at === "object" && Object.keys(at).length > 0 &&
           (key === null || this.below(8) !== 0); at = parent[key]) {
        parent = at;
        key = Object.keys(at)[this.below(Object.keys(at).length)];
      }
      if (key === null) {
        break;
      }
      const kind = this.below(5), isNumber = typeof parent[key] === "number";
      if (kind === 0 && Array.isArray(parent)) {
        parent.push(structuredClone(parent[key]));
      } else if (kind === 1) {
        delete parent[key];
      } else if (kind === 2 && isNumber) {
        parent[key] += 1;
      } else {
        parent[key] = structuredClone(values[this.below(values.length)]);
      }
    }
    return this.join(Buffer.from(JSON.stringify(header)), this.sections);
  }

  // A section's unpacked bytes changed. It moves to the end of the file.
  withChangedSection() {
    const header = JSON.parse(this.text.toString());
    const view = header.views[this.below(header.views.length)];
    const sections = [...view.chunks, view.entries, view.unknown].filter(Boolean);
    const section = sections[this.below(sections.length)];
    const bytes = this.changed(zlib.inflateSync(
      this.sections.subarray(section.offset, section.offset + section.bytes)));
    const packed = zlib.deflateSync(bytes);
    section.offset = this.sections.length;
    section.bytes = packed.length;
    section.unpacked = bytes.length;
    return this.join(Buffer.from(JSON.stringify(header)), Buffer.concat([this.sections, packed]));
  }
}

// What is wrong with a file; empty if nothing is.
async function wrongOf(file) {
  try {
    const { header, sections } = readContainer(file);
    for (const view of header.views) {
      if (view.size[0] * view.size[1] <= 2 ** 16) {
        await decodeView(view, sections, async () => {});
      }
    }
    return "";
  } catch (error) {
    if (error instanceof WrongFile) {
      return error.message;
    }
    throw error;
  }
}

async function main([name, option, number]) {
  const mutator = new Mutator(fs.readFileSync(name));
  const count = option === "--count" ? Number(number) : 1500;
  const wrong = await wrongOf(mutator.file);
  if (wrong !== "") {
    throw new Error(`The file is wrong as it is: ${wrong}`);
  }
  let refused = 0, damaged = 0;
  for (let i = 0; i < count; ++i) {
    try {
      const found = await wrongOf(mutator.make(i));
      refused += found !== "";
      damaged += found.includes("a knot is impossible");
    } catch (error) {
      console.error(`FAILED: change ${i} throws what is no WrongFile: ${error.stack}`);
      process.exit(1);
    }
  }
  console.log(`${count} changes: ${refused} refused, ${damaged} of them for a knot`);
  if (refused < count / 4 || refused === count || damaged === 0) {
    console.error("FAILED: changes do not reach all that is checked");
    process.exit(1);
  }
}

await main(process.argv.slice(2));
