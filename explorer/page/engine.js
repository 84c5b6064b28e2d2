// The generator in a worker: the newest request is answered, older ones are dropped.

/** Longest time for an answer, in ms. */
const LIMIT = 20000;

const text = (id) => document.getElementById(id).textContent;

const bytes = (id) => Uint8Array.from(atob(text(id)), (c) => c.charCodeAt(0));

async function gunzipped(packed) {
  const stream = new Blob([packed]).stream().pipeThrough(new DecompressionStream("gzip"));
  return new Response(stream).arrayBuffer();
}

/** Answers requests: `ask(request)`, `onanswer(answer, request)`. */
export class Engine {
  #unpack = gunzipped(bytes("unpack"));
  #worker = null;
  #running = null;
  #next = null;
  #timer = 0;

  constructor(onanswer) {
    this.onanswer = onanswer;
  }

  ask(request) {
    this.#next = request;
    if (!this.#running) this.#send();
  }

  get idle() {
    return !this.#running && !this.#next;
  }

  async #send() {
    const request = this.#next;
    this.#running = request;
    this.#next = null;
    if (!this.#worker) await this.#start();
    this.#timer = setTimeout(() => this.#stop(), LIMIT);
    this.#worker.postMessage({ request: JSON.stringify(request) });
  }

  async #start() {
    const unpack = await this.#unpack;
    const url = URL.createObjectURL(new Blob([text("worker")], { type: "text/javascript" }));
    this.#worker = new Worker(url);
    URL.revokeObjectURL(url);
    this.#worker.onmessage = ({ data }) => this.#end(JSON.parse(data.answer));
    this.#worker.onerror = (event) => this.#end({ fault: event.message });
    this.#worker.postMessage({ unpack, packed: bytes("engine") });
  }

  #stop() {
    this.#worker.terminate();
    this.#worker = null;
    const seconds = LIMIT / 1000;
    this.#end({ fault: `no answer within ${seconds} s. The command has no such limit.` });
  }

  #end(answer) {
    clearTimeout(this.#timer);
    const request = this.#running;
    this.#running = null;
    if (this.#next) this.#send();
    this.onanswer(answer, request);
  }
}
