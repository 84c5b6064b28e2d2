// Runs the generator, a WASI command: one instance for each request, JSON in, JSON out.
"use strict";

const SUCCESS = 0;
const NOT_SUPPORTED = 58;
const IN = 0;

let module = null;

/** The answer to a request, or a fault. */
async function run(request) {
  const input = new TextEncoder().encode(request);
  const written = [[], [], []];
  let read = 0;
  let memory = null;
  const view = () => new DataView(memory.buffer);
  const buffers = (at, count) => Array.from({ length: count }, (_, i) => {
    const start = view().getUint32(at + 8 * i, true);
    return new Uint8Array(memory.buffer, start, view().getUint32(at + 8 * i + 4, true));
  });
  const known = {
    fd_read(fd, at, count, result) {
      let moved = 0;
      for (const buffer of fd === IN ? buffers(at, count) : []) {
        const part = input.subarray(read, read + buffer.length);
        buffer.set(part);
        read += part.length;
        moved += part.length;
      }
      view().setUint32(result, moved, true);
      return SUCCESS;
    },
    fd_write(fd, at, count, result) {
      let moved = 0;
      for (const buffer of buffers(at, count)) {
        written[fd].push(buffer.slice());
        moved += buffer.length;
      }
      view().setUint32(result, moved, true);
      return SUCCESS;
    },
    environ_sizes_get(count, size) {
      view().setUint32(count, 0, true);
      view().setUint32(size, 0, true);
      return SUCCESS;
    },
    environ_get: () => SUCCESS,
    // Hash tables take their seed from here; the answer depends on none.
    random_get: () => SUCCESS,
    proc_exit(code) {
      throw new Error(`exit ${code}`);
    },
  };
  const imports = {};
  for (const { module: from, name } of WebAssembly.Module.imports(module)) {
    imports[from] ??= {};
    imports[from][name] = known[name] ?? (() => NOT_SUPPORTED);
  }
  const text = async (fd) => new Blob(written[fd]).text();
  const instance = await WebAssembly.instantiate(module, imports);
  memory = instance.exports.memory;
  try {
    instance.exports._start();
    return await text(1);
  } catch (error) {
    return JSON.stringify({ fault: `${error.message}\n${await text(2)}` });
  }
}

onmessage = async ({ data }) => {
  if (data.bytes) {
    module = await WebAssembly.compile(data.bytes);
    return;
  }
  while (!module) await new Promise((done) => setTimeout(done, 5));
  postMessage({ id: data.id, answer: await run(data.request) });
};
