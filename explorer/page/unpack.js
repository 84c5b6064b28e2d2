// Unpacks LZMA, with its header. A browser unpacks gzip by itself, which leaves the generator a third larger.
"use strict";

/** Bytes before the first one of the range coder: properties, size of the dictionary, size of what is packed. */
const HEAD = 13;
/** Values of a state after a literal, and the number of states. */
const STATES = 12;
const HALF = 1024;

/** Places of the probabilities, each table behind the one before. */
const TABLES = (() => {
  const sizes = {
    match: STATES << 4, rep: STATES, rep0: STATES, rep1: STATES, rep2: STATES, long: STATES << 4, slot: 4 << 6, distance: 128, align: 16,
    length: 2 + 2 * (16 << 3) + 256, repeat: 2 + 2 * (16 << 3) + 256, literal: 0,
  };
  let at = 0;
  return Object.fromEntries(Object.entries(sizes).map(([name, size]) => [name, (at += size) - size]));
})();

/** Reads the bits of a range coder. */
class Range {
  constructor(bytes, at, probabilities) {
    this.bytes = bytes;
    this.at = at + 5;
    this.own = new Uint16Array(probabilities).fill(HALF);
    // The range and the code: in an array they stay numbers of 32 bits.
    this.now = new Uint32Array([0xffffffff, new DataView(bytes.buffer, bytes.byteOffset).getUint32(at + 1)]);
  }

  /** A bit by the probability at a place. */
  bit(place) {
    const { now, own } = this;
    const chance = own[place];
    const bound = (now[0] >>> 11) * chance;
    let bit = 0;
    if (now[1] < bound) {
      now[0] = bound;
      own[place] = chance + ((2048 - chance) >> 5);
    } else {
      now[0] -= bound;
      now[1] -= bound;
      own[place] = chance - (chance >> 5);
      bit = 1;
    }
    if (now[0] < 0x1000000) this.shift();
    return bit;
  }

  shift() {
    this.now[0] <<= 8;
    this.now[1] = (this.now[1] << 8) | this.bytes[this.at];
    this.at += 1;
  }

  /** Bits without a probability. */
  direct(count) {
    let all = 0;
    for (let i = 0; i < count; i += 1) {
      this.now[0] >>>= 1;
      const bit = this.now[1] >= this.now[0] ? 1 : 0;
      if (bit) this.now[1] -= this.now[0];
      all = all * 2 + bit;
      if (this.now[0] < 0x1000000) this.shift();
    }
    return all;
  }

  /** Goes on from a node of a tree of bits, the highest first, to the first one from `end` on. Most time is spent here. */
  walk(place, node, end) {
    const { now, own, bytes } = this;
    let range = now[0];
    let code = now[1];
    let at = node;
    while (at < end) {
      const chance = own[place + at];
      const bound = (range >>> 11) * chance;
      if (code < bound) {
        range = bound;
        own[place + at] = chance + ((2048 - chance) >> 5);
        at <<= 1;
      } else {
        range -= bound;
        code -= bound;
        own[place + at] = chance - (chance >> 5);
        at = (at << 1) | 1;
      }
      if (range < 0x1000000) {
        range = (range << 8) >>> 0;
        code = ((code << 8) | bytes[this.at]) >>> 0;
        this.at += 1;
      }
    }
    now[0] = range;
    now[1] = code;
    return at;
  }

  /** A number of so many bits. */
  tree(place, bits) {
    return this.walk(place, 1, 1 << bits) - (1 << bits);
  }

  /** The same, of which the lowest bit comes first. */
  reverse(place, bits) {
    let [at, all] = [1, 0];
    for (let i = 0; i < bits; i += 1) {
      const bit = this.bit(place + at);
      at = (at << 1) | bit;
      all |= bit << i;
    }
    return all;
  }

  length(place, now) {
    if (!this.bit(place)) return 2 + this.tree(place + 2 + (now << 3), 3);
    if (!this.bit(place + 1)) return 10 + this.tree(place + 2 + (16 << 3) + (now << 3), 3);
    return 18 + this.tree(place + 2 + 2 * (16 << 3), 8);
  }

  /** The distance of a match of a length, less 1. */
  distance(length) {
    const slot = this.tree(TABLES.slot + (Math.min(length - 2, 3) << 6), 6);
    if (slot < 4) return slot;
    const bits = (slot >> 1) - 1;
    const base = (2 | (slot & 1)) * 2 ** bits;
    if (slot < 14) return base + this.reverse(TABLES.distance + base - slot, bits);
    return base + this.direct(bits - 4) * 16 + this.reverse(TABLES.align, 4);
  }
}

/** What was packed by LZMA. */
function unpacked(packed) {
  const properties = packed[0];
  const context = properties % 9;
  const places = (1 << (Math.floor(properties / 9) % 5)) - 1;
  const now = (1 << Math.floor(properties / 45)) - 1;
  const out = new Uint8Array(new DataView(packed.buffer, packed.byteOffset).getUint32(5, true));
  const range = new Range(packed, HEAD, TABLES.literal + (0x300 << (context + Math.log2(places + 1))));
  let state = 0;
  let last = [0, 0, 0, 0];
  let at = 0;
  while (at < out.length) {
    const turn = at & now;
    if (!range.bit(TABLES.match + (state << 4) + turn)) {
      const before = at ? out[at - 1] : 0;
      const place = TABLES.literal + 0x300 * (((at & places) << context) + (before >> (8 - context)));
      out[at] = literal(range, place, state < 7 ? -1 : out[at - last[0] - 1]);
      at += 1;
      state = state < 4 ? 0 : state - (state < 10 ? 3 : 6);
      continue;
    }
    let length = 0;
    if (!range.bit(TABLES.rep + state)) {
      length = range.length(TABLES.length, turn);
      last = [range.distance(length), last[0], last[1], last[2]];
      state = state < 7 ? 7 : 10;
    } else if (range.bit(TABLES.rep0 + state)) {
      const index = range.bit(TABLES.rep1 + state) ? 2 + range.bit(TABLES.rep2 + state) : 1;
      last = [last[index], ...last.filter((_, i) => i !== index)];
      length = range.length(TABLES.repeat, turn);
      state = state < 7 ? 8 : 11;
    } else if (range.bit(TABLES.long + (state << 4) + turn)) {
      length = range.length(TABLES.repeat, turn);
      state = state < 7 ? 8 : 11;
    } else {
      length = 1;
      state = state < 7 ? 9 : 11;
    }
    const from = at - last[0] - 1;
    for (let i = 0; i < length; i += 1) out[at + i] = out[from + i];
    at += length;
  }
  return out;
}

/** A byte, after a match by the byte that would have gone on with it. */
function literal(range, place, matched) {
  let symbol = 1;
  let byte = matched;
  while (matched >= 0 && symbol < 0x100) {
    const wanted = (byte >> 7) & 1;
    byte <<= 1;
    const bit = range.bit(place + ((1 + wanted) << 8) + symbol);
    symbol = (symbol << 1) | bit;
    if (bit !== wanted) break;
  }
  return range.walk(place, symbol, 0x100) & 0xff;
}
