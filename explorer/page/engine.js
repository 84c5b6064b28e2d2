// The generator in a worker: the newest request is answered, older ones are dropped.

/** Longest time for an answer, in ms. */
const LIMIT = 20000;

const text = (id) => document.getElementById(id).textContent;

async function unpacked(base64) {
  const bytes = Uint8Array.from(atob(base64), (c) => c.charCodeAt(0));
  const stream = new Blob([bytes]).stream().pipeThrough(new DecompressionStream("gzip"));
  return new Response(stream).arrayBuffer();
}

/** Answers requests: `ask(request)`, `onanswer(answer, request)`. */
export class Engine {
  #bytes = unpacked(text("engine"));
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
    const bytes = await this.#bytes;
    const url = URL.createObjectURL(new Blob([text("worker")], { type: "text/javascript" }));
    this.#worker = new Worker(url);
    URL.revokeObjectURL(url);
    this.#worker.onmessage = ({ data }) => this.#end(JSON.parse(data.answer));
    this.#worker.onerror = (event) => this.#end({ fault: event.message });
    this.#worker.postMessage({ bytes });
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
