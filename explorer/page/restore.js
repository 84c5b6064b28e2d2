// Restores a module of WebAssembly whose bytes are sorted by what they are, as `build/src/sorted` sorts them.

const [OUTSIDE, OPCODE, BLOCK, BRANCH, CALL, GET, SET, ALIGN, LOAD, STORE, INT32, INT64, FLOAT, OTHER] = Array(14).keys();
const STREAMS = 14;
const CODE = 10;

/** Numbers that follow an opcode, as the stream that holds them and how many there are. */
const NUMBERS = {
  0x0c: [BRANCH, 1], 0x0d: [BRANCH, 1], 0x10: [CALL, 1], 0x11: [OTHER, 2], 0x20: [GET, 1], 0x21: [SET, 1], 0x22: [SET, 1],
  0x23: [OTHER, 1], 0x24: [OTHER, 1], 0x25: [OTHER, 1], 0x26: [OTHER, 1], 0x3f: [OTHER, 1], 0x40: [OTHER, 1], 0x41: [INT32, 1],
  0x42: [INT64, 1], 0xd0: [OTHER, 1], 0xd2: [OTHER, 1],
};
/** Numbers after the second part of an opcode that begins with 0xfc, from 8 on. */
const FURTHER = [2, 1, 2, 1, 2, 1, 2, 1, 1, 1];
/** Alignments of loads and stores by default, from 0x28 on. */
const ALIGNED = [2, 3, 2, 3, 0, 0, 1, 1, 0, 0, 1, 1, 2, 2, 2, 3, 2, 3, 0, 1, 0, 1, 2];

class Restorer {
  constructor(sorted) {
    const lengths = new DataView(sorted.buffer, sorted.byteOffset);
    this.sorted = sorted;
    // Sizes of functions are not among the sorted bytes: a module has as many bytes again for them at most.
    this.module = new Uint8Array(2 * sorted.length);
    this.to = 0;
    this.from = [];
    let at = 4 * STREAMS;
    for (let i = 0; i < STREAMS; i += 1) {
      this.from.push(at);
      at += lengths.getUint32(4 * i, true);
    }
    this.end = this.from[OUTSIDE + 1];
  }

  byte(stream, by = 0) {
    const byte = this.sorted[this.from[stream]] ^ by;
    this.from[stream] += 1;
    this.module[this.to] = byte;
    this.to += 1;
    return byte;
  }

  number(stream) {
    let [all, scale] = [0, 1];
    for (;;) {
      const byte = this.byte(stream);
      all += (byte & 0x7f) * scale;
      if (byte < 0x80) return all;
      scale *= 0x80;
    }
  }

  /** Numbers whose values do not matter here. */
  numbers(stream, count) {
    const { sorted, module, from } = this;
    for (let left = count; left > 0; ) {
      const byte = sorted[from[stream]];
      from[stream] += 1;
      module[this.to] = byte;
      this.to += 1;
      if (byte < 0x80) left -= 1;
    }
  }

  /** A function: its size, its locals, its instructions up to the end of its block. */
  body() {
    const start = this.to;
    for (let count = this.number(OTHER); count > 0; count -= 1) {
      this.number(OTHER);
      this.byte(OTHER);
    }
    let depth = 1;
    while (depth > 0) {
      const opcode = this.byte(OPCODE);
      if (opcode >= 0x02 && opcode <= 0x04) {
        this.numbers(BLOCK, 1);
        depth += 1;
      } else if (opcode === 0x0b) depth -= 1;
      else this.operands(opcode);
    }
    this.size(start);
  }

  operands(opcode) {
    if (opcode >= 0x28 && opcode <= 0x3e) {
      this.byte(ALIGN, ALIGNED[opcode - 0x28]);
      this.numbers(opcode < 0x36 ? LOAD : STORE, 1);
    } else if (opcode === 0x0e) this.numbers(BRANCH, this.number(BRANCH) + 1);
    else if (opcode === 0x43 || opcode === 0x44) for (let i = opcode === 0x43 ? 4 : 8; i > 0; i -= 1) this.byte(FLOAT);
    else if (opcode === 0xfc) this.numbers(OTHER, FURTHER[this.number(OTHER) - 8] ?? 0);
    else if (NUMBERS[opcode]) this.numbers(NUMBERS[opcode][0], NUMBERS[opcode][1]);
  }

  /** Puts the size of what was written from a place on before it. */
  size(start) {
    const number = [];
    for (let left = this.to - start; ; left = Math.floor(left / 0x80)) {
      number.push(left < 0x80 ? left : (left % 0x80) | 0x80);
      if (left < 0x80) break;
    }
    this.module.copyWithin(start + number.length, start, this.to);
    this.module.set(number, start);
    this.to += number.length;
  }
}

/** The module of which the bytes were sorted. */
function restored(sorted) {
  const own = new Restorer(sorted);
  for (let i = 0; i < 8; i += 1) own.byte(OUTSIDE);
  while (own.from[OUTSIDE] < own.end) {
    const section = own.byte(OUTSIDE);
    const size = own.number(OUTSIDE);
    if (section === CODE) for (let count = own.number(OUTSIDE); count > 0; count -= 1) own.body();
    else for (let i = 0; i < size; i += 1) own.byte(OUTSIDE);
  }
  return own.module.subarray(0, own.to);
}
