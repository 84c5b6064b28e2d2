// Runs the generator that `unpack.js` and `restore.js` before it unpack: a WASI command, an instance for each request.

const SUCCESS = 0;
const NOT_SUPPORTED = 58;
const IN = 0;

/** The promise of the generator. */
let engine = null;

/** What a command writes for its input, as a Blob; an error with what it complains of. */
async function run(module, input) {
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
  const instance = await WebAssembly.instantiate(module, imports);
  memory = instance.exports.memory;
  try {
    instance.exports._start();
  } catch (error) {
    throw new Error(`${error.message}\n${await new Blob(written[2]).text()}`);
  }
  return new Blob(written[1]);
}

/** The bytes of a text in base64. */
function bytes(text) {
  if (Uint8Array.fromBase64) return Uint8Array.fromBase64(text);
  const letters = atob(text);
  const all = new Uint8Array(letters.length);
  for (let i = 0; i < all.length; i += 1) all[i] = letters.charCodeAt(i);
  return all;
}

/** The generator from what is packed. */
async function generator(packed) {
  return WebAssembly.compile(restored(unpacked(bytes(packed))));
}

/** The answer to a request, or a fault. */
async function answer(request) {
  try {
    const text = await run(await engine, new TextEncoder().encode(request));
    return await text.text();
  } catch (error) {
    return JSON.stringify({ fault: error.message });
  }
}

onmessage = async ({ data }) => {
  if (data.packed) engine = generator(data.packed);
  else postMessage({ id: data.id, answer: await answer(data.request) });
};
