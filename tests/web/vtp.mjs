// Reads the files that io/vtp_write.cpp writes (VTK PolyData, appended raw, zlib), by the rules of
// the VTK file formats and without VTK, so that page and file are compared by somebody else.
import { readFileSync } from "node:fs";
import { inflateSync } from "node:zlib";

const kTypes = { Float64: Float64Array, Float32: Float32Array, Int32: Int32Array, Int64: BigInt64Array,
                 UInt8: Uint8Array };

/** Map from array name to { values, components }; strings are left out. "Points" are the points. */
export function readVtp(file) {
  const bytes = readFileSync(file);
  const mark = bytes.indexOf("<AppendedData encoding=\"raw\">");
  if (mark < 0) throw new Error(`${file}: no appended raw data`);
  const start = bytes.indexOf("_", mark) + 1;
  const head = bytes.subarray(0, mark).toString("latin1");
  const arrays = new Map();
  for (const [, text] of head.matchAll(/<DataArray([^>]*)>/g)) {
    const at = (name) => text.match(new RegExp(`\\b${name}="([^"]*)"`))?.[1];
    const Type = kTypes[at("type")];
    if (!Type || at("offset") === undefined) continue;
    let from = start + Number(at("offset"));
    const next = () => {
      const value = Number(bytes.readBigUInt64LE(from));
      from += 8;
      return value;
    };
    const blocks = next();
    next();
    next();
    const sizes = Array.from({ length: blocks }, next), parts = [];
    for (const size of sizes) {
      parts.push(inflateSync(bytes.subarray(from, from + size)));
      from += size;
    }
    const raw = Buffer.concat(parts);
    const values = new Type(raw.buffer.slice(raw.byteOffset, raw.byteOffset + raw.length));
    const name = at("Name");
    if (!arrays.has(name)) arrays.set(name, { values, components: Number(at("NumberOfComponents") ?? 1) });
  }
  return arrays;
}
